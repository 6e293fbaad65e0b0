// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <variant>

#include "anvil/materials/eos/equation_of_state.hpp"
#include "anvil/materials/eos/linear.hpp"
#include "anvil/materials/eos/mie_grueneisen.hpp"
#include "anvil/materials/eos/stiffened_gas.hpp"
#include "anvil/materials/eos/tait.hpp"
#include "anvil/materials/strength/drucker_prager.hpp"
#include "anvil/materials/strength/elastic.hpp"
#include "anvil/materials/strength/j2.hpp"
#include "anvil/materials/strength/no_strength.hpp"
#include "anvil/materials/strength/strength_law.hpp"
#include "anvil/materials/strength/voce.hpp"
#include "anvil/scene/key.hpp"

namespace anvil {

// The tables of laws. The scene's keys, `anvil list`, the factories and the property tests are all made from them.
// To be visited once per range of particles, never per particle.
using Eos = std::variant<LinearEos, TaitEos, StiffenedGas, MieGrueneisen>;
using Strength = std::variant<NoStrength, Elastic, J2, Voce, DruckerPrager>;

/// Whether the pressure of the law depends on the specific internal energy.
inline bool uses_energy(const Eos& law) {
  return std::visit([]<class Law>(const Law&) { return Law::uses_energy; }, law);
}

/// Name, summary and keys of each law, in the order of its table.
std::span<const EntryKind> eos_kinds();
std::span<const EntryKind> strength_kinds();

/// The law named by `entry.type`, with its validated keys; `reference_density` in kg/m3, positive. Throws InputError
/// when no law has that name or a key is missing.
Eos make_eos(const TypedEntry& entry, double reference_density);
Strength make_strength(const TypedEntry& entry);

}  // namespace anvil
