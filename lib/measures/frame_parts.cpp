// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/frame_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_set>

#include "anvil/measures/particle_interpolation.hpp"

namespace anvil {
namespace {

void keep(std::vector<double>& values, std::size_t components, const std::vector<std::size_t>& kept) {
  std::size_t place = 0;
  for (const std::size_t i : kept)
    for (std::size_t c = 0; c < components; ++c) values[place++] = values[components * i + c];
  values.resize(place);
}

/// Where particles stand on their lattice, as one number; bodies may touch, so each has sites of its own.
class Sites {
 public:
  Sites(const Frame& frame, const std::vector<double>& positions, double spacing)
      : positions_(positions), body_(frame.find("body")), spacing_(spacing) {
    for (std::size_t i = 0; i < positions.size(); ++i) low_[i % 3] = std::min(low_[i % 3], positions[i]);
    for (std::size_t i = 0; i < frame.particle_count(); ++i) taken_.insert(site_of(i));
  }

  /// Of the 2^D cells around a particle, the share whose corners are all taken.
  [[nodiscard]] double share_of(std::size_t particle, int dimension) const {
    const std::uint64_t site = site_of(particle);
    const int cells = 1 << dimension;
    int full = 0;
    for (int cell = 0; cell < cells; ++cell) full += is_full(site, cell, cells) ? 1 : 0;
    return static_cast<double>(full) / cells;
  }

 private:
  static constexpr int bits = 19;  // per axis, with a margin of one for the neighbours outside

  [[nodiscard]] std::uint64_t site_of(std::size_t particle) const {
    auto site = static_cast<std::uint64_t>(body_ == nullptr ? 0.0 : body_->values[particle]);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double steps = std::round((positions_[3 * particle + axis] - low_[axis]) / spacing_) + 1.0;
      site = (site << bits) | static_cast<std::uint64_t>(steps);
    }
    return site;
  }

  /// Bit a of `cell` says on which side of the site it lies along axis a.
  [[nodiscard]] bool is_full(std::uint64_t site, int cell, int corners) const {
    for (int corner = 0; corner < corners; ++corner) {
      std::uint64_t other = site;
      for (int axis = 0; axis < 3; ++axis) {
        if ((corner >> axis & 1) == 0) continue;
        const std::uint64_t step = std::uint64_t{1} << (bits * (2 - axis));
        other = (cell >> axis & 1) != 0 ? other + step : other - step;
      }
      if (!taken_.contains(other)) return false;
    }
    return true;
  }

  const std::vector<double>& positions_;
  const FrameArray* body_;
  double spacing_;
  std::array<double, 3> low_{};
  std::unordered_set<std::uint64_t> taken_;
};

}  // namespace

std::vector<double> take_walls_out(Frame& frame, int first_wall) {
  const FrameArray* body = frame.find("body");
  std::vector<double> walls;
  if (body == nullptr) return walls;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < frame.particle_count(); ++i) {
    if (body->values[i] < first_wall)
      kept.push_back(i);
    else
      walls.insert(walls.end(), &frame.positions[3 * i], &frame.positions[3 * i] + 3);
  }
  if (walls.empty()) return walls;
  keep(frame.positions, 3, kept);
  for (FrameArray& array : frame.arrays) keep(array.values, static_cast<std::size_t>(array.components), kept);
  return walls;
}

void add_masses_of_face_lattice(Frame& frame) {
  const FrameArray* initial = frame.find("initial_position");
  if (initial == nullptr || frame.find("mass") != nullptr) return;
  const double spacing = usual_spacing(initial->values, frame.dimension);
  if (!(spacing > 0.0)) return;
  if (frame.find("density") == nullptr)
    frame.arrays.push_back({"density", "", 1, false, std::vector<double>(frame.particle_count(), 1.0)});
  initial = frame.find("initial_position");
  const std::vector<double>& density = frame.find("density")->values;
  const Sites sites(frame, initial->values, spacing);
  FrameArray mass{"mass", "kg", 1, false, {}};
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    mass.values.push_back(density[i] * sites.share_of(i, frame.dimension) * std::pow(spacing, frame.dimension));
  frame.arrays.push_back(std::move(mass));
}

}  // namespace anvil
