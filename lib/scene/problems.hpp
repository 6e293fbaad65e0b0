// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace anvil {

/// Where something stands in what a user wrote; line 0 stands for no line in particular.
struct Place {
  std::string file;  // or the whole `--set KEY=VALUE`
  unsigned line = 0;
  unsigned column = 0;

  auto operator<=>(const Place&) const = default;
};

/// Collects what is wrong, so that a user sees all of it at once.
class Problems {
 public:
  void add(Place place, std::string sentence);
  [[nodiscard]] bool empty() const { return found_.empty(); }

  /// Throws an InputError with one line for each problem, in the order of their places. Does nothing when there is
  /// none.
  void throw_if_any() const;

 private:
  struct Problem {
    Place place;
    std::string sentence;
  };
  std::vector<Problem> found_;
};

}  // namespace anvil
