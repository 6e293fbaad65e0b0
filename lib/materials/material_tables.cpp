// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/materials/material_tables.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

template <class Table>
struct TableOf;

/// What a variant of laws gives as a table: the kinds of all laws, and the law made from an entry.
template <class... Laws>
struct TableOf<std::variant<Laws...>> {
  static std::span<const EntryKind> kinds() {
    static const std::array<EntryKind, sizeof...(Laws)> all = {Laws::kind()...};
    return all;
  }

  static std::array<std::string_view, sizeof...(Laws)> names() { return {Laws::kind().type...}; }

  template <class... Arguments>
  static std::variant<Laws...> make(std::string_view what, const TypedEntry& entry, Arguments... arguments) {
    std::optional<std::variant<Laws...>> made;
    const auto make_if_named = [&]<class Law>(std::in_place_type_t<Law> law) {
      if (Law::kind().type == entry.type) made.emplace(law, entry.parameters, arguments...);
    };
    (make_if_named(std::in_place_type<Laws>), ...);
    if (made) return *made;
    throw InputError(fmt::format("no {} is named '{}'; choose one of: {}", what, entry.type, fmt::join(names(), ", ")));
  }
};

template <class... Laws>
constexpr bool all_are_equations_of_state(std::in_place_type_t<std::variant<Laws...>>) {
  return (EquationOfState<Laws> && ...);
}
template <class... Laws>
constexpr bool all_are_strength_laws(std::in_place_type_t<std::variant<Laws...>>) {
  return (StrengthLaw<Laws> && ...);
}
static_assert(all_are_equations_of_state(std::in_place_type<Eos>));
static_assert(all_are_strength_laws(std::in_place_type<Strength>));

}  // namespace

std::span<const EntryKind> eos_kinds() { return TableOf<Eos>::kinds(); }
std::span<const EntryKind> strength_kinds() { return TableOf<Strength>::kinds(); }

Eos make_eos(const TypedEntry& entry, double reference_density) {
  return TableOf<Eos>::make("equation of state", entry, reference_density);
}
Strength make_strength(const TypedEntry& entry) { return TableOf<Strength>::make("strength law", entry); }

}  // namespace anvil
