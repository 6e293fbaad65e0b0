// SPDX-License-Identifier: BSD-3-Clause
#include "progress.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

namespace anvil {

std::string duration_text(double seconds) {
  const auto whole = std::llround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{}:{:02} min", whole / 60, whole % 60);
  return fmt::format("{}:{:02} h", whole / 3600, whole / 60 % 60);
}

namespace {

std::string time_left(double fraction, double wall_seconds) {
  // Before a percent is done the estimate is a guess about the first steps.
  if (fraction <= 0.01) return "";
  return duration_text(wall_seconds * (1.0 - fraction) / fraction) + " left";
}

std::string position_text(const RunPosition& position) {
  return fmt::format("step {}  t {:.4g} s  dt {:.3g} s  {}", position.step, position.time, position.time_step,
                     time_left(position.fraction, position.wall_seconds));
}

class Silence : public ProgressPainter {
 public:
  void paint(double, double, const std::string&) override {}
};

class Lines : public ProgressPainter {
 public:
  void paint(double fraction, double wall_seconds, const std::string& text) override {
    const int tenth = static_cast<int>(fraction * 10.0);
    if (tenth == last_tenth_ && wall_seconds < last_seconds_ + 5.0) return;
    last_tenth_ = tenth;
    last_seconds_ = wall_seconds;
    fmt::print(stderr, "{:3.0f} %  {}\n", 100.0 * fraction, text);
  }

 private:
  int last_tenth_ = 0;
  double last_seconds_ = 0.0;
};

class Bar : public ProgressPainter {
 public:
  ~Bar() override {
    if (drawn_) fmt::print(stderr, "\n");
  }
  void paint(double fraction, double wall_seconds, const std::string& text) override {
    if (wall_seconds < last_seconds_ + 0.1 && fraction < 1.0) return;
    last_seconds_ = wall_seconds;
    constexpr int width = 30;
    const int filled = static_cast<int>(fraction * width);
    constexpr const char* clear_to_end_of_line = "\x1b[K";
    fmt::print(stderr, "\r{:3.0f} % [{:=<{}}{:{}}] {}{}", 100.0 * fraction, "", filled, "", width - filled, text,
               clear_to_end_of_line);
    std::fflush(stderr);
    drawn_ = true;
  }

 private:
  double last_seconds_ = -1.0;
  bool drawn_ = false;
};

std::unique_ptr<ProgressPainter> make_painter(bool quiet) {
  if (quiet) return std::make_unique<Silence>();
  if (isatty(STDERR_FILENO) == 1) return std::make_unique<Bar>();
  return std::make_unique<Lines>();
}

class RunProgress : public Progress {
 public:
  explicit RunProgress(bool quiet) : painter_(make_painter(quiet)) {}
  void show(const RunPosition& position) override {
    painter_->paint(position.fraction, position.wall_seconds, position_text(position));
  }

 private:
  std::unique_ptr<ProgressPainter> painter_;
};

}  // namespace

PieceProgress::PieceProgress(std::string what, std::size_t count, bool quiet)
    : what_(std::move(what)), count_(count), painter_(make_painter(quiet)) {}

void PieceProgress::show(std::size_t done) {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const double fraction = static_cast<double>(done) / static_cast<double>(count_);
  painter_->paint(fraction, seconds, fmt::format("{} {} of {}  {}", what_, done, count_, time_left(fraction, seconds)));
}

std::unique_ptr<Progress> make_progress(bool quiet) { return std::make_unique<RunProgress>(quiet); }

}  // namespace anvil
