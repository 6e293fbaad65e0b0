// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/core/particle_range.hpp"
#include "anvil/pairs/records.hpp"
#include "anvil/pairs/tile.hpp"

namespace anvil {

/// One sum over pairs that accelerates particles. A term is made with the field store: it requires the fields it reads
/// and keeps the views, so that a scene without the term has neither. One virtual call serves a whole tile.
template <int D>
class ForceTerm {
 public:
  ForceTerm() = default;
  ForceTerm(const ForceTerm&) = delete;
  ForceTerm& operator=(const ForceTerm&) = delete;
  virtual ~ForceTerm() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  [[nodiscard]] virtual PairNeeds needs() const = 0;
  /// Writes what the term reads of neighbours into its record; called when stress and density of the range are new.
  virtual void pack(ParticleRange range, PairRecords<D>& records) const = 0;
  /// Adds to acceleration (D per particle of the tile, m/s2) and to loss (per particle of the tile, W/kg: the rate at
  /// which the term turns motion into heat).
  virtual void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                          double* loss) const = 0;
  /// Adds to the velocity gradients of the range (D x D per particle of it, 1/s) what the term's pairs know beyond the
  /// mean of their velocities.
  virtual void refine_gradients(ParticleRange /*range*/, double* /*velocity_gradient*/) const {}
};

}  // namespace anvil
