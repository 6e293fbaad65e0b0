// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "anvil/scene/key.hpp"

namespace anvil {

/// A pressure over time, p(t) in Pa from t = 0 on.
class LoadHistory {
 public:
  LoadHistory() = default;
  LoadHistory(const LoadHistory&) = delete;
  LoadHistory& operator=(const LoadHistory&) = delete;
  virtual ~LoadHistory() = default;

  /// Integral of p from 0 to `time` (s), Pa s: a solver that takes differences of it gives the whole impulse of the
  /// history whatever its time steps.
  [[nodiscard]] virtual double impulse(double time) const = 0;
};

/// The kind `pressure` of boundaries.
EntryKind pressure_kind();

/// Throws InputError when a key that the history needs is missing, when one is there that it does not know, and when a
/// table falls back in time.
std::unique_ptr<LoadHistory> make_load_history(const Parameters& parameters);

/// A pressure on one face of a line of particles.
struct PressureLoad {
  std::size_t particle;  // the outermost one at that face
  double inward;         // +1 on a left face, -1 on a right one
  std::shared_ptr<const LoadHistory> history;
};

}  // namespace anvil
