// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/scene/schema.hpp"

#include <fmt/format.h>

#include "anvil/boundaries/boundary_tables.hpp"
#include "anvil/kernels/kernel.hpp"
#include "anvil/materials/material_tables.hpp"
#include "anvil/scene/shape.hpp"

namespace anvil {
namespace {

using Names = std::vector<std::string_view>;

Section<Scene> scene_section() {
  return {"",
          Occurrence::top_level,
          "What stands at the top of the file, before the first section.",
          {
              {{.name = "title", .kind = ValueKind::text, .standard = "", .help = "one line for figures and lists"},
               &Scene::title},
          }};
}

Section<Domain> domain_section() {
  return {
      "domain",
      Occurrence::once,
      "The space the scene lives in.",
      {
          {{.name = "dimension",
            .kind = ValueKind::integer,
            .help = "number of space dimensions of the particles",
            .choices = {"1", "2", "3"}},
           &Domain::dimension},
          {{.name = "strain_state",
            .kind = ValueKind::choice,
            .help = "what the directions without particles do: no strain (uniaxial_strain in 1D, plane_strain in 2D) "
                    "or no stress (uniaxial_stress in 1D); full in 3D",
            .choices = {"uniaxial_strain", "uniaxial_stress", "plane_strain", "full"},
            .optional = true,
            .derived = "uniaxial_strain in 1D, plane_strain in 2D, full in 3D"},
           &Domain::strain_state},
          {{.name = "gravity",
            .kind = ValueKind::vector,
            .unit = "m/s2",
            .standard = std::vector<double>{0.0},
            .help = "acceleration of all bodies by a force on their mass"},
           &Domain::gravity},
      }};
}

Section<Discretisation> discretisation_section() {
  const auto kernels = kernel_names();
  return {"discretisation",
          Occurrence::once,
          "How the bodies become particles and the derivatives become sums.",
          {
              {{.name = "method",
                .kind = ValueKind::choice,
                .standard = "sph",
                .help = "approximation of derivatives: sph is the plain one; kernel_gradient_correction corrects the "
                        "velocity gradient, cspm that and the divergence of stress, so that linear fields are exact; "
                        "total_lagrangian takes corrected gradients in the reference configuration",
                .choices = {"sph", "cspm", "kernel_gradient_correction", "total_lagrangian"}},
               &Discretisation::method},
              {{.name = "kernel",
                .kind = ValueKind::choice,
                .standard = "cubic_spline",
                .help = "smoothing kernel",
                .choices = Names(kernels.begin(), kernels.end())},
               &Discretisation::kernel},
              {{.name = "spacing",
                .unit = "m",
                .range = Range::positive,
                .help = "distance of neighbouring particles at the start"},
               &Discretisation::spacing},
              {{.name = "smoothing_ratio",
                .standard = 1.0,
                .range = Range::positive,
                .help = "smoothing length over spacing at the start"},
               &Discretisation::smoothing_ratio},
              {{.name = "momentum_form",
                .kind = ValueKind::choice,
                .help = "pair force: sum takes V_i V_j (sigma_i + sigma_j), density_squared takes m_i m_j "
                        "(sigma_i/rho_i^2 + sigma_j/rho_j^2); both conserve momentum. difference takes V_i V_j "
                        "(sigma_j - sigma_i). adjoint, of kernel_gradient_correction, takes V_i V_j (sigma_i B_i + "
                        "sigma_j B_j) with its corrections B: the only form there that conserves energy too",
                .choices = {"sum", "density_squared", "difference", "adjoint"},
                .optional = true,
                .derived = "difference for cspm, else sum"},
               &Discretisation::momentum_form},
              {{.name = "variable_smoothing_length",
                .kind = ValueKind::flag,
                .standard = true,
                .help = "whether the smoothing length grows and shrinks with the particle's volume"},
               &Discretisation::variable_smoothing_length},
          }};
}

Section<Shock> shock_section() {
  return {
      "shock",
      Occurrence::once,
      "What spreads a shock over a few particles.",
      {
          {{.name = "method",
            .kind = ValueKind::choice,
            .standard = "none",
            .help =
                "artificial_viscosity is that of Monaghan and Gingold (1983); fct is flux-corrected transport of "
                "velocity and stress, in 1D; hllc solves a Riemann problem per approaching pair; bulk_viscosity is a "
                "pressure against the rate of compression",
            .choices = {"none", "artificial_viscosity", "fct", "hllc", "bulk_viscosity"}},
           &Shock::method},
          {{.name = "linear_coefficient",
            .standard = 1.0,
            .range = Range::not_negative,
            .help = "alpha of the artificial viscosity, times the sound speed"},
           &Shock::linear_coefficient},
          {{.name = "quadratic_coefficient",
            .standard = 1.0,
            .range = Range::not_negative,
            .help = "beta of the artificial viscosity, against strong shocks"},
           &Shock::quadratic_coefficient},
          {{.name = "softening",
            .standard = 0.1,
            .range = Range::positive,
            .help = "eps of the artificial viscosity: keeps mu finite where particles meet"},
           &Shock::softening},
          {{.name = "bulk_linear_coefficient",
            .standard = 0.06,
            .range = Range::not_negative,
            .help = "of the bulk viscosity, times the sound speed"},
           &Shock::bulk_linear_coefficient},
          {{.name = "bulk_quadratic_coefficient",
            .standard = 1.2,
            .range = Range::not_negative,
            .help = "of the bulk viscosity, against strong shocks"},
           &Shock::bulk_quadratic_coefficient},
          {{.name = "diffusion",
            .standard = 0.125,
            .range = Range::half_fraction,
            .help = "eta1 of flux-corrected transport, the part of a difference that spreads per step"},
           &Shock::diffusion},
          {{.name = "antidiffusion",
            .standard = 0.125,
            .range = Range::half_fraction,
            .help = "eta2 of flux-corrected transport, the part that may be gathered again"},
           &Shock::antidiffusion},
          {{.name = "limiter",
            .kind = ValueKind::choice,
            .standard = "standard",
            .help = "of flux-corrected transport: standard is that of Boris and Book (1973), six_arguments that "
                    "printed by Wang (2002)",
            .choices = {"standard", "six_arguments"}},
           &Shock::limiter},
          {{.name = "pair_gradient",
            .kind = ValueKind::choice,
            .standard = "plain",
            .help =
                "gradient hllc sums its stress with: plain and symmetrised, the mean of both sides' corrected ones, "
                "keep momentum and energy to round-off; corrected, the published form, is exact for linear stress "
                "and keeps neither",
            .choices = {"plain", "corrected", "symmetrised"}},
           &Shock::pair_gradient},
          {{.name = "reconstruction",
            .kind = ValueKind::choice,
            .standard = "linear",
            .help =
                "states of the Riemann problems of hllc: constant takes those of the particles, as published; linear "
                "extrapolates them to the middle of the pair within limiters",
            .choices = {"linear", "constant"}},
           &Shock::reconstruction},
      }};
}

Section<Stabiliser> stabiliser_section() {
  return {
      "stabiliser",
      Occurrence::once,
      "What keeps particles from numerical fracture.",
      {
          {{.name = "method",
            .kind = ValueKind::choice,
            .standard = "none",
            .help = "against motions that gradients do not see, in total_lagrangian: edge_stress_points puts the "
                    "deviatoric stress on the edges of the lattice; hourglass_control pulls pairs to the distance that "
                    "their deformation gradients predict (Ganzenmueller 2015)",
            .choices = {"none", "edge_stress_points", "hourglass_control"}},
           &Stabiliser::method},
          {{.name = "hourglass_coefficient",
            .standard = 0.01,
            .range = Range::positive,
            .help = "of hourglass_control: its stiffness over Young's modulus"},
           &Stabiliser::hourglass_coefficient},
          {{.name = "conservative_smoothing",
            .standard = 0.0,
            .range = Range::half_fraction,
            .help = "part of the velocity replaced by the neighbours' mean after each step; 0 switches it off"},
           &Stabiliser::conservative_smoothing},
          {{.name = "smoothing_form",
            .kind = ValueKind::choice,
            .standard = "plain",
            .help =
                "plain takes the normalised mean (Long 2007), pairwise conserves momentum, scaled makes the strength "
                "independent of the time step",
            .choices = {"plain", "pairwise", "scaled"}},
           &Stabiliser::smoothing_form},
          {{.name = "density_diffusion",
            .standard = 0.0,
            .range = Range::fraction,
            .help = "delta of the diffusion of density between neighbours (Molteni and Colagrossi 2009), about 0.1; 0 "
                    "switches it off"},
           &Stabiliser::density_diffusion},
          {{.name = "non_affine_damping",
            .standard = 0.0,
            .range = Range::not_negative,
            .help = "linear viscosity on the part of a pair's velocity that the velocity gradients of its ends do not "
                    "explain, approaching or not, about 0.2; 0 switches it off"},
           &Stabiliser::non_affine_damping},
          {{.name = "erosion_stretch",
            .standard = 0.0,
            .range = Range::fraction,
            .help =
                "in total_lagrangian: stress points squeezed to a smaller part of their thickness, or turned inside "
                "out, carry no stress from then on, about 0.01; 0 switches it off"},
           &Stabiliser::erosion_stretch},
      }};
}

Section<TimeControl> time_section() {
  return {
      "time",
      Occurrence::once,
      "How long the run lasts and how it steps.",
      {
          {{.name = "end", .unit = "s", .range = Range::not_negative, .help = "simulated time at which the run stops"},
           &TimeControl::end},
          {{.name = "cfl",
            .standard = 0.3,
            .range = Range::positive,
            .help = "time step over the time a sound wave takes to cross a smoothing length"},
           &TimeControl::cfl},
          {{.name = "minimum_step_fraction",
            .standard = 1e-4,
            .range = Range::fraction,
            .help = "the run stops as collapsed when a step falls below this part of the first one"},
           &TimeControl::minimum_step_fraction},
          {{.name = "local_steps",
            .kind = ValueKind::flag,
            .standard = false,
            .help = "short steps only where a body of the method total_lagrangian is squeezed, long ones elsewhere"},
           &TimeControl::local_steps},
      }};
}

Section<BodyDescription> body_section() {
  return {
      "body",
      Occurrence::list,
      "A piece of one material; its particles start at its velocity and without pressure.",
      {
          {{.name = "name", .kind = ValueKind::name, .help = "name of the body, once in the scene"},
           &BodyDescription::name},
          {{.name = "shape", .kind = ValueKind::entry, .help = "the space the body fills", .entries = shape_kinds},
           &BodyDescription::shape},
          {{.name = "lattice",
            .kind = ValueKind::choice,
            .standard = "cubic",
            .help =
                "arrangement of the particles: cubic (a square one in 2D, a line in 1D) fills the shape with cells, "
                "so the outermost particles lie half a spacing inside its faces; face_lattice puts them on the "
                "corners of the cells, so the outermost lie on the faces with half of a volume; concentric fills a "
                "ring "
                "with layers",
            .choices = {"cubic", "face_lattice", "concentric"}},
           &BodyDescription::lattice},
          {{.name = "rotation",
            .kind = ValueKind::numbers,
            .unit = "rad",
            .standard = std::vector<double>{},
            .help =
                "turns the shape and its lattice about the origin: in 3D the axis times the angle, in 2D one angle; "
                "velocity and boundaries stay as they are given"},
           &BodyDescription::rotation},
          {{.name = "jitter",
            .standard = 0.0,
            .range = Range::half_fraction,
            .help = "each coordinate of each particle is moved at random by up to this part of the spacing, the same "
                    "way in every run"},
           &BodyDescription::jitter},
          {{.name = "material",
            .kind = ValueKind::name,
            .help = "name of a [material.NAME] of the scene or of a bundled material"},
           &BodyDescription::material},
          {{.name = "velocity",
            .kind = ValueKind::vector,
            .unit = "m/s",
            .standard = std::vector<double>{0.0},
            .help = "velocity at the start"},
           &BodyDescription::velocity},
          {{.name = "hydrostatic",
            .kind = ValueKind::flag,
            .standard = false,
            .help = "whether the body starts under the pressure of its own weight, that of its depth below its highest "
                    "point, instead of feeling domain.gravity all at once"},
           &BodyDescription::hydrostatic},
          {{.name = "radial_velocity",
            .unit = "m/s",
            .standard = 0.0,
            .help = "of a ring, added to its velocity: outward speed at the inner radius, falling with 1/r so that "
                    "areas are kept"},
           &BodyDescription::radial_velocity},
          {{.name = "deviatoric_stress",
            .kind = ValueKind::numbers,
            .unit = "Pa",
            .standard = std::vector<double>{},
            .help = "stress deviator at the start, tension positive: XX in 1D; XX, YY, XY in 2D; XX, YY, ZZ, XY, YZ, "
                    "XZ in 3D; empty: none"},
           &BodyDescription::deviatoric_stress},
      }};
}

Section<MaterialDescription> material_section() {
  return {
      "material",
      Occurrence::by_name,
      "A material: how it answers compression (eos) and shear (strength).",
      {
          {{.name = "density", .unit = "kg/m3", .range = Range::positive, .help = "density of the unloaded material"},
           &MaterialDescription::density},
          {{.name = "viscosity",
            .unit = "Pa s",
            .standard = 0.0,
            .range = Range::not_negative,
            .help = "mu of a viscous fluid (Morris 1997)"},
           &MaterialDescription::viscosity},
          {{.name = "eos", .kind = ValueKind::entry, .help = "equation of state", .entries = eos_kinds},
           &MaterialDescription::eos},
          {{.name = "strength",
            .kind = ValueKind::entry,
            .standard = "none",
            .help = "law of the stress deviator",
            .entries = strength_kinds},
           &MaterialDescription::strength},
      }};
}

Section<BoundaryDescription> boundary_section() {
  return {"boundary",
          Occurrence::list,
          "Something the bodies meet.",
          {
              {{.name = "name", .kind = ValueKind::name, .help = "name of the boundary, once in the scene"},
               &BoundaryDescription::name},
              {{.name = "type",
                .kind = ValueKind::entry,
                .help = "kind of boundary, whose own keys stand beside it",
                .entries = boundary_kinds},
               &BoundaryDescription::entry},
          }};
}

Section<OutputControl> output_section() {
  return {
      "output",
      Occurrence::once,
      "What a run writes, and when.",
      {
          {{.name = "interval",
            .unit = "s",
            .range = Range::positive,
            .help = "simulated time between frames; compare.times have frames too",
            .optional = true,
            .derived = "a twentieth of time.end, 1 s when that is zero"},
           &OutputControl::interval},
          {{.name = "frames",
            .kind = ValueKind::integer,
            .standard = 0LL,
            .range = Range::not_negative,
            .help = "number of frames after the first one, evenly over the run, in place of interval; 0: see there"},
           &OutputControl::frames},
          {{.name = "format",
            .kind = ValueKind::choice,
            .standard = "vtp",
            .help = "file format of the frames",
            .choices = {"vtp", "vtu", "hdf5"}},
           &OutputControl::format},
          {{.name = "precision",
            .kind = ValueKind::choice,
            .standard = "float32",
            .help = "precision of the arrays of a frame; positions are always double",
            .choices = {"float32", "float64"}},
           &OutputControl::precision},
          {{.name = "compression",
            .kind = ValueKind::choice,
            .standard = "lz4",
            .help = "compression of the frames",
            .choices = {"lz4", "none", "zlib"}},
           &OutputControl::compression},
          {{.name = "fields",
            .kind = ValueKind::choices,
            .standard = Texts{},
            .help = "fields written beside the usual ones, as far as the scene has them",
            .choices = {"deviatoric_stress", "back_stress", "mass"}},
           &OutputControl::fields},
          {{.name = "omit",
            .kind = ValueKind::choices,
            .standard = Texts{},
            .help = "usual fields that are not written: large series get smaller",
            .choices = {"initial_position", "velocity", "density", "pressure", "stress", "smoothing_length",
                        "plastic_strain", "specific_energy", "temperature"}},
           &OutputControl::omit},
          {{.name = "checkpoint_interval",
            .unit = "s",
            .standard = 0.0,
            .range = Range::not_negative,
            .help = "simulated time between checkpoints; 0 writes one at the end"},
           &OutputControl::checkpoint_interval},
      }};
}

Section<Comparison> compare_section() {
  return {"compare",
          Occurrence::once,
          "What the result is judged by.",
          {
              {{.name = "reference",
                .kind = ValueKind::text,
                .standard = "",
                .help = "name of a bundled reference; or exact, the exact solution of plane waves in finite strain, or "
                        "exact_small_strain. Without it the exact solution is taken where there is one"},
               &Comparison::reference},
              {{.name = "times",
                .kind = ValueKind::numbers,
                .unit = "s",
                .standard = std::vector<double>{},
                .range = Range::not_negative,
                .help = "of the frames that are held against an exact solution; empty: the last one"},
               &Comparison::times},
              {{.name = "tolerance",
                .kind = ValueKind::named_numbers,
                .standard = NamedNumbers{},
                .range = Range::positive,
                .help = "largest deviation allowed, by the name of a quantity that is compared; relative, but in "
                        "spacings for a "
                        "width"},
               &Comparison::tolerance},
          }};
}

}  // namespace

const Schema& schema() {
  static const Schema all{scene_section(),      domain_section(), discretisation_section(), shock_section(),
                          stabiliser_section(), time_section(),   body_section(),           material_section(),
                          boundary_section(),   output_section(), compare_section()};
  return all;
}

std::vector<SectionKeys> scene_sections() {
  std::vector<SectionKeys> sections;
  const Scene none{};
  for_each_section(none, [&](const auto& section, const auto&) {
    sections.push_back({section.name, section.occurrence, section.help, {}});
    for (const auto& row : section.rows) sections.back().keys.push_back(&row.key);
  });
  return sections;
}

std::string section_heading(std::string_view name, Occurrence occurrence) {
  switch (occurrence) {
    case Occurrence::once:
      return fmt::format("[{}]", name);
    case Occurrence::list:
      return fmt::format("[[{}]]", name);
    case Occurrence::by_name:
      return fmt::format("[{}.NAME]", name);
    case Occurrence::top_level:
      break;
  }
  return "";
}

}  // namespace anvil
