// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

namespace anvil {

std::string duration_text(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

namespace {

std::string position_text(const RunPosition& position) {
  const double left = position.wall_seconds * (1.0 - position.fraction) / std::max(position.fraction, 1e-12);
  // Before a percent is done the estimate is a guess about the first steps.
  const bool known = position.fraction > 0.01;
  return fmt::format("step {}  t {:.4g} s  dt {:.3g} s  {}", position.step, position.time, position.time_step,
                     known ? duration_text(left) + " left" : "");
}

class Silence : public Progress {
 public:
  void show(const RunPosition&) override {}
};

class Lines : public Progress {
 public:
  void show(const RunPosition& position) override {
    const int tenth = static_cast<int>(position.fraction * 10.0);
    if (tenth == last_tenth_ && position.wall_seconds < last_seconds_ + 5.0) return;
    last_tenth_ = tenth;
    last_seconds_ = position.wall_seconds;
    fmt::print(stderr, "{:3.0f} %  {}\n", 100.0 * position.fraction, position_text(position));
  }

 private:
  int last_tenth_ = 0;
  double last_seconds_ = 0.0;
};

class Bar : public Progress {
 public:
  ~Bar() override {
    if (drawn_) fmt::print(stderr, "\n");
  }
  void show(const RunPosition& position) override {
    if (position.wall_seconds < last_seconds_ + 0.1 && position.fraction < 1.0) return;
    last_seconds_ = position.wall_seconds;
    constexpr int width = 30;
    const int filled = static_cast<int>(position.fraction * width);
    constexpr const char* clear_to_end_of_line = "\x1b[K";
    fmt::print(stderr, "\r{:3.0f} % [{:=<{}}{:{}}] {}{}", 100.0 * position.fraction, "", filled, "", width - filled,
               position_text(position), clear_to_end_of_line);
    std::fflush(stderr);
    drawn_ = true;
  }

 private:
  double last_seconds_ = -1.0;
  bool drawn_ = false;
};

}  // namespace

std::unique_ptr<Progress> make_progress(bool quiet) {
  if (quiet) return std::make_unique<Silence>();
  if (isatty(STDERR_FILENO) == 1) return std::make_unique<Bar>();
  return std::make_unique<Lines>();
}

}  // namespace anvil
