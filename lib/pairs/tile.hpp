// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace anvil {

/// What pair terms ask the tile to hold beside the gradients.
struct PairNeeds {
  bool gradient = false;        // of the scene's method: corrected where it corrects
  bool plain_gradient = false;  // as the kernel gives it
  bool value = false;           // W_ij
  bool medium = false;          // the record of sound speed, density and mass
  bool response = false;        // the record of pressure, wave speeds and yield
  bool slope = false;           // the record of slopes
  bool correction = false;      // the record of the correction of gradients
  bool nominal = false;         // the record of nominal stress instead of that of traction
};

/// A run of particles small enough that their pairs stay in the cache while several terms work on them. Pair k of the
/// tile belongs to the particle i with first[i] <= begin_pair + k < first[i + 1].
template <int D>
struct PairTile {
  std::int32_t begin = 0, end = 0;          // particles
  const std::int64_t* first = nullptr;      // by particle: its first pair in the list
  const std::int32_t* neighbour = nullptr;  // the whole list
  // grad_i W_ij by component, 1/m^(D+1), from pair first[begin]. Without a correction, or when nobody asks for the
  // plain ones, both are the same memory.
  std::array<double*, D> plain_gradient{}, gradient{};
  double* value = nullptr;       // W_ij, 1/m^D; from pair first[begin]
  double* correction = nullptr;  // if wanted: A_i^-1, symmetric and packed, per particle of the tile
  int uncorrected = 0;           // particles whose gradients could not be corrected
};

}  // namespace anvil
