// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

#include "anvil/pairs/records.hpp"

namespace anvil {

/// One field per array; entry `particles` of each is the padding of the list.
struct Arrays {
  const double *x, *y, *z, *smoothing_length, *velocity_x, *velocity_y, *velocity_z, *volume;
};

/// Rows first[i] .. first[i + 1] of the padded list.
struct Rows {
  std::int32_t particles;
  const std::int64_t* first;
  const std::int32_t* neighbour;
};

/// Position, smoothing length, velocity, volume.
using WideRecords = Records<8>;

/// Layouts that need vectors, compiled once per instruction set. `out` takes the velocity gradient, 9 per particle.
struct VectorLayouts {
  void (*gathers)(const Rows&, const Arrays&, double* out);
  void (*packed_fused)(const Rows&, const WideRecords&, double* out);
};

}  // namespace anvil
