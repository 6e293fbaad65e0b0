// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "anvil/core/fields.hpp"
#include "anvil/scene/placement.hpp"

namespace anvil {

/// The surface of a body whose particles stand on its faces, by numbers of particles of the scene.
template <int D>
struct Surface {
  std::vector<std::int32_t> particles;
  std::vector<BodyFacet<D>> facets;
};

/// Contact without friction between bodies whose particles stand on their faces. A particle on one surface and the
/// facet of the other that it meets exchange the impulse that leaves as much of their approach as closes the gap within
/// the step, no more: as a rigid wall does, which is the case of an infinitely heavy partner. Facets act through the
/// weights of their corners at the closest point, so linear and angular momentum are kept. Impulses push, never pull;
/// they are found together by sweeps over all contacts until none changes (projected Gauss-Seidel; Moreau 1988).
template <int D>
class Contact {
 public:
  /// Surfaces of all bodies, one each; `spacing` of the particles, m.
  Contact(std::vector<Surface<D>> surfaces, FieldStore& fields, double spacing);

  /// Changes velocities so that a move of time_step (s) lets no particle through a facet.
  void correct_velocities(double time_step);

  /// What the contacts of the last correction took from the motion, J, given the velocities of before all impulses of
  /// the step (`stride` doubles apart) and the present ones, which are those after all of them.
  [[nodiscard]] double loss(const double* start_velocity, int stride) const;
  /// Of all pushes of the last correction, however directed, N s.
  [[nodiscard]] double impulse() const;
  /// Of a particle behind the facet it meets, at the present positions, m.
  [[nodiscard]] double deepest_penetration();

 private:
  static constexpr std::size_t corners = D == 1 ? 1 : BodyFacet<D>{}.size();
  struct Meeting {
    std::int32_t particle;
    BodyFacet<D> facet;
    std::array<double, BodyFacet<D>{}.size()> weight;
    Vec<D> normal;    // of the facet, outward
    double gap;       // m, along the normal
    double distance;  // m, from the closest point
    double compliance, impulse;
  };
  struct Closest {
    Vec<D> point;
    std::array<double, BodyFacet<D>{}.size()> weight;
  };

  /// Of every particle of one surface, the facets of another that it may meet: facets[end[p]] to facets[end[p + 1]].
  struct Candidates {
    std::size_t points, surface;  // numbers of the two surfaces
    std::vector<std::int32_t> end, facets;
  };

  void find_meetings();
  [[nodiscard]] bool moved_by_half_the_skin() const;
  void find_candidates(std::size_t points, std::size_t facets);
  void meet(const Candidates& candidates);
  void update_outward(std::size_t surface);
  [[nodiscard]] std::optional<Meeting> meeting_of(std::int32_t particle, const BodyFacet<D>& facet) const;
  [[nodiscard]] Closest closest_on(const BodyFacet<D>& facet, const Vec<D>& place) const;
  [[nodiscard]] Vec<D> normal_of(const BodyFacet<D>& facet) const;
  void push(const Meeting& meeting, double impulse);
  [[nodiscard]] double approach(const Meeting& meeting) const;

  std::vector<Surface<D>> surfaces_;
  std::vector<std::vector<Vec<D>>> outward_;  // by surface and its particles: sum of the normals of the facets around
  VectorView<D> position_, velocity_;
  std::span<const double> mass_;
  double reach_, skin_, side_tolerance_;  // m
  // Searched for again when a particle has moved by half the skin. What is met does not depend on when that was.
  std::vector<Candidates> candidates_;
  std::vector<Vec<D>> searched_;  // m: positions at the last search, surface by surface
  std::vector<Meeting> meetings_;
};

}  // namespace anvil
