// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>

#include "anvil/pairs/records.hpp"
#include "anvil/pairs/tile.hpp"

namespace anvil {

/// Changes velocities after the kick, from those of the neighbours. One virtual call serves a whole tile.
template <int D>
class VelocityFilter {
 public:
  VelocityFilter() = default;
  VelocityFilter(const VelocityFilter&) = delete;
  VelocityFilter& operator=(const VelocityFilter&) = delete;
  virtual ~VelocityFilter() = default;

  [[nodiscard]] virtual std::string_view name() const = 0;
  [[nodiscard]] virtual std::string_view purpose() const = 0;
  [[nodiscard]] virtual PairNeeds needs() const = 0;
  /// Writes the change of velocity, D per particle of the tile, m/s; time_step in s.
  virtual void change(const PairTile<D>& tile, const PairRecords<D>& records, double time_step,
                      double* change) const = 0;
};

}  // namespace anvil
