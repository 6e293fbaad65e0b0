// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/recipe.hpp"

#include <algorithm>
#include <cmath>

#include "anvil/core/field_keys.hpp"
#include "anvil/materials/material_tables.hpp"
#include "anvil/scene/placement.hpp"
#include "anvil/scene/shape.hpp"
#include "anvil/terms/adjoint_momentum.hpp"
#include "anvil/terms/conservative_smoothing.hpp"
#include "anvil/terms/hllc.hpp"
#include "anvil/terms/hourglass_control.hpp"
#include "anvil/terms/laminar_viscosity.hpp"
#include "anvil/terms/momentum.hpp"
#include "anvil/terms/nominal_momentum.hpp"
#include "anvil/terms/non_affine_damping.hpp"
#include "anvil/terms/viscosity.hpp"

namespace anvil {
namespace {

const MaterialDescription& material_of(const Scene& scene, const BodyDescription& body) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const MaterialDescription& material) { return material.name == body.material; });
  if (found == scene.materials.end())
    throw InputError("body '" + body.name + "' names material '" + body.material +
                     "', which the scene does not define");
  return *found;
}

template <int D>
Vec<D> vector_of(const std::vector<double>& components) {
  // A single number stands for the same number in each component, as in the schema's default of zero.
  Vec<D> vector;
  for (int a = 0; a < D; ++a)
    vector[a] = components.size() == 1 ? components[0] : components[static_cast<std::size_t>(a)];
  return vector;
}

/// c = sqrt(K / rho) of the unloaded material, m/s.
double bulk_sound_speed(const MaterialDescription& material) {
  return std::sqrt(std::visit([&](const auto& eos) { return eos.bulk_sound_speed_squared(material.density, 0.0); },
                              make_eos(material.eos, material.density)));
}

/// c_e = sqrt((K + 4 G / 3) / rho) of the unloaded material, m/s.
double elastic_wave_speed(const MaterialDescription& material) {
  const double bulk = std::visit([&](const auto& eos) { return eos.bulk_sound_speed_squared(material.density, 0.0); },
                                 make_eos(material.eos, material.density));
  const double shear =
      std::visit([](const auto& law) { return law.shear_modulus(); }, make_strength(material.strength));
  return std::sqrt(bulk + 4.0 / 3.0 * shear / material.density);
}

/// Density at which a body carries the weight of what lies above a position, rho0 g depth, found by bisection.
template <int D>
double density_under_weight(const Scene& scene, const BodyDescription& body, const Vec<D>& position) {
  const MaterialDescription& material = material_of(scene, body);
  const Vec<D> gravity = vector_of<D>(scene.domain.gravity);
  const auto shape = make_shape<D>(body.shape);
  const Vec<D> up = gravity.norm() > 0.0 ? Vec<D>(-gravity.normalized()) : gravity;
  const double depth = shape->reach(up) - up.dot(position - shape->centre());
  const double pressure = material.density * gravity.norm() * std::max(depth, 0.0);
  const Eos eos = make_eos(material.eos, material.density);
  double light = material.density, dense = 2.0 * material.density;
  for (int k = 0; k < 60; ++k) {  // to the last bit
    const double middle = 0.5 * (light + dense);
    const double reached = std::visit([&](const auto& law) { return law.pressure(middle, 0.0); }, eos);
    (reached < pressure ? light : dense) = middle;
  }
  return light;
}

/// Pa, of the unloaded material; zero for a fluid.
double youngs_modulus(const MaterialDescription& material) {
  const double bulk = material.density * std::pow(bulk_sound_speed(material), 2);
  const double shear =
      std::visit([](const auto& law) { return law.shear_modulus(); }, make_strength(material.strength));
  return shear == 0.0 ? 0.0 : 9.0 * bulk * shear / (3.0 * bulk + shear);
}

/// Axial stress over strain of the unloaded material in a line, Pa: K + 4 G / 3, or Young's modulus of a bar.
double axial_modulus(const Scene& scene, const MaterialDescription& material) {
  const double speed = elastic_wave_speed(material), modulus = youngs_modulus(material);
  return scene.domain.strain_state == "uniaxial_stress" && modulus > 0.0 ? modulus : material.density * speed * speed;
}

MomentumForm momentum_form_of(const Scene& scene) {
  const std::string& form = scene.discretisation.momentum_form;
  if (form == "difference") return MomentumForm::difference;
  return form == "density_squared" ? MomentumForm::density_squared : MomentumForm::sum;
}

/// Sums with corrected gradients see a full neighbourhood at the ends of a line only with images behind them.
bool corrects_forces(const Scene& scene) {
  if (scene.shock.method == "hllc") return scene.shock.pair_gradient == "corrected";
  return momentum_form_of(scene) == MomentumForm::difference;
}

template <int D>
void add_forces(const Scene& scene, FieldStore& fields, Recipe<D>& recipe) {
  const MomentumForm form = momentum_form_of(scene);
  if (scene.shock.method == "bulk_viscosity")
    recipe.bulk_viscosity =
        std::make_unique<BulkViscosity<D>>(fields, scene.shock.bulk_linear_coefficient,
                                           scene.shock.bulk_quadratic_coefficient, scene.discretisation.spacing);
  if (recipe.deformation) {
    auto momentum = std::make_unique<NominalMomentum<D>>(fields, *recipe.deformation, recipe.edges);
    recipe.nominal_momentum = momentum.get();
    recipe.forces.push_back(std::move(momentum));
    return;
  }
  recipe.corrected_gradients = scene.discretisation.method != "sph";
  if (scene.shock.method == "hllc") {
    typename Hllc<D>::Strengths strengths;
    for (const auto& body : recipe.bodies) strengths.push_back({body.range, body.strength.get()});
    HllcChoices choices{.gradient = PairGradient::plain, .reconstructs = scene.shock.reconstruction == "linear"};
    if (scene.shock.pair_gradient == "corrected") choices.gradient = PairGradient::corrected;
    if (scene.shock.pair_gradient == "symmetrised") choices.gradient = PairGradient::symmetrised;
    recipe.forces.push_back(std::make_unique<Hllc<D>>(fields, std::move(strengths), choices));
    return;
  }
  if (scene.discretisation.momentum_form == "adjoint")
    recipe.forces.push_back(std::make_unique<AdjointMomentum<D>>(fields));
  else
    recipe.forces.push_back(std::make_unique<Momentum<D>>(fields, form));
  if (scene.shock.method == "artificial_viscosity") {
    const ViscosityCoefficients coefficients{.linear = scene.shock.linear_coefficient,
                                             .quadratic = scene.shock.quadratic_coefficient,
                                             .softening = scene.shock.softening};
    recipe.forces.push_back(std::make_unique<Viscosity<D>>(coefficients));
  }
  const auto is_viscous = [](const MaterialDescription& material) { return material.viscosity > 0.0; };
  if (std::any_of(scene.materials.begin(), scene.materials.end(), is_viscous))
    recipe.forces.push_back(std::make_unique<LaminarViscosity<D>>());
}

/// Against the motions of pairs that gradients do not see.
template <int D>
void add_pair_stabilisers(const Scene& scene, const std::vector<ParticleRange>& ranges, FieldStore& fields,
                          Recipe<D>& recipe) {
  if (scene.stabiliser.method == "hourglass_control") {
    std::vector<typename HourglassControl<D>::Stiffness> bodies;
    for (std::size_t b = 0; b < ranges.size(); ++b)
      bodies.push_back(
          {ranges[b], scene.stabiliser.hourglass_coefficient * youngs_modulus(material_of(scene, scene.bodies[b]))});
    recipe.forces.push_back(
        std::make_unique<HourglassControl<D>>(fields, *recipe.deformation, recipe.kernel, bodies, recipe.images));
  }
  if (scene.stabiliser.non_affine_damping > 0.0)
    recipe.forces.push_back(std::make_unique<NonAffineDamping<D>>(fields, scene.stabiliser.non_affine_damping));
}

template <int D>
void add_filters(const Scene& scene, Recipe<D>& recipe) {
  if (scene.stabiliser.conservative_smoothing <= 0.0) return;
  SmoothingForm form = SmoothingForm::plain;
  if (scene.stabiliser.smoothing_form == "pairwise") form = SmoothingForm::pairwise;
  if (scene.stabiliser.smoothing_form == "scaled") form = SmoothingForm::scaled;
  double fastest = 0.0;
  for (const auto& material : scene.materials) fastest = std::max(fastest, elastic_wave_speed(material));
  // The step of the printed rule for the unloaded material at rest, at the paper's factor 0.3.
  const double reference_step = 0.3 * scene.discretisation.smoothing_ratio * scene.discretisation.spacing / fastest;
  recipe.filters.push_back(
      std::make_unique<ConservativeSmoothing<D>>(form, scene.stabiliser.conservative_smoothing, reference_step));
}

PressureLoad make_load(const Scene& scene, const BoundaryDescription& boundary,
                       const std::vector<ParticleRange>& ranges, std::span<const double> positions) {
  const Parameters& parameters = boundary.entry.parameters;
  const auto body = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                 [&](const auto& one) { return one.name == parameters.text("body"); });
  if (body == scene.bodies.end())
    throw InputError("boundary '" + boundary.name + "' names the body '" + parameters.text("body") +
                     "', which the scene does not define");
  const ParticleRange range = ranges[static_cast<std::size_t>(body - scene.bodies.begin())];
  const auto ends = std::minmax_element(positions.begin() + range.begin, positions.begin() + range.end);
  const bool left = parameters.text("face") == "left";
  return {static_cast<std::size_t>((left ? ends.first : ends.second) - positions.begin()), left ? 1.0 : -1.0,
          make_load_history(parameters)};
}

/// What needs the order of particles in a line.
void add_line_terms(const Scene& scene, const std::vector<ParticleRange>& ranges, FieldStore& fields,
                    Recipe<1>& recipe) {
  for (const auto& boundary : scene.boundaries)
    if (boundary.entry.type == "pressure")
      recipe.loads.push_back(make_load(scene, boundary, ranges, fields.scalar(field::position)));
  const auto order = line_order(fields.scalar(field::position));
  if (corrects_forces(scene)) recipe.face_ghosts = std::make_unique<FaceGhosts>(fields, order, recipe.support);
  if (scene.shock.method != "fct") return;
  TransportCoefficients coefficients{.diffusion = scene.shock.diffusion, .antidiffusion = scene.shock.antidiffusion};
  if (scene.shock.limiter == "six_arguments") coefficients.limiter = FluxLimiter::six_arguments;
  std::vector<double> modulus;
  for (const auto& body : scene.bodies) modulus.push_back(axial_modulus(scene, material_of(scene, body)));
  recipe.transport = std::make_unique<LineTransport>(fields, order, ranges, modulus, recipe.support, coefficients);
}

/// The surfaces that bodies meet with, numbered as their particles are.
template <int D>
std::vector<Surface<D>> surfaces_of(const Scene& scene, const std::vector<ParticleRange>& ranges) {
  std::vector<Surface<D>> surfaces(scene.bodies.size());
  for (std::size_t b = 0; b < surfaces.size(); ++b) {
    Surface<D>& surface = surfaces[b];
    surface.facets = place_body<D>(scene.bodies[b], scene.discretisation.spacing).facets;
    for (BodyFacet<D>& facet : surface.facets)
      for (std::size_t k = 0; k < (D == 1 ? 1 : facet.size()); ++k) {
        facet[k] += ranges[b].begin;
        surface.particles.push_back(facet[k]);
      }
    std::sort(surface.particles.begin(), surface.particles.end());
    surface.particles.erase(std::unique(surface.particles.begin(), surface.particles.end()), surface.particles.end());
  }
  return surfaces;
}

/// Walls whose force follows from the depth of faces behind them.
template <int D>
void add_wall_penalties(const Scene& scene, const std::vector<ParticleRange>& ranges, FieldStore& fields,
                        Recipe<D>& recipe) {
  const double spacing = scene.discretisation.spacing;
  double stiffest = 0.0;  // Pa
  for (const auto& material : scene.materials)
    stiffest = std::max(stiffest, material.density * std::pow(elastic_wave_speed(material), 2));
  for (const auto& boundary : scene.boundaries) {
    const Parameters& parameters = boundary.entry.parameters;
    if (boundary.entry.type != "rigid_wall" || parameters.text("contact") != "penalty") continue;
    std::vector<SurfacePoint<D>> faces;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
      for (SurfacePoint<D> point : place_body<D>(scene.bodies[b], spacing).surface) {
        point.particle += ranges[b].begin;
        faces.push_back(point);
      }
    auto penalty = std::make_unique<WallPenalty<D>>(
        vector_of<D>(parameters.numbers("point")), vector_of<D>(parameters.numbers("normal")).normalized(),
        parameters.number("stiffness") * stiffest / spacing, std::move(faces), fields, *recipe.deformation);
    recipe.wall_penalties.push_back(penalty.get());
    recipe.forces.push_back(std::move(penalty));
  }
}

template <int D>
void add_walls(const Scene& scene, const Walls<D>& walls, FieldStore& fields, Recipe<D>& recipe) {
  if (walls.empty()) return;
  double stiffest = 0.0, fastest = 0.0;
  for (const auto& material : scene.materials) {
    const double speed = bulk_sound_speed(material);
    stiffest = std::max(stiffest, material.density * speed * speed);
    fastest = std::max(fastest, speed);
    recipe.wall_sound_speed = std::max(recipe.wall_sound_speed, elastic_wave_speed(material));
    recipe.wall_viscosity = std::max(recipe.wall_viscosity, material.viscosity);
  }
  add_wall_forces<D>(scene, walls, stiffest, fastest, fields, recipe);
}

/// u = U r_inner / r along the radius, which keeps areas.
template <int D>
Vec<D> radial_velocity(const BodyDescription& body, const Vec<D>& position) {
  if (body.radial_velocity == 0.0) return Vec<D>::Zero();
  const Parameters& ring = body.shape.parameters;
  const Vec<D> arm = position - vector_of<D>(ring.numbers("centre"));
  return body.radial_velocity * ring.number("inner_radius") / arm.squaredNorm() * arm;
}

bool keeps_energy(const Scene& scene) {
  return scene.shock.method == "hllc" ||
         std::any_of(scene.materials.begin(), scene.materials.end(),
                     [](const auto& material) { return uses_energy(make_eos(material.eos, material.density)); });
}

template <int D>
void set_deviator(const BodyDescription& body, ParticleRange range, FieldStore& fields) {
  if (body.deviatoric_stress.empty()) return;
  const auto stored = fields.vector<symmetric_components<D>>(field::deviatoric_stress);
  for (std::size_t i = range.first(); i < range.last(); ++i)
    stored[i] = Vec<symmetric_components<D>>(body.deviatoric_stress.data());
}

template <class Terms>
PairNeeds needs_of(const Terms& terms) {
  PairNeeds needs;
  for (const auto& term : terms) {
    needs.gradient |= term->needs().gradient;
    needs.plain_gradient |= term->needs().plain_gradient;
    needs.value |= term->needs().value;
    needs.medium |= term->needs().medium;
    needs.nominal |= term->needs().nominal;
    needs.response |= term->needs().response;
    needs.slope |= term->needs().slope;
    needs.correction |= term->needs().correction;
  }
  return needs;
}

}  // namespace

template <int D>
FieldStore place_particles(const Scene& scene, std::vector<ParticleRange>& ranges, Walls<D>& walls) {
  std::vector<PlacedBody<D>> placed;
  std::size_t particles = 0;
  for (const auto& body : scene.bodies) {
    placed.push_back(place_body<D>(body, scene.discretisation.spacing));
    const std::size_t begin = particles;
    particles += placed.back().positions.size();
    ranges.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(particles)});
  }
  walls = plan_walls<D>(scene, particles);
  FieldStore fields(walls.empty() ? particles : walls.back()->range().last());
  for (const FieldKey* key : {&field::position, &field::initial_position, &field::velocity}) fields.require(*key, D);
  for (const FieldKey* key : {&field::mass, &field::density, &field::smoothing_length}) fields.require(*key);
  for (std::size_t b = 0; b < placed.size(); ++b) {
    const double density = material_of(scene, scene.bodies[b]).density;
    const Vec<D> velocity = vector_of<D>(scene.bodies[b].velocity);
    const auto weighed_down = [&](const Vec<D>& position) {
      return density_under_weight<D>(scene, scene.bodies[b], position);
    };
    for (std::size_t i = ranges[b].first(); i < ranges[b].last(); ++i) {
      const std::size_t local = i - ranges[b].first();
      fields.vector<D>(field::position)[i] = placed[b].positions[local];
      fields.vector<D>(field::initial_position)[i] = placed[b].positions[local];
      fields.vector<D>(field::velocity)[i] = velocity + radial_velocity<D>(scene.bodies[b], placed[b].positions[local]);
      fields.scalar(field::density)[i] = density;
      if (scene.bodies[b].hydrostatic) fields.scalar(field::density)[i] = weighed_down(placed[b].positions[local]);
      fields.scalar(field::mass)[i] = fields.scalar(field::density)[i] * placed[b].volumes[local];
      fields.scalar(field::smoothing_length)[i] = scene.discretisation.smoothing_ratio * scene.discretisation.spacing;
    }
  }
  for (const auto& wall : walls) {
    const double density = scene.materials.front().density;
    for (std::size_t i = wall->range().first(); i < wall->range().last(); ++i) {
      fields.vector<D>(field::position)[i] = fields.vector<D>(field::initial_position)[i] = wall->position(i);
      fields.scalar(field::density)[i] = density;
      fields.scalar(field::mass)[i] = density * wall->volume();
      fields.scalar(field::smoothing_length)[i] = scene.discretisation.smoothing_ratio * scene.discretisation.spacing;
    }
  }
  return fields;
}

template <int D>
Recipe<D> make_recipe(const Scene& scene, const std::vector<ParticleRange>& ranges, const Walls<D>& walls,
                      FieldStore& fields) {
  Recipe<D> recipe;
  recipe.density_diffusion = scene.stabiliser.density_diffusion;
  recipe.gravity = vector_of<D>(scene.domain.gravity);
  recipe.kernel = make_kernel(scene.discretisation.kernel);
  recipe.support = std::visit([](const auto& kernel) { return kernel.support; }, recipe.kernel);
  recipe.variable_smoothing_length =
      scene.discretisation.variable_smoothing_length && scene.discretisation.method != "total_lagrangian";
  if (keeps_energy(scene)) fields.require(field::specific_energy);
  std::unique_ptr<EdgePoints<D>> edges;
  add_boundaries(scene, recipe);
  if (scene.discretisation.method == "total_lagrangian") recipe.deformation = std::make_unique<Deformation<D>>(fields);
  if (scene.stabiliser.method == "edge_stress_points") {
    edges = std::make_unique<EdgePoints<D>>(fields, ranges, scene.discretisation.spacing, recipe.images);
    recipe.edges = edges.get();
  }
  if (scene.stabiliser.erosion_stretch > 0.0) {
    recipe.erosion = scene.stabiliser.erosion_stretch;
    fields.require(field::eroded);
    if (edges) edges->fields().require(field::eroded);
  }
  for (std::size_t b = 0; b < ranges.size(); ++b) {
    const MaterialDescription& material = material_of(scene, scene.bodies[b]);
    const Strength strength = make_strength(material.strength);
    const Eos eos = make_eos(material.eos, material.density);
    recipe.bodies.push_back(
        {.name = scene.bodies[b].name,
         .range = ranges[b],
         .strength = make_strength_update<D>(strength, edges ? edges->fields() : fields),
         .strength_range = edges ? edges->edges_from(ranges[b]) : ranges[b],
         .eos = make_eos_update<D>(eos, fields),
         .lateral_release = nullptr,
         .face_distance = scene.bodies[b].lattice == "face_lattice" ? 0.0 : 0.5 * scene.discretisation.spacing,
         .viscosity = material.viscosity});
    set_deviator<D>(scene.bodies[b], ranges[b], fields);
    if (scene.domain.strain_state == "uniaxial_stress")
      recipe.bodies.back().lateral_release = make_lateral_release(strength, eos, fields);
  }
  add_forces(scene, fields, recipe);
  if (edges) recipe.forces.push_back(std::move(edges));
  add_pair_stabilisers(scene, ranges, fields, recipe);
  add_filters(scene, recipe);
  add_wall_penalties(scene, ranges, fields, recipe);
  if (recipe.deformation && scene.bodies.size() > 1)
    recipe.contact = std::make_unique<Contact<D>>(surfaces_of<D>(scene, ranges), fields, scene.discretisation.spacing);
  add_walls(scene, walls, fields, recipe);
  if constexpr (D == 1) add_line_terms(scene, ranges, fields, recipe);
  recipe.force_needs = needs_of(recipe.forces);
  recipe.filter_needs = needs_of(recipe.filters);
  return recipe;
}

template FieldStore place_particles<1>(const Scene&, std::vector<ParticleRange>&, Walls<1>&);
template FieldStore place_particles<2>(const Scene&, std::vector<ParticleRange>&, Walls<2>&);
template FieldStore place_particles<3>(const Scene&, std::vector<ParticleRange>&, Walls<3>&);
template Recipe<1> make_recipe<1>(const Scene&, const std::vector<ParticleRange>&, const Walls<1>&, FieldStore&);
template Recipe<2> make_recipe<2>(const Scene&, const std::vector<ParticleRange>&, const Walls<2>&, FieldStore&);
template Recipe<3> make_recipe<3>(const Scene&, const std::vector<ParticleRange>&, const Walls<3>&, FieldStore&);

}  // namespace anvil
