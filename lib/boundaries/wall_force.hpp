// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string_view>

#include "anvil/boundaries/dummy_rows.hpp"
#include "anvil/boundaries/wall_laws.hpp"
#include "anvil/core/field_keys.hpp"
#include "anvil/terms/force_term.hpp"

namespace anvil {

/// What the solver asks of the force of a wall beside the acceleration.
template <int D>
class WallForceTerm : public ForceTerm<D> {
 public:
  /// The force of the wall on all particles, N.
  [[nodiscard]] virtual Vec<D> total_force(const PairRecords<D>& records) const = 0;
  /// What the force has stored, J.
  [[nodiscard]] virtual double stored_energy(const PairRecords<D>& records) const = 0;
};

/// The first row of a wall's dummy particles repels by a law of distance (see wall_laws.hpp). Only the pairs that the
/// wall has listed are visited.
template <int D, class Law>
class WallForce final : public WallForceTerm<D> {
 public:
  WallForce(FieldStore& fields, const DummyRows<D>& wall, const Law& law, std::string_view name,
            std::string_view purpose)
      : wall_(wall),
        law_(law),
        name_(name),
        purpose_(purpose),
        position_(fields.vector<D>(field::position)),
        mass_((fields.require(field::mass), fields.scalar(field::mass))),
        density_((fields.require(field::density), fields.scalar(field::density))) {}

  [[nodiscard]] std::string_view name() const override { return name_; }
  [[nodiscard]] std::string_view purpose() const override { return purpose_; }
  [[nodiscard]] PairNeeds needs() const override { return {}; }
  void pack(ParticleRange /*range*/, PairRecords<D>& /*records*/) const override {}

  void accumulate(const PairTile<D>& tile, const PairRecords<D>& records, double* acceleration,
                  double* /*loss*/) const override {
    const auto particles = static_cast<std::int32_t>(wall_.listed_particles());  // dummies of walls come behind
    for (std::int32_t i = tile.begin; i < tile.end && i < particles; ++i)
      Eigen::Map<Vec<D>>(acceleration + (i - tile.begin) * D) += of_particle(static_cast<std::size_t>(i), records);
  }

  [[nodiscard]] Vec<D> total_force(const PairRecords<D>& records) const override {
    Vec<D> force = Vec<D>::Zero();
    for (const std::int32_t near : wall_.near_particles()) {
      const auto i = static_cast<std::size_t>(near);
      force += mass_[i] * of_particle(i, records);
    }
    return force;
  }

  [[nodiscard]] double stored_energy(const PairRecords<D>& records) const override {
    double energy = 0.0;
    for (const std::int32_t near : wall_.near_particles()) {
      const auto i = static_cast<std::size_t>(near);
      for (const std::int32_t dummy : wall_.dummies_near(i)) {
        const double distance = apart(i, dummy, records).norm();
        if (distance < law_.reach()) energy += mass_[i] * law_.energy(distance, wall_.volume(), density_[i]);
      }
    }
    return energy;
  }

 private:
  [[nodiscard]] Vec<D> apart(std::size_t i, std::int32_t dummy, const PairRecords<D>& records) const {
    return position_[i] - Eigen::Map<const Vec<D>>(records.geometry[static_cast<std::size_t>(dummy)]);
  }

  [[nodiscard]] Vec<D> of_particle(std::size_t i, const PairRecords<D>& records) const {
    Vec<D> sum = Vec<D>::Zero();
    for (const std::int32_t dummy : wall_.dummies_near(i)) {
      const Vec<D> away = apart(i, dummy, records);
      const double distance = away.norm();
      if (distance < law_.reach() && distance > 0.0)
        sum += law_.acceleration(distance, wall_.volume(), density_[i]) / distance * away;
    }
    return sum;
  }

  const DummyRows<D>& wall_;
  Law law_;
  std::string_view name_, purpose_;
  VectorView<D> position_;
  std::span<const double> mass_, density_;
};

}  // namespace anvil
