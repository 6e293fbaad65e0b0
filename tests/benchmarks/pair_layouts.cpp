// SPDX-License-Identifier: BSD-3-Clause
// What the memory layout of a pair loop costs: the velocity gradient of a jittered lattice with some 52 neighbours, by
// five layouts of the same sum. Argument: the skin of the neighbour list in hundredths of the spacing. Instruction set:
// the one the library chooses (ANVIL_SIMD asks for another). Every layout is checked against the first.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "anvil/core/simd_level.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/pairs/neighbour_list.hpp"
#include "anvil/pairs/pair_loops.hpp"
#include "benchmarks/pair_layouts_level.hpp"

namespace anvil {
#define ANVIL_DECLARE_LAYOUTS(level)         \
  namespace level {                          \
  extern const VectorLayouts vector_layouts; \
  }
ANVIL_DECLARE_LAYOUTS(baseline)
#ifdef ANVIL_HAS_avx2
ANVIL_DECLARE_LAYOUTS(avx2)
#endif
#ifdef ANVIL_HAS_avx512
ANVIL_DECLARE_LAYOUTS(avx512)
#endif
#undef ANVIL_DECLARE_LAYOUTS

namespace {

const VectorLayouts& vector_layouts() {
  [[maybe_unused]] const std::string level = simd_level();
#ifdef ANVIL_HAS_avx512
  if (level == "avx512") return avx512::vector_layouts;
#endif
#ifdef ANVIL_HAS_avx2
  if (level == "avx2") return avx2::vector_layouts;
#endif
  return baseline::vector_layouts;
}

constexpr std::array<int, 3> cells = {16, 16, 80};
constexpr int particles = cells[0] * cells[1] * cells[2];
constexpr double spacing = 0.4e-3;  // m
constexpr double smoothing_length = 1.2 * spacing;
constexpr std::int32_t tile_size = 64;  // as in the solver

/// The lattice in all layouts at once.
struct Lattice {
  explicit Lattice(double skin) {
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> jitter(-0.05, 0.05);
    for (auto& array : arrays) array.assign(particles + 1, 0.0);
    records.geometry.resize(particles);
    records.motion.resize(particles);
    wide.resize(particles);
    for (int i = 0; i <= particles; ++i) {
      const bool padding = i == particles;
      const std::array<int, 3> cell = {i % cells[0], i / cells[0] % cells[1], i / (cells[0] * cells[1])};
      for (std::size_t a = 0; a < 3; ++a) {
        arrays[a][at(i)] = padding ? padding_distance : spacing * (cell[a] + jitter(engine));
        arrays[a + 4][at(i)] = padding ? 0.0 : 1000.0 * jitter(engine);  // m/s
      }
      arrays[3][at(i)] = smoothing_length * (1.0 + 0.1 * jitter(engine));
      arrays[7][at(i)] = padding ? 0.0 : spacing * spacing * spacing;
      for (std::size_t f = 0; f < 8; ++f) wide[at(i)][f] = arrays[f][at(i)];
      std::copy_n(wide[at(i)], 4, records.geometry[at(i)]);
      std::copy_n(wide[at(i)] + 4, 4, records.motion[at(i)]);
    }
    std::vector<double> positions;
    for (int i = 0; i < particles; ++i) positions.insert(positions.end(), wide[at(i)], wide[at(i)] + 3);
    list.build(VectorView<3>(positions.data()), {arrays[3].data(), particles}, CubicSpline::support, skin,
               pair_loops<3>());
    list_halves();
    std::int64_t longest = 0;
    for (int i = 0; i < particles; i += tile_size)
      longest = std::max(longest, list.first()[std::min(i + tile_size, particles)] - list.first()[i]);
    for (auto& component : gradient) component.resize(static_cast<std::size_t>(longest));
  }
  void list_halves() {
    for (int i = 0; i < particles; ++i) {
      half_first.push_back(half_neighbour.size());
      for (std::int64_t k = list.first()[i]; k < list.first()[i + 1]; ++k)
        if (const int j = list.neighbours()[k]; j > i && j != particles) half_neighbour.push_back(j);
    }
    half_first.push_back(half_neighbour.size());
  }
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] Rows rows() const { return {particles, list.first(), list.neighbours()}; }

  std::array<std::vector<double>, 8> arrays;  // x y z h, velocity, volume
  WideRecords wide;
  PairRecords<3> records;
  NeighbourList<3> list;
  std::vector<std::size_t> half_first;
  std::vector<std::int32_t> half_neighbour;
  std::array<std::vector<double>, 3> gradient;  // of a tile
};

using Gradients = std::vector<double>;

/// Coefficient of x_ij in grad_ij; zero beyond the support, which plain code leaves out before the square root.
double gradient_factor(double r_squared, double h) {
  if (r_squared >= CubicSpline::support * CubicSpline::support * h * h) return 0.0;
  const double h_inverse = 1.0 / h;
  const double squared = h_inverse * h_inverse;
  return CubicSpline::normalisation(3) * squared * squared * h_inverse *
         CubicSpline::slope_over_q(std::sqrt(r_squared) * h_inverse);
}

/// Adds factor (v_j - v_i) (x_i - x_j) for one pair of the arrays.
struct ScalarPair {
  ScalarPair(const Lattice& lattice, std::size_t i, std::size_t j) {
    const auto& array = lattice.arrays;
    double r_squared = 0.0;
    for (std::size_t a = 0; a < 3; ++a) {
      x_ij[a] = array[a][i] - array[a][j];
      v_ji[a] = array[a + 4][j] - array[a + 4][i];
      r_squared += x_ij[a] * x_ij[a];
    }
    factor = gradient_factor(r_squared, 0.5 * (array[3][i] + array[3][j]));
  }
  void add(double volume, double* sum) const {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) sum[3 * a + b] += volume * factor * v_ji[a] * x_ij[b];
  }
  std::array<double, 3> x_ij{}, v_ji{};
  double factor;
};

void scalar_arrays(Lattice& lattice, Gradients& out) {
  const Rows rows = lattice.rows();
  for (int i = 0; i < particles; ++i) {
    std::array<double, 9> sum{};
    for (std::int64_t k = rows.first[i]; k < rows.first[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(rows.neighbour[k]);
      if (j == particles) break;
      const ScalarPair pair(lattice, Lattice::at(i), j);
      if (pair.factor != 0.0) pair.add(lattice.arrays[7][j], sum.data());
    }
    std::copy(sum.begin(), sum.end(), out.begin() + 9 * i);
  }
}

/// Every pair once, for both partners: half the kernels, but sums that are scattered into memory.
void symmetric_half_list(Lattice& lattice, Gradients& out) {
  std::fill(out.begin(), out.end(), 0.0);
  for (std::size_t i = 0; i < particles; ++i) {
    for (auto k = lattice.half_first[i]; k < lattice.half_first[i + 1]; ++k) {
      const auto j = static_cast<std::size_t>(lattice.half_neighbour[k]);
      const ScalarPair pair(lattice, i, j);
      if (pair.factor == 0.0) continue;
      // v_ij and x_ij change sign together.
      pair.add(lattice.arrays[7][j], out.data() + 9 * i);
      pair.add(lattice.arrays[7][i], out.data() + 9 * j);
    }
  }
}

void vector_gathers(Lattice& lattice, Gradients& out) {
  const auto& array = lattice.arrays;
  const Arrays arrays{array[0].data(), array[1].data(), array[2].data(), array[3].data(),
                      array[4].data(), array[5].data(), array[6].data(), array[7].data()};
  vector_layouts().gathers(lattice.rows(), arrays, out.data());
}

void packed_fused(Lattice& lattice, Gradients& out) {
  vector_layouts().packed_fused(lattice.rows(), lattice.wide, out.data());
}

/// What the solver does: the gradients of a tile first, then the sums of the terms.
void packed_tiles(Lattice& lattice, Gradients& out) {
  const PairLoops<3>& loops = pair_loops<3>();
  PairTile<3> tile;
  tile.first = lattice.list.first();
  tile.neighbour = lattice.list.neighbours();
  for (std::size_t a = 0; a < 3; ++a) tile.gradient[a] = tile.plain_gradient[a] = lattice.gradient[a].data();
  for (tile.begin = 0; tile.begin < particles; tile.begin = tile.end) {
    tile.end = std::min(tile.begin + tile_size, particles);
    loops.kernels[Kernel(CubicSpline()).index()].gradients(tile, lattice.records);
    loops.velocity_gradient(tile, lattice.records, out.data() + 9 * tile.begin);
  }
}

using Layout = void (*)(Lattice&, Gradients&);

/// The layouts add in different orders: they agree to round-off of some 50 summands.
void check_against_scalar(Lattice& lattice, const Gradients& found) {
  Gradients expected(found.size());
  scalar_arrays(lattice, expected);
  const double largest = std::abs(*std::max_element(expected.begin(), expected.end(),
                                                    [](double a, double b) { return std::abs(a) < std::abs(b); }));
  for (std::size_t k = 0; k < found.size(); ++k)
    if (!(std::abs(found[k] - expected[k]) < 1e-12 * largest)) throw std::logic_error("a layout gives another sum");
}

void velocity_gradient(benchmark::State& state, Layout layout) {
  Lattice lattice(0.01 * static_cast<double>(state.range(0)) * spacing);
  Gradients out(std::size_t{9} * particles);
  for (auto _ : state) {
    layout(lattice, out);
    benchmark::DoNotOptimize(out.data());
    benchmark::ClobberMemory();
  }
  check_against_scalar(lattice, out);
  state.counters["per_particle"] =
      benchmark::Counter(particles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["listed"] = static_cast<double>(lattice.list.listed()) / particles;
  state.SetLabel(simd_level());
}

}  // namespace
}  // namespace anvil

int main(int argc, char** argv) {
  const std::pair<const char*, anvil::Layout> layouts[] = {{"scalar_arrays", anvil::scalar_arrays},
                                                           {"symmetric_half_list", anvil::symmetric_half_list},
                                                           {"vector_gathers", anvil::vector_gathers},
                                                           {"packed_fused", anvil::packed_fused},
                                                           {"packed_tiles", anvil::packed_tiles}};
  for (const auto& [name, layout] : layouts)
    benchmark::RegisterBenchmark(name, anvil::velocity_gradient, layout)->ArgName("skin")->Arg(0)->Arg(30);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
