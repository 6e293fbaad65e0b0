// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "anvil/core/field_keys.hpp"
#include "anvil/scene/placement.hpp"
#include "anvil/terms/force_term.hpp"
#include "anvil/total_lagrangian/deformation.hpp"

namespace anvil {

/// An immovable plane without friction that stores what it takes: the faces of total Lagrangian particles that are a
/// depth d behind it are pushed back by k d. A face stands at x_i + F_i O with its place O seen from the particle at
/// the start: zero for particles on faces, half a spacing along the face's normal for those that fill a body. The force
/// follows from the energy k d^2/2, so it acts on the particle and, through the deformation gradient, on its stress.
template <int D>
class WallPenalty final : public ForceTerm<D> {
 public:
  /// `normal` of unit length towards the bodies; `stiffness` in N/m per m^(D-1) of face.
  WallPenalty(const Vec<D>& point, const Vec<D>& normal, double stiffness, std::vector<SurfacePoint<D>> faces,
              FieldStore& fields, const Deformation<D>& deformation)
      : point_(point),
        normal_(normal),
        stiffness_(stiffness),
        faces_(std::move(faces)),
        force_(faces_.size(), 0.0),
        first_face_(fields.particle_count() + 1, 0),
        position_(fields.vector<D>(field::position)),
        mass_(fields.scalar(field::mass)),
        deformation_(deformation) {
    for (const auto& face : faces_) ++first_face_[static_cast<std::size_t>(face.particle) + 1];
    for (std::size_t i = 1; i < first_face_.size(); ++i) first_face_[i] += first_face_[i - 1];
  }

  [[nodiscard]] std::string_view name() const override { return "wall_penalty"; }
  [[nodiscard]] std::string_view purpose() const override {
    return "plane without friction that pushes with the depth of faces behind it";
  }
  [[nodiscard]] PairNeeds needs() const override { return {}; }

  /// After the nominal stresses stand in their records.
  void pack(ParticleRange range, PairRecords<D>& records) const override {
    for (std::size_t i = range.first(); i < range.last(); ++i) {
      for (std::size_t k = first_face_[i]; k < first_face_[i + 1]; ++k) {
        const Vec<D> offset = deformation_.gradient(i) * faces_[k].offset;
        const double depth = normal_.dot(point_ - position_[i] - offset);
        force_[k] = depth > 0.0 ? stiffness_ * faces_[k].area * depth : 0.0;
        if (force_[k] == 0.0 || faces_[k].offset.isZero(0.0)) continue;
        const Square<D> nominal = force_[k] / deformation_.volume(i) * normal_ * faces_[k].offset.transpose();
        SquareMap<D> record(records.nominal[i]);
        record -= nominal * deformation_.correction(i) / deformation_.reference_density(i);
      }
    }
  }

  void accumulate(const PairTile<D>& tile, const PairRecords<D>& /*records*/, double* acceleration,
                  double* /*loss*/) const override {
    for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end);
         ++i, acceleration += D) {
      Eigen::Map<Vec<D>> own(acceleration);
      for (std::size_t k = first_face_[i]; k < first_face_[i + 1]; ++k) own += force_[k] / mass_[i] * normal_;
    }
  }

  /// On all bodies together, N.
  [[nodiscard]] Vec<D> force() const {
    double sum = 0.0;
    for (const double one : force_) sum += one;
    return sum * normal_;
  }
  /// Stored in the depths, J.
  [[nodiscard]] double energy() const {
    double sum = 0.0;
    for (std::size_t k = 0; k < faces_.size(); ++k) sum += 0.5 * force_[k] * force_[k] / (stiffness_ * faces_[k].area);
    return sum;
  }

 private:
  Vec<D> point_, normal_;
  double stiffness_;
  std::vector<SurfacePoint<D>> faces_;   // by particle
  mutable std::vector<double> force_;    // N, of each face: written by the tile of its particle
  std::vector<std::size_t> first_face_;  // by particle
  VectorView<D> position_;
  std::span<const double> mass_;
  const Deformation<D>& deformation_;
};

}  // namespace anvil
