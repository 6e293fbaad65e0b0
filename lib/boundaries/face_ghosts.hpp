// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "anvil/boundaries/pressure.hpp"
#include "anvil/core/fields.hpp"
#include "anvil/pairs/neighbour_list.hpp"
#include "anvil/pairs/records.hpp"

namespace anvil {

/// The ends of a line of particles, for sums that take stress differences and so do not know where a body ends.
///
/// The face of an end lies half a spacing outside its last particle, and the stress there is given: zero, or minus the
/// pressure of a load. Behind it stand mirror images of the particles within reach, with the stress 2 sigma_face -
/// sigma: odd about the face, so that the stress there is the given one. On an even line the sum over all particles of
/// m a then is the difference of the two face stresses to round-off: momentum is conserved.
///
/// A face is open as long as the next particle beyond it is out of reach; where bodies meet the images vanish.
class FaceGhosts {
 public:
  /// `order`: the particles by position; `support` of the kernel in smoothing lengths.
  FaceGhosts(FieldStore& fields, std::vector<std::int32_t> order, double support);

  /// Finds the faces and adds the images within reach and skin to a list just made.
  /// An end that meets an image of a particle (see Images) is none; `images` of those stand before the ghosts.
  void list(NeighbourList<1>& neighbours, PairRecords<1>& records, double skin, std::size_t images = 0);
  /// Writes the images' records for a sum over stresses. `face_stress[k]`, Pa, is that of loads[k]'s face; other faces
  /// are free. The records of the particles themselves are up to date.
  void show(PairRecords<1>& records, std::span<const PressureLoad> loads, std::span<const double> face_stress) const;
  /// Takes the images out of sums: velocities have no given value at a face.
  void hide(PairRecords<1>& records) const;

 private:
  struct Face {
    std::int32_t particle;  // the last one
    std::int32_t beyond;    // the next one beyond the face, -1 for none
    double outward;         // +1 or -1
  };
  struct Ghost {
    std::int32_t particle;  // whose image it is
    std::int32_t face;
  };
  [[nodiscard]] double half_reach(std::int32_t i, std::int32_t j) const;
  [[nodiscard]] double face_position(const Face& face) const;
  [[nodiscard]] bool open(const Face& face) const;
  void find_faces(double skin, const NeighbourList<1>& neighbours);
  void add_ghosts_of(std::int32_t face, std::size_t place, double skin, std::vector<ExtraNeighbour>& extra);

  std::vector<std::int32_t> order_;
  double support_;
  std::span<const double> position_, mass_, density_, smoothing_length_;
  std::vector<Face> faces_;
  std::vector<std::size_t> face_place_;  // of each face's particle in the order
  std::vector<Ghost> ghosts_;
  std::size_t first_ghost_ = 0;  // its record
};

}  // namespace anvil
