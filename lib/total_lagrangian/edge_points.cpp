// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/total_lagrangian/edge_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/strain_state.hpp"
#include "anvil/pairs/neighbour_list.hpp"

namespace anvil {

template <int D>
EdgePoints<D>::EdgePoints(FieldStore& particles, const std::vector<ParticleRange>& bodies, double spacing,
                          const Images<D>& images)
    : position_(particles.vector<D>(field::position)),
      initial_position_(particles.vector<D>(field::initial_position)),
      mass_(particles.scalar(field::mass)),
      density_(particles.scalar(field::density)) {
  find_turns(spacing, images);
  find_edges(bodies, spacing);
  list_incoming();
  share_volumes();
}

template <int D>
void EdgePoints<D>::find_turns(double spacing, Images<D> images) {
  transforms_of_.assign(mass_.size(), -1);
  if (!images.possible()) return;
  const double same_place = 1e-6 * spacing;
  images.find(initial_position_, std::vector<double>(mass_.size(), spacing), spacing);
  for (std::size_t g = 0; g < images.count(); ++g) {
    const std::size_t i = images.source(g);
    if ((images.sites().position[g] - initial_position_[i]).norm() > same_place) continue;
    if (transforms_of_[i] < 0) {
      transforms_of_[i] = static_cast<std::int32_t>(transforms_.size());
      transforms_.push_back({Transform<D>()});
    }
    transforms_[static_cast<std::size_t>(transforms_of_[i])].push_back(images.transform(g));
  }
}

template <int D>
void EdgePoints<D>::find_edges(const std::vector<ParticleRange>& bodies, double spacing) {
  constexpr double longest = 1.1;  // spacings: between an edge and the diagonal of a cell's face
  const std::size_t particles = mass_.size();
  std::vector<std::int32_t> body_of(particles);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    std::fill(body_of.begin() + bodies[b].begin, body_of.begin() + bodies[b].end, static_cast<std::int32_t>(b));
  NeighbourList<D> near;
  near.build(initial_position_, std::vector<double>(particles, spacing), longest, 0.0, pair_loops<D>());
  for (std::size_t i = 0; i < particles; ++i) {
    first_edge_.push_back(static_cast<std::int32_t>(first_.size()));
    for (std::int64_t k = near.row_begin(i); k < near.row_end(i); ++k) {
      const auto j = static_cast<std::size_t>(near.neighbours()[k]);
      if (j <= i || j >= particles || body_of[i] != body_of[j]) continue;
      first_.push_back(static_cast<std::int32_t>(i));
      second_.push_back(static_cast<std::int32_t>(j));
      const Vec<D> apart = initial_position_[i] - initial_position_[j], direction = apart.normalized();
      shape_.insert(shape_.end(), direction.data(), direction.data() + D);
      shape_.push_back(1.0 / apart.norm());
      shape_.push_back(part_on_this_side(i, initial_position_[j], spacing));  // volumes come later
    }
  }
  first_edge_.push_back(static_cast<std::int32_t>(first_.size()));
}

/// Of an edge, 1 unless it lies in a plane of symmetry.
template <int D>
double EdgePoints<D>::part_on_this_side(std::size_t first, const Vec<D>& second, double spacing) const {
  if (transforms_of_[first] < 0) return 1.0;
  const auto& keep_first = transforms_[static_cast<std::size_t>(transforms_of_[first])];
  const auto keeps_second = [&](const Transform<D>& transform) {
    return (transform(second) - second).norm() < 1e-6 * spacing;
  };
  return 1.0 / static_cast<double>(std::count_if(keep_first.begin(), keep_first.end(), keeps_second));
}

template <int D>
void EdgePoints<D>::list_incoming() {
  first_incoming_.assign(mass_.size() + 1, 0);
  for (const std::int32_t end : second_) ++first_incoming_[static_cast<std::size_t>(end) + 1];
  for (std::size_t i = 1; i < first_incoming_.size(); ++i) first_incoming_[i] += first_incoming_[i - 1];
  incoming_.resize(second_.size());
  std::vector<std::int32_t> next(first_incoming_.begin(), first_incoming_.end() - 1);
  for (std::size_t e = 0; e < second_.size(); ++e)
    incoming_[static_cast<std::size_t>(next[static_cast<std::size_t>(second_[e])]++)] = static_cast<std::int32_t>(e);
}

/// Those that begin there, then those that end there.
template <int D>
template <class Work>
void EdgePoints<D>::for_each_edge_at(std::size_t particle, Work&& work) const {
  for (std::int32_t e = first_edge_[particle]; e < first_edge_[particle + 1]; ++e) work(static_cast<std::size_t>(e));
  for (std::int32_t k = first_incoming_[particle]; k < first_incoming_[particle + 1]; ++k)
    work(static_cast<std::size_t>(incoming_[static_cast<std::size_t>(k)]));
}

template <int D>
void EdgePoints<D>::share_volumes() {
  const std::size_t edges = first_.size();
  fields_ = FieldStore(edges);
  for (const FieldKey* key : {&field::mass, &field::density}) fields_.require(*key);
  fields_.require(field::deviatoric_stress, StrainStateOf<D>::Type::components);
  // On planes both the volume of a particle and the number of its edges are those on this side: the quotient is that of
  // the whole body.
  std::vector<double> share(mass_.size());
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    double parts = 0.0;
    for_each_edge_at(i, [&](std::size_t e) { parts += volume(e); });
    share[i] = mass_[i] / density_[i] / parts;
  }
  for (std::size_t e = 0; e < edges; ++e) {
    const auto first = static_cast<std::size_t>(first_[e]), second = static_cast<std::size_t>(second_[e]);
    volume(e) *= share[first] + share[second];
    fields_.scalar(field::density)[e] = density_[first];
    fields_.scalar(field::mass)[e] = density_[first] * volume(e);
  }
  force_.assign(edges * force_size, 0.0);
  force_sums_.assign(mass_.size() * force_size, 0.0);
  deformation_.resize(edges * D * D);
  for (std::size_t e = 0; e < edges; ++e) SquareMap<D>(&deformation_[e * D * D]).setIdentity();
  edge_density_ = fields_.scalar(field::density).data();
  deviator_ = fields_.vector<StrainStateOf<D>::Type::components>(field::deviatoric_stress).raw();
}

template <int D>
auto EdgePoints<D>::arrays() -> Arrays {
  return {.first = first_.data(),
          .second = second_.data(),
          .shape = shape_.data(),
          .position = position_.raw(),
          .gradient = deformation_.data(),
          .density = edge_density_,
          .deviator = deviator_,
          .force = force_.data(),
          .first_edge = first_edge_.data(),
          .first_incoming = first_incoming_.data(),
          .incoming = incoming_.data()};
}

template <int D>
std::int32_t EdgePoints<D>::deform(ParticleRange edges, const Deformation<D>& particles, double time_step,
                                   double* velocity_gradients) {
  const std::int32_t turned =
      point_loops<D>().deform_edges(edges, arrays(), particles.arrays(), time_step, velocity_gradients);
  return turned < 0 ? -1 : first_[static_cast<std::size_t>(turned)];
}

template <int D>
void EdgePoints<D>::pull_back(ParticleRange edges) {
  point_loops<D>().pull_back_edges(edges, arrays());
}

template <int D>
void EdgePoints<D>::weigh(ParticleRange edges, double span) {
  for (std::size_t k = edges.first() * force_size; k < edges.last() * force_size; ++k) force_[k] *= span;
}

template <int D>
void EdgePoints<D>::sum_forces(ParticleRange particles) {
  point_loops<D>().sum_edge_forces(particles, arrays(), force_sums_.data());
  if (transforms_.empty()) return;
  for (std::size_t i = particles.first(); i < particles.last(); ++i) {
    if (transforms_of_[i] < 0) continue;
    const auto& transforms = transforms_[static_cast<std::size_t>(transforms_of_[i])];
    SquareMap<D> share(&force_sums_[i * force_size]);
    Eigen::Map<Vec<D>> force(&force_sums_[i * force_size + D * D]);
    Square<D> all_shares = Square<D>::Zero();
    Vec<D> all_forces = Vec<D>::Zero();
    for (const Transform<D>& transform : transforms) {
      all_shares += transform.turn * share * transform.turn.transpose() / static_cast<double>(transforms.size());
      all_forces += transform.turn * force;
    }
    share = all_shares;
    force = all_forces / static_cast<double>(transforms.size());
  }
}

template <int D>
void EdgePoints<D>::accumulate(const PairTile<D>& tile, const PairRecords<D>& /*records*/, double* acceleration,
                               double* /*loss*/) const {
  for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end); ++i) {
    const double per_mass = 1.0 / mass_[i], *force = &force_sums_[i * force_size + D * D];
    for (int a = 0; a < D; ++a) *acceleration++ += per_mass * force[a];
  }
}

template <int D>
std::vector<double> EdgePoints<D>::mean_at_particles(const FieldKey& key) const {
  const auto field = std::find_if(fields_.fields().begin(), fields_.fields().end(),
                                  [&](const auto& one) { return one.key->name == key.name; });
  const auto components = static_cast<std::size_t>(field->components);
  std::vector<double> mean(mass_.size() * components, 0.0);
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    double whole = 0.0;
    for_each_edge_at(i, [&](std::size_t e) {
      whole += volume(e);
      for (std::size_t c = 0; c < components; ++c)
        mean[i * components + c] += volume(e) * field->values[e * components + c];
    });
    if (whole == 0.0) continue;
    for (std::size_t c = 0; c < components; ++c) mean[i * components + c] /= whole;
  }
  return mean;
}

/// With f and its Laplacian at a particle the mean over its edges is f + h^2 lap f / (8 D), and the mean of its
/// neighbours' means is h^2 lap f / (2 D) more.
template <int D>
std::vector<double> EdgePoints<D>::scalar_at_particles(const FieldKey& key) const {
  const std::vector<double> mean = mean_at_particles(key);
  const std::span<const double> values = fields_.scalar(key);
  std::vector<double> result = mean;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    double whole = 0.0, around = 0.0;
    double least = std::numeric_limits<double>::max(), greatest = std::numeric_limits<double>::lowest();
    for_each_edge_at(i, [&](std::size_t e) {
      const auto first = static_cast<std::size_t>(first_[e]);
      whole += volume(e);
      around += volume(e) * mean[first == i ? static_cast<std::size_t>(second_[e]) : first];
      least = std::min(least, values[e]);
      greatest = std::max(greatest, values[e]);
    });
    if (whole > 0.0) result[i] = std::clamp(mean[i] - 0.25 * (around / whole - mean[i]), least, greatest);
  }
  return result;
}

template <int D>
double EdgePoints<D>::doubles_per_particle() const {
  double bytes =
      static_cast<double>(sizeof(std::int32_t) * (2 * first_.size() + incoming_.size())) +
      static_cast<double>(sizeof(double) * (shape_.size() + force_.size() + force_sums_.size() + deformation_.size()));
  for (const auto& field : fields_.fields()) bytes += static_cast<double>(sizeof(double) * field.values.size());
  return mass_.empty() ? 0.0 : bytes / static_cast<double>(sizeof(double) * mass_.size());
}

template class EdgePoints<1>;
template class EdgePoints<2>;
template class EdgePoints<3>;

}  // namespace anvil
