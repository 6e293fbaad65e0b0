// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "anvil/kernels/kernel.hpp"
#include "anvil/pairs/records.hpp"
#include "anvil/pairs/tile.hpp"
#include "anvil/terms/coefficients.hpp"

namespace anvil {

/// Particles in the order of the cell grid, one array per coordinate: what the neighbour search runs over.
template <int D>
struct Candidates {
  std::array<const double*, D> position;
  const double* smoothing_length;
  const std::int32_t* particle;
};

/// The loops over pairs, as compiled for one instruction set. The table is all that crosses between the parts of the
/// program compiled for this machine and the parts that run on any.
template <int D>
struct PairLoops {
  using Fill = void (*)(const PairTile<D>&, const PairRecords<D>&);
  struct KernelLoops {
    Fill gradients, values, both;
    // Several passes in one, where there is such a loop: in one dimension. They return how many particles kept plain
    // gradients.
    int (*corrected_gradients)(const PairTile<D>&, const PairRecords<D>&) = nullptr;
    int (*corrected_velocity_gradient)(const PairTile<D>&, const PairRecords<D>&, double* out) = nullptr;
  };

  int lanes;  // rows of the neighbour list are padded to a multiple of it
  std::array<KernelLoops, std::variant_size_v<Kernel>> kernels;  // by Kernel::index()
  /// Appends to `out` the candidates begin .. end-1 nearer to `self` than reach (h_self + h_other)/2 + skin, self
  /// itself left out; returns how many. `out` has room for all of them and `lanes` more.
  int (*collect)(const Candidates<D>&, std::int64_t begin, std::int64_t end, std::int64_t self, double reach,
                 double skin, std::int32_t* out);
  int (*correct_gradients)(const PairTile<D>&, const PairRecords<D>&);
  void (*velocity_gradient)(const PairTile<D>&, const PairRecords<D>&, double* out);
  void (*momentum)(const PairTile<D>&, const PairRecords<D>&, const double* divisor, double* acceleration);
  void (*stress_difference)(const PairTile<D>&, const PairRecords<D>&, const double* divisor, double* acceleration);
  void (*nominal_momentum)(const PairTile<D>&, const PairRecords<D>&, double* acceleration);
  void (*viscosity)(const PairTile<D>&, const PairRecords<D>&, const ViscosityCoefficients&, double* acceleration,
                    double* heating);
  void (*laminar_viscosity)(const PairTile<D>&, const PairRecords<D>&, double* acceleration, double* heating);
  void (*density_diffusion)(const PairTile<D>&, const PairRecords<D>&, double delta, const double* gravity,
                            double* rate);
  void (*hllc)(const PairTile<D>&, const PairRecords<D>&, const HllcChoices&, const HllcSums&);
  void (*plain_smoothing)(const PairTile<D>&, const PairRecords<D>&, double* change);
  void (*pairwise_smoothing)(const PairTile<D>&, const PairRecords<D>&, double* change);
};

/// The loops of the instruction set that simd_level() names.
template <int D>
const PairLoops<D>& pair_loops();

}  // namespace anvil
