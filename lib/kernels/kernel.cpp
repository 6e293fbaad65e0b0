// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/kernels/kernel.hpp"

#include <fmt/format.h>

#include <array>
#include <cstddef>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr std::size_t kernel_count = std::variant_size_v<Kernel>;

template <std::size_t... I>
constexpr std::array<std::string_view, kernel_count> collect_names(std::index_sequence<I...>) {
  return {std::variant_alternative_t<I, Kernel>::name...};
}

template <std::size_t... I>
std::array<Kernel, kernel_count> make_all(std::index_sequence<I...>) {
  return {Kernel(std::in_place_index<I>)...};
}

constexpr std::array<std::string_view, kernel_count> names = collect_names(std::make_index_sequence<kernel_count>{});

}  // namespace

Kernel make_kernel(std::string_view name) {
  for (std::size_t i = 0; i < kernel_count; ++i) {
    if (names[i] == name) return make_all(std::make_index_sequence<kernel_count>{})[i];
  }
  throw InputError(fmt::format("no kernel is named '{}'; choose one of: {}", name, fmt::join(names, ", ")));
}

std::span<const std::string_view> kernel_names() { return names; }

std::string_view kernel_summary(std::string_view name) {
  return std::visit([](const auto& kernel) { return std::string_view(kernel.summary); }, make_kernel(name));
}

}  // namespace anvil
