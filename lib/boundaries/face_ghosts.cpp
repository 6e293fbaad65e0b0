// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/boundaries/face_ghosts.hpp"

#include <algorithm>
#include <cmath>

#include "anvil/core/field_keys.hpp"

namespace anvil {
namespace {

std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

}  // namespace

FaceGhosts::FaceGhosts(FieldStore& fields, std::vector<std::int32_t> order, double support)
    : order_(std::move(order)),
      support_(support),
      position_(fields.scalar(field::position)),
      mass_(fields.scalar(field::mass)),
      density_(fields.scalar(field::density)),
      smoothing_length_(fields.scalar(field::smoothing_length)) {}

/// How far i and j reach each other.
double FaceGhosts::half_reach(std::int32_t i, std::int32_t j) const {
  return 0.5 * support_ * (smoothing_length_[at(i)] + smoothing_length_[at(j)]);
}

double FaceGhosts::face_position(const Face& face) const {
  const std::size_t i = at(face.particle);
  return position_[i] + face.outward * 0.5 * mass_[i] / density_[i];
}

bool FaceGhosts::open(const Face& face) const {
  if (face.beyond < 0) return true;
  return std::abs(position_[at(face.beyond)] - position_[at(face.particle)]) >= half_reach(face.particle, face.beyond);
}

/// Both ends of the line, and both sides of every gap that is open or could be before the next list is made.
void FaceGhosts::find_faces(double skin, const NeighbourList<1>& neighbours) {
  faces_.clear();
  face_place_.clear();
  const auto add = [&](std::size_t place, std::int32_t beyond, double outward) {
    faces_.push_back({order_[place], beyond, outward});
    face_place_.push_back(place);
  };
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const auto gap_to = [&](std::int32_t other) {
      return std::abs(position_[at(other)] - position_[at(order_[k])]) + skin - half_reach(order_[k], other);
    };
    const double spacing = mass_[at(order_[k])] / density_[at(order_[k])];
    // Half a spacing of clear gap tells a face from a stretched body: kernels that reach far would else never end.
    const auto is_face = [&](std::int32_t other) {
      return gap_to(other) >= 0.0 && std::abs(position_[at(other)] - position_[at(order_[k])]) > 1.5 * spacing;
    };
    const std::int32_t* row = neighbours.neighbours();
    const std::size_t self = at(order_[k]);
    const bool meets_image = std::any_of(row + neighbours.row_begin(self), row + neighbours.row_end(self),
                                         [&](std::int32_t j) { return at(j) > order_.size(); });
    if (k == 0 ? !meets_image : is_face(order_[k - 1])) add(k, k == 0 ? -1 : order_[k - 1], -1.0);
    if (k + 1 == order_.size() ? !meets_image : is_face(order_[k + 1]))
      add(k, k + 1 == order_.size() ? -1 : order_[k + 1], 1.0);
  }
}

/// All pairs of a particle and an image whose distances to the face add up to less than their reach.
void FaceGhosts::add_ghosts_of(std::int32_t f, std::size_t place, double skin, std::vector<ExtraNeighbour>& extra) {
  const Face& face = faces_[at(f)];
  const double x_face = face_position(face);
  const double limit = 2.0 * half_reach(face.particle, face.particle) + 2.0 * skin;  // both sides may move and grow
  const auto depth = [&](std::size_t k) { return face.outward * (x_face - position_[at(order_[k])]); };
  const auto inner = [&](std::size_t steps) { return face.outward > 0.0 ? place - steps : place + steps; };
  const std::size_t available = face.outward > 0.0 ? place + 1 : order_.size() - place;
  for (std::size_t s = 0; s < available && depth(inner(s)) + depth(place) < limit; ++s) {
    const auto record = static_cast<std::int32_t>(first_ghost_ + ghosts_.size());
    ghosts_.push_back({order_[inner(s)], f});
    for (std::size_t t = 0; t < available && depth(inner(s)) + depth(inner(t)) < limit; ++t)
      extra.push_back({order_[inner(t)], record});
  }
}

void FaceGhosts::list(NeighbourList<1>& neighbours, PairRecords<1>& records, double skin, std::size_t images) {
  find_faces(skin, neighbours);
  first_ghost_ = records.first_image() + images;
  ghosts_.clear();
  std::vector<ExtraNeighbour> extra;
  for (std::size_t f = 0; f < faces_.size(); ++f)
    add_ghosts_of(static_cast<std::int32_t>(f), face_place_[f], skin, extra);
  neighbours.append(extra, pair_loops<1>().lanes);
  records.set_images(images + ghosts_.size());
}

void FaceGhosts::show(PairRecords<1>& records, std::span<const PressureLoad> loads,
                      std::span<const double> face_stress) const {
  for (std::size_t g = 0; g < ghosts_.size(); ++g) {
    const Face& face = faces_[at(ghosts_[g].face)];
    const std::size_t source = at(ghosts_[g].particle), image = first_ghost_ + g;
    double stress = 0.0;
    for (std::size_t k = 0; k < loads.size(); ++k)
      if (loads[k].particle == at(face.particle) && loads[k].inward == -face.outward) stress = face_stress[k];
    const double volume = open(face) ? mass_[source] / density_[source] : 0.0;
    records.geometry[image][0] = 2.0 * face_position(face) - position_[source];
    records.geometry[image][1] = smoothing_length_[source];
    records.motion[image][0] = records.motion[source][0];  // no velocity is given at a face: no shock there
    records.motion[image][1] = volume;
    if (records.response.count() != 0) std::copy_n(records.response[source], 8, records.response[image]);
    if (records.slope.count() != 0) records.slope[image][SlopeField<1>::body] = -1.0;  // nothing to extrapolate across
    records.traction[image][0] = 2.0 * stress - records.traction[source][0];
    records.traction[image][1] = volume;
  }
}

void FaceGhosts::hide(PairRecords<1>& records) const {
  for (std::size_t g = 0; g < ghosts_.size(); ++g) {
    const std::size_t image = first_ghost_ + g;
    records.geometry[image][0] = padding_distance;
    records.geometry[image][1] = smoothing_length_[at(ghosts_[g].particle)];
    records.motion[image][1] = 0.0;
  }
}

}  // namespace anvil
