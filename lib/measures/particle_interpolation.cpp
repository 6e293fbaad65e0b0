// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/particle_interpolation.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "anvil/core/error.hpp"
#include "anvil/core/threads.hpp"
#include "anvil/kernels/cubic_spline.hpp"

namespace anvil {
namespace {

constexpr double usual_smoothing_ratio = 1.2;
constexpr int bits_per_axis = 21;
constexpr std::int64_t most_cells = (std::int64_t{1} << bits_per_axis) - 2;  // along an axis, with one to spare

double squared_distance(const double* a, const double* b, int dimension) {
  double sum = 0.0;
  for (int i = 0; i < dimension; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

double kernel(double r, double h, int dimension) {
  double volume = 1.0;
  for (int i = 0; i < dimension; ++i) volume *= h;
  return CubicSpline::normalisation(dimension) / volume * CubicSpline::value(r / h);
}

std::vector<double> smoothing_lengths(const Frame& frame, const std::vector<double>& positions, double wanted) {
  const FrameArray* array = frame.find("smoothing_length");
  std::vector<double> lengths;
  if (wanted == 0.0 && array != nullptr && array->components == 1) {
    lengths = array->values;
  } else {
    const double spacing = usual_spacing(positions, frame.dimension);
    lengths.assign(frame.particle_count(), wanted != 0.0 ? wanted : usual_smoothing_ratio * spacing);
  }
  if (!std::all_of(lengths.begin(), lengths.end(), [](double h) { return std::isfinite(h) && h > 0.0; }))
    throw InputError("the smoothing length of a particle is not above zero: say which to take");
  return lengths;
}

}  // namespace

ParticleInterpolation::ParticleInterpolation(const Frame& frame, const InterpolationOptions& options)
    : ParticleInterpolation(frame, frame.positions, options) {}

ParticleInterpolation::ParticleInterpolation(const Frame& frame, const std::vector<double>& positions,
                                             const InterpolationOptions& options)
    : options_(options), dimension_(frame.dimension), positions_(positions) {
  if (!std::all_of(positions.begin(), positions.end(), [](double x) { return std::isfinite(x); }))
    throw InputError("the frame holds positions that are not numbers: the run went wrong before it");
  smoothing_length_ = smoothing_lengths(frame, positions, options.smoothing_length);
  sort_into_cells();
  find_volumes(frame);
}

void ParticleInterpolation::sort_into_cells() {
  cell_size_ = CubicSpline::support * *std::max_element(smoothing_length_.begin(), smoothing_length_.end());
  const std::size_t count = positions_.size() / 3;
  for (int axis = 0; axis < dimension_; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    double low = positions_[a];
    double high = low;
    for (std::size_t i = 1; i < count; ++i) {
      low = std::min(low, positions_[3 * i + a]);
      high = std::max(high, positions_[3 * i + a]);
    }
    origin_[a] = low;
    cell_size_ = std::max(cell_size_, (high - low) / static_cast<double>(most_cells - 2));
  }
  order_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t cell = 0;
    for (int axis = dimension_ - 1; axis >= 0; --axis)
      cell = (cell << bits_per_axis) | cell_at(&positions_[3 * i], axis);
    order_[i] = {cell, static_cast<std::int32_t>(i)};
  }
  std::sort(order_.begin(), order_.end(), [](const CellOf& a, const CellOf& b) {
    return std::tie(a.cell, a.particle) < std::tie(b.cell, b.particle);
  });
}

/// From 1: there is a cell before the first. Places far outside go to the cells at the ends, which hold nothing near.
std::uint64_t ParticleInterpolation::cell_at(const double* point, int axis) const {
  const double cell = std::floor((point[axis] - origin_[axis]) / cell_size_) + 1.0;
  return static_cast<std::uint64_t>(std::clamp(cell, 0.0, static_cast<double>(most_cells)));
}

template <class Visit>
void ParticleInterpolation::for_each_near(const double* point, Visit&& visit) const {
  std::uint64_t low[3] = {0, 0, 0};
  std::uint64_t high[3] = {0, 0, 0};
  for (int axis = 0; axis < dimension_; ++axis) {
    const std::uint64_t cell = cell_at(point, axis);
    low[axis] = cell == 0 ? 0 : cell - 1;
    high[axis] = cell + 1;
  }
  // A row of cells along x is one range of the sorted particles.
  for (std::uint64_t z = low[2]; z <= high[2]; ++z)
    for (std::uint64_t y = low[1]; y <= high[1]; ++y) {
      const std::uint64_t row = (z << (2 * bits_per_axis)) | (y << bits_per_axis);
      const auto first = std::lower_bound(order_.begin(), order_.end(), row | low[0],
                                          [](const CellOf& one, std::uint64_t cell) { return one.cell < cell; });
      for (auto one = first; one != order_.end() && one->cell <= (row | high[0]); ++one) {
        const auto j = static_cast<std::size_t>(one->particle);
        const double h = smoothing_length_[j];
        const double squared = squared_distance(point, &positions_[3 * j], dimension_);
        if (squared >= CubicSpline::support * CubicSpline::support * h * h) continue;
        visit(j, kernel(std::sqrt(squared), h, dimension_));
      }
    }
}

void ParticleInterpolation::find_volumes(const Frame& frame) {
  const std::size_t count = frame.particle_count();
  const FrameArray* mass = frame.find("mass");
  const FrameArray* density = frame.find("density");
  volume_.resize(count);
  if (mass != nullptr && density != nullptr) {
    for (std::size_t i = 0; i < count; ++i) volume_[i] = mass->values[i] / density->values[i];
    return;
  }
  for_each_parallel(static_cast<int>(count), [&](int item, int) {
    const auto i = static_cast<std::size_t>(item);
    double sum = 0.0;
    for_each_near(&positions_[3 * i], [&](std::size_t, double weight) { sum += weight; });
    volume_[i] = 1.0 / sum;
  });
}

ParticleInterpolation::Sampled ParticleInterpolation::at(std::span<const double> points,
                                                         std::span<const std::vector<double>> fields) const {
  const std::size_t count = points.size() / 3;
  Sampled sampled{std::vector<double>(count),
                  std::vector<std::vector<double>>(fields.size(), std::vector<double>(count))};
  for_each_parallel(static_cast<int>(count), [&](int item, int) {
    const auto place = static_cast<std::size_t>(item);
    sample_point(&points[3 * place], fields, place, sampled);
  });
  return sampled;
}

void ParticleInterpolation::sample_point(const double* point, std::span<const std::vector<double>> fields,
                                         std::size_t place, Sampled& sampled) const {
  // Basis 1, (x - x_j)/cell: order 0 needs the first row and column only.
  const int terms = options_.order == 0 ? 1 : 1 + dimension_;
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  constexpr std::size_t most_near = 512;
  std::vector<std::pair<std::size_t, Eigen::Vector4d>> near;
  near.reserve(options_.order == 0 ? 0 : most_near);
  for (std::size_t f = 0; f < fields.size(); ++f) sampled.values[f][place] = 0.0;
  double filling = 0.0;
  for_each_near(point, [&](std::size_t j, double kernel_value) {
    const double weight = volume_[j] * kernel_value;
    filling += weight;
    for (std::size_t f = 0; f < fields.size(); ++f) sampled.values[f][place] += weight * fields[f][j];
    if (terms == 1) return;
    Eigen::Vector4d basis = Eigen::Vector4d::Zero();
    basis[0] = 1.0;
    for (int axis = 0; axis < dimension_; ++axis)
      basis[1 + axis] = (positions_[3 * j + static_cast<std::size_t>(axis)] - point[axis]) / cell_size_;
    moments += weight * basis * basis.transpose();
    near.emplace_back(j, weight * basis);
  });
  sampled.filling[place] = filling;
  if (!(filling >= options_.least_filling) || filling <= 0.0) {
    for (auto& values : sampled.values) values[place] = std::numeric_limits<double>::quiet_NaN();
    return;
  }
  for (auto& values : sampled.values) values[place] /= filling;
  if (terms == 1) return;
  const Eigen::MatrixXd used = moments.topLeftCorner(terms, terms);
  const Eigen::LDLT<Eigen::MatrixXd> solver(used);
  // Particles on one line or plane do not say how a field changes across it.
  constexpr double well_posed = 1e-6;
  if (solver.rcond() < well_posed) return;
  const Eigen::VectorXd row = solver.solve(Eigen::VectorXd::Unit(terms, 0));
  for (std::size_t f = 0; f < fields.size(); ++f) {
    double value = 0.0;
    for (const auto& [j, basis] : near) value += row.dot(basis.head(terms)) * fields[f][j];
    sampled.values[f][place] = value;
  }
}

double usual_spacing(std::span<const double> positions, int dimension) {
  constexpr std::size_t most_asked = 2000;
  const std::size_t count = positions.size() / 3;
  if (count < 2) return 0.0;
  std::vector<std::size_t> order(count);
  for (std::size_t i = 0; i < count; ++i) order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return positions[3 * a] < positions[3 * b]; });
  // Sorted along x, the nearest one is found by going out both ways until x alone is too far.
  std::vector<double> distances;
  const std::size_t stride = 1 + count / most_asked;
  for (std::size_t k = 0; k < count; k += stride) {
    const double* own = &positions[3 * order[k]];
    double nearest = std::numeric_limits<double>::infinity();
    const auto look = [&](std::size_t other) {
      const double* place = &positions[3 * order[other]];
      nearest = std::min(nearest, squared_distance(own, place, dimension));
      return (place[0] - own[0]) * (place[0] - own[0]) < nearest;
    };
    for (std::size_t other = k + 1; other < count && look(other);) ++other;
    for (std::size_t other = k; other > 0 && look(other - 1);) --other;
    distances.push_back(std::sqrt(nearest));
  }
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return *middle;
}

}  // namespace anvil
