// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/total_lagrangian/edge_points.hpp"

#include <algorithm>
#include <cmath>

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
  list_incidences();
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
    first_edge_.push_back(static_cast<std::int32_t>(edges_.size()));
    for (std::int64_t k = near.row_begin(i); k < near.row_end(i); ++k) {
      const auto j = static_cast<std::size_t>(near.neighbours()[k]);
      if (j <= i || j >= particles || body_of[i] != body_of[j]) continue;
      const Vec<D> apart = initial_position_[i] - initial_position_[j];
      edges_.push_back(
          {static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), apart.normalized(), apart.norm(), 0.0, 1.0});
      if (transforms_of_[i] < 0) continue;
      const auto& keep_first = transforms_[static_cast<std::size_t>(transforms_of_[i])];
      const auto keeps_second = [&](const Transform<D>& transform) {
        return (transform(initial_position_[j]) - initial_position_[j]).norm() < 1e-6 * spacing;
      };
      edges_.back().part = 1.0 / static_cast<double>(std::count_if(keep_first.begin(), keep_first.end(), keeps_second));
    }
  }
  first_edge_.push_back(static_cast<std::int32_t>(edges_.size()));
}

template <int D>
void EdgePoints<D>::list_incidences() {
  first_incidence_.assign(mass_.size() + 1, 0);
  for (const Edge& edge : edges_)
    for (const std::int32_t end : {edge.first, edge.second}) ++first_incidence_[static_cast<std::size_t>(end) + 1];
  for (std::size_t i = 1; i < first_incidence_.size(); ++i) first_incidence_[i] += first_incidence_[i - 1];
  incidences_.resize(2 * edges_.size());
  std::vector<std::int32_t> next(first_incidence_.begin(), first_incidence_.end() - 1);
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const auto place = [&](std::int32_t end) {
      return static_cast<std::size_t>(next[static_cast<std::size_t>(end)]++);
    };
    incidences_[place(edges_[e].first)] = {static_cast<std::int32_t>(e), 1.0};
    incidences_[place(edges_[e].second)] = {static_cast<std::int32_t>(e), -1.0};
  }
}

template <int D>
void EdgePoints<D>::share_volumes() {
  fields_ = FieldStore(edges_.size());
  for (const FieldKey* key : {&field::mass, &field::density}) fields_.require(*key);
  fields_.require(field::deviatoric_stress, StrainStateOf<D>::Type::components);
  // On planes both the volume of a particle and the number of its edges are those on this side: the quotient is that of
  // the whole body.
  const auto share = [&](std::int32_t end) {
    const auto i = static_cast<std::size_t>(end);
    double edges = 0.0;
    for (std::int32_t k = first_incidence_[i]; k < first_incidence_[i + 1]; ++k)
      edges += edges_[static_cast<std::size_t>(incidences_[static_cast<std::size_t>(k)].edge)].part;
    return mass_[i] / density_[i] / edges;
  };
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    const double density = density_[static_cast<std::size_t>(edges_[e].first)];
    edges_[e].volume = share(edges_[e].first) + share(edges_[e].second);
    fields_.scalar(field::density)[e] = density;
    fields_.scalar(field::mass)[e] = density * edges_[e].volume * edges_[e].part;
  }
  share_.assign(edges_.size() * D * D, 0.0);
  pull_.assign(edges_.size() * D, 0.0);
  deformation_.resize(edges_.size() * D * D);
  for (std::size_t e = 0; e < edges_.size(); ++e) SquareMap<D>(&deformation_[e * D * D]).setIdentity();
  edge_density_ = fields_.scalar(field::density).data();
  deviator_ = fields_.vector<StrainStateOf<D>::Type::components>(field::deviatoric_stress).raw();
}

template <int D>
std::int32_t EdgePoints<D>::deform(ParticleRange edges, const Deformation<D>& particles, double time_step,
                                   double* velocity_gradients) {
  const double per_step = time_step > 0.0 ? 1.0 / time_step : 0.0;
  std::int32_t turned = -1;
  for (std::size_t e = edges.first(); e < edges.last(); ++e, velocity_gradients += D * D) {
    const Edge& edge = edges_[e];
    const auto i = static_cast<std::size_t>(edge.first), j = static_cast<std::size_t>(edge.second);
    const Square<D> mean = 0.5 * (particles.gradient(i) + particles.gradient(j));
    const Vec<D> along = (position_[i] - position_[j]) / edge.length - mean * edge.direction;
    const Square<D> f = mean + along * edge.direction.transpose();
    SquareMap<D> kept(&deformation_[e * D * D]);
    const Square<D> rate = per_step * (f - kept), middle = 0.5 * (f + kept);
    kept = f;
    const Square<D> cofactor_of_middle = cofactor<D>(middle), cofactor_of_f = cofactor<D>(f);
    SquareMap<D> gradient(velocity_gradients), pulled(&share_[e * D * D]);
    gradient.noalias() = rate * cofactor_of_middle.transpose() / determinant<D>(middle, cofactor_of_middle);
    pulled = cofactor_of_f;
    const double volume_ratio = determinant<D>(f, cofactor_of_f);
    edge_density_[e] = particles.reference_density(i) / volume_ratio;
    if (!(volume_ratio > 0.0) && turned < 0) turned = edge.first;
  }
  return turned;
}

template <int D>
void EdgePoints<D>::pull_back(ParticleRange edges) {
  using StrainState = typename StrainStateOf<D>::Type;
  for (std::size_t e = edges.first(); e < edges.last(); ++e) {
    const Tensor full = StrainState::deviator(deviator_ + e * StrainState::components);
    const Square<D> deviator = full.template topLeftCorner<D, D>();
    SquareMap<D> share(&share_[e * D * D]);
    const Square<D> nominal = edges_[e].volume * (deviator * share);
    const Vec<D>& direction = edges_[e].direction;
    const Vec<D> along = nominal * direction;
    share = 0.5 * nominal - 0.5 * along * direction.transpose();
    Eigen::Map<Vec<D>> pull(&pull_[e * D]);
    pull = along / edges_[e].length;
  }
}

template <int D>
void EdgePoints<D>::weigh(ParticleRange edges, double span) {
  for (std::size_t k = edges.first() * D * D; k < edges.last() * D * D; ++k) share_[k] *= span;
  for (std::size_t k = edges.first() * D; k < edges.last() * D; ++k) pull_[k] *= span;
}

template <int D>
void EdgePoints<D>::add_nominal_stress(std::size_t i, Square<D>& sum) const {
  Square<D> own = Square<D>::Zero();
  for (std::int32_t k = first_incidence_[i]; k < first_incidence_[i + 1]; ++k) {
    const auto e = static_cast<std::size_t>(incidences_[static_cast<std::size_t>(k)].edge);
    own += edges_[e].part * ConstSquareMap<D>(&share_[e * D * D]);
  }
  if (transforms_of_[i] < 0) {
    sum += own;
    return;
  }
  const auto& transforms = transforms_[static_cast<std::size_t>(transforms_of_[i])];
  for (const Transform<D>& transform : transforms)
    sum += transform.turn * own * transform.turn.transpose() / static_cast<double>(transforms.size());
}

template <int D>
void EdgePoints<D>::accumulate(const PairTile<D>& tile, const PairRecords<D>& /*records*/, double* acceleration,
                               double* /*loss*/) const {
  for (auto i = static_cast<std::size_t>(tile.begin); i < static_cast<std::size_t>(tile.end); ++i, acceleration += D) {
    Vec<D> force = Vec<D>::Zero();
    for (std::int32_t k = first_incidence_[i]; k < first_incidence_[i + 1]; ++k) {
      const Incidence& incidence = incidences_[static_cast<std::size_t>(k)];
      const auto e = static_cast<std::size_t>(incidence.edge);
      force -= incidence.sign * edges_[e].part * Eigen::Map<const Vec<D>>(&pull_[e * D]);
    }
    if (transforms_of_[i] >= 0) {
      const auto& transforms = transforms_[static_cast<std::size_t>(transforms_of_[i])];
      Vec<D> all = Vec<D>::Zero();
      for (const Transform<D>& transform : transforms) all += transform.turn * force;
      force = all / static_cast<double>(transforms.size());
    }
    Eigen::Map<Vec<D>> own(acceleration);
    own += force / mass_[i];
  }
}

template <int D>
std::vector<double> EdgePoints<D>::mean_at_particles(const FieldKey& key) const {
  const auto field = std::find_if(fields_.fields().begin(), fields_.fields().end(),
                                  [&](const auto& one) { return one.key->name == key.name; });
  const auto components = static_cast<std::size_t>(field->components);
  std::vector<double> mean(mass_.size() * components, 0.0);
  for (std::size_t i = 0; i < mass_.size(); ++i) {
    double volume = 0.0;
    for (std::int32_t k = first_incidence_[i]; k < first_incidence_[i + 1]; ++k) {
      const auto e = static_cast<std::size_t>(incidences_[static_cast<std::size_t>(k)].edge);
      const double weight = edges_[e].volume * edges_[e].part;
      volume += weight;
      for (std::size_t c = 0; c < components; ++c)
        mean[i * components + c] += weight * field->values[e * components + c];
    }
    if (volume == 0.0) continue;
    for (std::size_t c = 0; c < components; ++c) mean[i * components + c] /= volume;
  }
  return mean;
}

template <int D>
double EdgePoints<D>::doubles_per_particle() const {
  double bytes = static_cast<double>(edges_.size() * sizeof(Edge) + incidences_.size() * sizeof(Incidence)) +
                 static_cast<double>(sizeof(double) * (share_.size() + pull_.size() + deformation_.size()));
  for (const auto& field : fields_.fields()) bytes += static_cast<double>(sizeof(double) * field.values.size());
  return mass_.empty() ? 0.0 : bytes / static_cast<double>(sizeof(double) * mass_.size());
}

template class EdgePoints<1>;
template class EdgePoints<2>;
template class EdgePoints<3>;

}  // namespace anvil
