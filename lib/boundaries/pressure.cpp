// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/pressure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

/// p = value up to `duration`, zero afterwards.
class Rectangular final : public LoadHistory {
 public:
  Rectangular(double value, double duration) : value_(value), duration_(duration) {}
  [[nodiscard]] double impulse(double time) const override { return value_ * std::clamp(time, 0.0, duration_); }

 private:
  double value_, duration_;
};

/// p = value exp(-t / decay).
class Exponential final : public LoadHistory {
 public:
  Exponential(double value, double decay) : value_(value), decay_(decay) {}
  [[nodiscard]] double impulse(double time) const override { return -value_ * decay_ * std::expm1(-time / decay_); }

 private:
  double value_, decay_;
};

/// p = value sin(pi t / duration) up to `duration`, zero afterwards.
class HalfSine final : public LoadHistory {
 public:
  HalfSine(double value, double duration) : value_(value), duration_(duration) {}
  [[nodiscard]] double impulse(double time) const override {
    const double sine = std::sin(0.5 * std::numbers::pi * std::clamp(time, 0.0, duration_) / duration_);
    return value_ * duration_ / std::numbers::pi * 2.0 * sine * sine;
  }

 private:
  double value_, duration_;
};

/// Straight between the points of a table, zero before and behind it.
class Tabulated final : public LoadHistory {
 public:
  explicit Tabulated(const Points& table) : table_(table) {}
  [[nodiscard]] double impulse(double time) const override {
    double sum = 0.0;
    for (std::size_t k = 1; k < table_.size(); ++k) {
      if (table_[k - 1][0] == table_[k][0]) continue;  // a jump
      const double begin = table_[k - 1][0], end = table_[k][0], from = table_[k - 1][1], to = table_[k][1];
      const double part = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
      sum += (end - begin) * part * (from + 0.5 * part * (to - from));
    }
    return sum;
  }

 private:
  Points table_;
};

void check_table(const Points& table) {
  const bool rising = table.size() > 1 && table[0].size() == 2 && table[0][0] >= 0.0 &&
                      std::adjacent_find(table.begin(), table.end(),
                                         [](const auto& a, const auto& b) { return !(a[0] <= b[0]); }) == table.end();
  if (!rising)
    throw InputError(
        "the table of a pressure must hold two or more pairs [time in s, pressure in Pa] whose times begin at 0 or "
        "later and never fall");
}

}  // namespace

EntryKind pressure_kind() {
  return {
      .type = "pressure",
      .summary = "A pressure over time on one end of a body",
      .keys =
          {{.name = "body", .kind = ValueKind::name, .help = "name of the body it acts on"},
           {.name = "face",
            .kind = ValueKind::choice,
            .standard = "left",
            .help = "end of the body: left is the one with the smallest coordinate",
            .choices = {"left", "right"}},
           {.name = "history",
            .kind = ValueKind::choice,
            .standard = "rectangular",
            .help = "rectangular: `value` for the `duration`; exponential: `value` exp(-t/`decay`); half_sine: `value` "
                    "sin(pi t/`duration`) for the `duration`; tabulated: straight between the points of `table`",
            .choices = {"rectangular", "exponential", "half_sine", "tabulated"}},
           {.name = "value", .unit = "Pa", .help = "pressure, or its largest value", .optional = true},
           {.name = "duration", .unit = "s", .range = Range::positive, .help = "how long it acts", .optional = true},
           {.name = "decay",
            .unit = "s",
            .range = Range::positive,
            .help = "time in which it falls to 1/e",
            .optional = true},
           {.name = "table",
            .kind = ValueKind::points,
            .help = "[time in s, pressure in Pa] pairs; zero before the first and behind the last",
            .optional = true}},
      .dimensions = {1}};
}

std::unique_ptr<LoadHistory> make_load_history(const Parameters& parameters) {
  const std::string& history = parameters.text("history");
  const std::vector<std::string> needed = history == "tabulated"     ? std::vector<std::string>{"table"}
                                          : history == "exponential" ? std::vector<std::string>{"value", "decay"}
                                                                     : std::vector<std::string>{"value", "duration"};
  for (const std::string key : {"value", "duration", "decay", "table"}) {
    const bool wanted = std::find(needed.begin(), needed.end(), key) != needed.end();
    if (wanted && !parameters.has(key))
      throw InputError(fmt::format("the history {} needs the key '{}'", history, key));
    if (!wanted && parameters.has(key)) throw InputError(fmt::format("the history {} has no key '{}'", history, key));
  }
  if (history == "tabulated") {
    check_table(parameters.points("table"));
    return std::make_unique<Tabulated>(parameters.points("table"));
  }
  const double value = parameters.number("value");
  if (history == "exponential") return std::make_unique<Exponential>(value, parameters.number("decay"));
  if (history == "half_sine") return std::make_unique<HalfSine>(value, parameters.number("duration"));
  return std::make_unique<Rectangular>(value, parameters.number("duration"));
}

}  // namespace anvil
