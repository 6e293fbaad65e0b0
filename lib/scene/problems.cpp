// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/problems.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "anvil/core/error.hpp"

namespace anvil {

void Problems::add(Place place, std::string sentence) { found_.push_back({std::move(place), std::move(sentence)}); }

void Problems::throw_if_any() const {
  if (found_.empty()) return;
  auto sorted = found_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.place < b.place; });
  std::string message;
  for (const auto& [place, sentence] : sorted) {
    if (!message.empty()) message += '\n';
    message += place.line == 0 ? fmt::format("{}: {}", place.file, sentence)
                               : fmt::format("{}:{}:{}: {}", place.file, place.line, place.column, sentence);
  }
  throw InputError(message);
}

}  // namespace anvil
