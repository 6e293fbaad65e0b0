// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/scene_plate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "anvil/core/error.hpp"

namespace anvil {
namespace {

constexpr double same_place = 1e-6;  // of a spacing: above the rounding of decimal lengths, far below an effect

[[noreturn]] void refuse(const std::string& reason) {
  throw InputError(fmt::format("there is no exact solution of this scene: {}", reason));
}

struct Span {
  double begin, end;  // m
};

Span span_of(const BodyDescription& body) {
  if (body.shape.type != "interval") refuse(fmt::format("the body '{}' is no interval", body.name));
  return {body.shape.parameters.number("min"), body.shape.parameters.number("max")};
}

const MaterialDescription& material_of(const Scene& scene, const BodyDescription& body) {
  const auto found = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [&](const auto& material) { return material.name == body.material; });
  if (found == scene.materials.end()) refuse(fmt::format("the material '{}' is missing", body.material));
  return *found;
}

ElasticPlasticConstants constants_of(const MaterialDescription& material) {
  const Parameters& keys = material.strength.parameters;
  if (material.strength.type == "none") return {};
  if (material.strength.type == "elastic") return {.shear_modulus = keys.number("shear_modulus")};
  if (material.strength.type == "j2")
    return {.shear_modulus = keys.number("shear_modulus"),
            .yield_stress = keys.number("yield_stress"),
            .hardening_modulus = keys.number("hardening_modulus"),
            .isotropic_fraction = keys.number("isotropic_fraction")};
  refuse(fmt::format("it is known for the strength laws none, elastic and j2, and the material '{}' has {}",
                     material.name, material.strength.type));
}

WaveMaterial wave_material(const Scene& scene, const MaterialDescription& material, StrainMeasure measure) {
  const ElasticPlasticConstants constants = constants_of(material);
  const PressureLaw law = pressure_law_of(material);
  const double bulk_modulus = std::visit([](const auto& one) { return one.bulk_stiffness(); }, law);
  if (scene.domain.strain_state == "uniaxial_stress") {
    const double shear_modulus = constants.shear_modulus;
    const double young_modulus = 9.0 * bulk_modulus * shear_modulus / (3.0 * bulk_modulus + shear_modulus);
    return WaveMaterial::uniaxial_stress(material.density, young_modulus, constants);
  }
  if (measure == StrainMeasure::small) return WaveMaterial::small_strain(material.density, bulk_modulus, constants);
  return WaveMaterial::finite_strain(material.density, law, constants);
}

/// From left to right.
std::vector<const BodyDescription*> bodies_in_order(const Scene& scene) {
  std::vector<const BodyDescription*> bodies;
  for (const auto& body : scene.bodies) bodies.push_back(&body);
  std::sort(bodies.begin(), bodies.end(), [](auto* a, auto* b) { return span_of(*a).begin < span_of(*b).begin; });
  for (std::size_t i = 1; i < bodies.size(); ++i)
    if (std::abs(span_of(*bodies[i]).begin - span_of(*bodies[i - 1]).end) > same_place * scene.discretisation.spacing)
      refuse(fmt::format("the bodies '{}' and '{}' do not touch", bodies[i - 1]->name, bodies[i]->name));
  return bodies;
}

PressureHistory pressure_history(const Parameters& load) {
  const std::string& history = load.text("history");
  if (history == "rectangular") return PressureHistory::rectangular(load.number("value"), load.number("duration"));
  if (history == "exponential") return PressureHistory::exponential(load.number("value"), load.number("decay"));
  if (history == "half_sine") return PressureHistory::half_sine(load.number("value"), load.number("duration"));
  if (history != "tabulated") refuse(fmt::format("it knows no {} pressure", history));
  std::vector<double> times, pressures;
  for (const auto& point : load.points("table")) {
    times.push_back(point.at(0));
    pressures.push_back(point.at(1));
  }
  return PressureHistory::tabulated(times, pressures);
}

void set_pressure(const BoundaryDescription& boundary, const std::vector<const BodyDescription*>& bodies,
                  PlateProblem& problem) {
  const Parameters& load = boundary.entry.parameters;
  const bool on_left = load.text("face") == "left";
  const BodyDescription& outermost = on_left ? *bodies.front() : *bodies.back();
  if (load.text("body") != outermost.name)
    refuse(fmt::format("the pressure '{}' acts on the {} face of '{}', which is not the end of the line of bodies",
                       boundary.name, load.text("face"), load.text("body")));
  PlateFace& face = on_left ? problem.left_face : problem.right_face;
  if (face.rigid || face.pressure.peak() > 0.0)
    refuse(fmt::format("the boundary '{}' acts on a face that another boundary holds", boundary.name));
  face.pressure = pressure_history(load);
}

void set_wall(const BoundaryDescription& boundary, double spacing, PlateProblem& problem) {
  const bool on_left = boundary.entry.parameters.numbers("normal").at(0) > 0.0;
  const double position = boundary.entry.parameters.numbers("point").at(0);
  const double end = on_left ? problem.left_position : problem.left_position + problem.thickness();
  if (std::abs(position - end) > same_place * spacing)
    refuse(fmt::format("the wall '{}' does not touch the bodies at the start", boundary.name));
  PlateFace& face = on_left ? problem.left_face : problem.right_face;
  if (face.rigid || face.pressure.peak() > 0.0)
    refuse(fmt::format("the boundary '{}' acts on a face that another boundary holds", boundary.name));
  face.rigid = true;
}

}  // namespace

PressureLaw pressure_law_of(const MaterialDescription& material) {
  const Parameters& keys = material.eos.parameters;
  if (material.eos.type == "linear") return PressureLinearInDensity{keys.number("bulk_modulus")};
  if (material.eos.type == "stiffened_gas")
    return PressureStiffenedGas{material.density, keys.number("sound_speed"), keys.number("gamma")};
  if (material.eos.type == "mie_grueneisen")
    return PressureMieGrueneisen{material.density, keys.number("sound_speed"), keys.number("slope"),
                                 keys.number("grueneisen")};
  refuse(fmt::format(
      "it is known for the equations of state linear, stiffened_gas and mie_grueneisen, and the material '{}' has {}",
      material.name, material.eos.type));
}

PlateProblem plate_problem(const Scene& scene, StrainMeasure measure) {
  if (scene.domain.dimension != 1) refuse(fmt::format("it has {} dimensions", scene.domain.dimension));
  if (scene.bodies.empty()) refuse("it has no body");
  const auto bodies = bodies_in_order(scene);
  PlateProblem problem;
  problem.left_position = span_of(*bodies.front()).begin;
  for (const BodyDescription* body : bodies) {
    const Span span = span_of(*body);
    problem.layers.push_back({.thickness = span.end - span.begin,
                              .material = wave_material(scene, material_of(scene, *body), measure),
                              .velocity = body->velocity.at(0),
                              .deviator = body->deviatoric_stress.empty() ? 0.0 : body->deviatoric_stress[0]});
  }
  for (const auto& boundary : scene.boundaries) {
    if (boundary.entry.type == "pressure")
      set_pressure(boundary, bodies, problem);
    else if (boundary.entry.type == "rigid_wall")
      set_wall(boundary, scene.discretisation.spacing, problem);
    else
      refuse(fmt::format("it knows no boundary of type {}, as '{}' is", boundary.entry.type, boundary.name));
  }
  return problem;
}

bool is_elastic(const Scene& scene) {
  return std::all_of(scene.materials.begin(), scene.materials.end(),
                     [](const auto& material) { return material.strength.type != "j2"; });
}

}  // namespace anvil
