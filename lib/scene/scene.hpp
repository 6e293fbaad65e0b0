// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/core/tensor.hpp"

namespace anvil {

using Points = std::vector<std::vector<double>>;

using Texts = std::vector<std::string>;
using NamedNumbers = std::map<std::string, double>;

/// One value of a scene file, after reading: what TOML can hold and Anvil understands.
using Value = std::variant<double, long long, bool, std::string, std::vector<double>, Points, Texts, NamedNumbers>;

/// The validated keys of one typed entry (a shape, a law, a boundary), by name. Every key of the entry's table is
/// present: given by the user or by its default. Keys that are optional and absent are not in the map.
class Parameters {
 public:
  void set(const std::string& key, Value value) { values_[key] = std::move(value); }
  [[nodiscard]] bool has(const std::string& key) const { return values_.count(key) != 0; }
  [[nodiscard]] double number(const std::string& key) const { return get<double>(key); }
  [[nodiscard]] long long integer(const std::string& key) const { return get<long long>(key); }
  [[nodiscard]] bool flag(const std::string& key) const { return get<bool>(key); }
  [[nodiscard]] const std::string& text(const std::string& key) const { return get<std::string>(key); }
  [[nodiscard]] const std::vector<double>& numbers(const std::string& key) const {
    return get<std::vector<double>>(key);
  }
  [[nodiscard]] const Texts& texts(const std::string& key) const { return get<Texts>(key); }
  [[nodiscard]] const Points& points(const std::string& key) const { return get<Points>(key); }
  [[nodiscard]] const std::map<std::string, Value>& all() const { return values_; }
  bool operator==(const Parameters&) const = default;

 private:
  template <class T>
  const T& get(const std::string& key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw InputError("parameter '" + key + "' is missing");
    return std::get<T>(found->second);
  }
  std::map<std::string, Value> values_;
};

/// An entry that names its kind by `type`: a shape, an equation of state, a strength law, a boundary.
struct TypedEntry {
  std::string type;
  Parameters parameters;
  bool operator==(const TypedEntry&) const = default;
};

struct Domain {
  int dimension;
  std::string strain_state;
  std::vector<double> gravity;  // m/s2
  bool operator==(const Domain&) const = default;
};

struct Discretisation {
  std::string method;
  std::string kernel;
  double spacing;          // m
  double smoothing_ratio;  // h / spacing
  std::string momentum_form;
  bool variable_smoothing_length;
  bool operator==(const Discretisation&) const = default;
};

struct Shock {
  std::string method;
  double linear_coefficient;     // alpha of Monaghan and Gingold
  double quadratic_coefficient;  // beta
  double softening;              // eps
  double bulk_linear_coefficient;
  double bulk_quadratic_coefficient;
  double diffusion;      // eta1 of flux-corrected transport
  double antidiffusion;  // eta2
  std::string limiter;
  std::string pair_gradient;   // of hllc
  std::string reconstruction;  // of hllc
  bool operator==(const Shock&) const = default;
};

struct Stabiliser {
  std::string method;
  double conservative_smoothing;  // alpha_cs, 0 switches it off
  std::string smoothing_form;
  double density_diffusion;      // delta, 0 switches it off
  double hourglass_coefficient;  // alpha of the method hourglass_control
  double non_affine_damping;     // of pair velocities beside the velocity gradient, 0 switches it off
  double erosion_stretch;        // of total Lagrangian stress points, 0 switches it off
  bool operator==(const Stabiliser&) const = default;
};

struct TimeControl {
  double end;  // s
  double cfl;
  double minimum_step_fraction;  // of the first step: below it the run stops as collapsed
  bool local_steps;              // short steps only where a total Lagrangian body is squeezed
  bool operator==(const TimeControl&) const = default;
};

struct BodyDescription {
  std::string name;
  TypedEntry shape;
  std::string lattice;
  std::vector<double> rotation;  // rad, about the origin: axis times angle in 3D, one angle in 2D; empty: none
  double jitter;                 // of a spacing
  std::string material;
  std::vector<double> velocity;  // m/s, `dimension` components
  bool hydrostatic;
  double radial_velocity;                 // m/s, of a ring at its inner radius
  std::vector<double> deviatoric_stress;  // Pa, packed (XX | XX YY XY | XX YY ZZ XY YZ XZ); empty: none
  bool operator==(const BodyDescription&) const = default;
};

struct MaterialDescription {
  std::string name;
  double density;    // kg/m3, of the unloaded material
  double viscosity;  // Pa s
  TypedEntry eos;
  TypedEntry strength;
  bool operator==(const MaterialDescription&) const = default;
};

struct BoundaryDescription {
  std::string name;
  TypedEntry entry;
  bool operator==(const BoundaryDescription&) const = default;
};

struct OutputControl {
  double interval;  // s, between frames
  int frames;       // in place of interval; 0 once that has been derived from it
  std::string format;
  std::string precision;
  std::string compression;
  Texts fields;                // optional fields to add to the default ones
  Texts omit;                  // default fields to leave out
  double checkpoint_interval;  // s of simulated time, 0: one checkpoint at the end
  bool operator==(const OutputControl&) const = default;
};

/// The values of compare.reference that ask for an exact solution (lib/exact) and not for a file.
inline constexpr std::string_view exact_reference = "exact";
inline constexpr std::string_view exact_small_strain_reference = "exact_small_strain";

/// How `anvil compare` judges a result: a file of reference quantities and the largest deviation allowed for some.
struct Comparison {
  std::string reference;      // name of a file in data/reference, exact, or exact_small_strain; empty: see the schema
  std::vector<double> times;  // s, of the frames held against an exact reference; empty: the last one
  NamedNumbers tolerance;     // relative, by quantity
  bool operator==(const Comparison&) const = default;
};

/// A whole scene in SI units, every default filled in.
struct Scene {
  std::string name;  // stem of the file
  std::string title;
  Domain domain;
  Discretisation discretisation;
  Shock shock;
  Stabiliser stabiliser;
  TimeControl time;
  std::vector<BodyDescription> bodies;
  std::vector<MaterialDescription> materials;  // those in use, each once
  std::vector<BoundaryDescription> boundaries;
  OutputControl output;
  Comparison compare;
  bool operator==(const Scene&) const = default;
};

}  // namespace anvil
