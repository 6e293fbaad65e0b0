// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/frame_fields.hpp"

#include <fmt/core.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>

#include "anvil/core/error.hpp"
#include "anvil/core/tensor.hpp"
#include "anvil/scene/nearest_name.hpp"

namespace anvil {
namespace {

constexpr std::array<std::string_view, 3> vector_parts = {"x", "y", "z"};
constexpr std::array<std::string_view, 6> tensor_parts = {"xx", "yy", "zz", "xy", "yz", "xz"};

/// Principal values, the largest first.
std::array<double, 3> principal_values(const double* tensor) {
  Tensor full;
  full << tensor[0], tensor[3], tensor[5], tensor[3], tensor[1], tensor[4], tensor[5], tensor[4], tensor[2];
  const Eigen::SelfAdjointEigenSolver<Tensor> solver(full, Eigen::EigenvaluesOnly);
  return {solver.eigenvalues()[2], solver.eigenvalues()[1], solver.eigenvalues()[0]};
}

double mean(const double* tensor) { return (tensor[0] + tensor[1] + tensor[2]) / 3.0; }

double max_shear(const double* tensor) {
  const auto principal = principal_values(tensor);
  return 0.5 * (principal[0] - principal[2]);
}

double principal_1(const double* tensor) { return principal_values(tensor)[0]; }
double principal_2(const double* tensor) { return principal_values(tensor)[1]; }
double principal_3(const double* tensor) { return principal_values(tensor)[2]; }
double length(const double* vector) { return std::hypot(vector[0], vector[1], vector[2]); }

using Reduce = double (*)(const double*);
constexpr std::pair<std::string_view, Reduce> invariants[] = {
    {"von_mises", von_mises},     {"mean", mean},
    {"max_shear", max_shear},     {"principal_1", principal_1},
    {"principal_2", principal_2}, {"principal_3", principal_3}};

/// An array of the frame, or its positions.
struct Source {
  std::string unit;
  std::size_t components;
  const std::vector<double>* values;
};

std::optional<Source> find_source(const Frame& frame, const std::string& name) {
  if (name == "position") return Source{"m", 3, &frame.positions};
  const FrameArray* array = frame.find(name);
  if (array == nullptr) return std::nullopt;
  return Source{array->unit, static_cast<std::size_t>(array->components), &array->values};
}

/// The values of a name; those that are no plain component are computed and kept in `made`.
class Names {
 public:
  explicit Names(const Frame& frame) : frame_(frame) {}

  std::optional<NamedValues> find(const std::string& name) {
    if (const auto source = find_source(frame_, name)) return whole(name, *source);
    if (name == "von_mises") return renamed(find("stress.von_mises"), name);
    if (name == "radius") return radius();
    const auto dot = name.rfind('.');
    const auto source = dot == std::string::npos ? std::nullopt : find_source(frame_, name.substr(0, dot));
    return source ? part(name, *source, name.substr(dot + 1)) : std::nullopt;
  }

 private:
  std::optional<NamedValues> whole(const std::string& name, const Source& source) {
    if (source.components == 1) return component(name, source, 0);
    if (source.components == 3) return reduced(name, source, length);
    return std::nullopt;  // a tensor has no single natural size
  }

  std::optional<NamedValues> part(const std::string& name, const Source& source, const std::string& part) {
    for (std::size_t c = 0; c < source.components; ++c) {
      if (source.components == 3 && part == vector_parts[c]) return component(name, source, c);
      if (source.components == 6 && part == tensor_parts[c]) return component(name, source, c);
      if (source.components != 3 && source.components != 6 && part == std::to_string(c))
        return component(name, source, c);
    }
    if (source.components == 3 && part == "magnitude") return reduced(name, source, length);
    for (const auto& [invariant, reduce] : invariants)
      if (source.components == 6 && part == invariant) return reduced(name, source, reduce);
    return std::nullopt;
  }

  static NamedValues component(const std::string& name, const Source& source, std::size_t c) {
    return {name, source.unit, source.values->data() + c, source.components, source.values->size() / source.components};
  }

  NamedValues reduced(const std::string& name, const Source& source, Reduce reduce) {
    std::vector<double> values(source.values->size() / source.components);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = reduce(source.values->data() + i * source.components);
    return keep(name, source.unit, std::move(values));
  }

  NamedValues radius() {
    const bool flat = frame_.dimension < 3;
    std::vector<double> values(frame_.particle_count());
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double* x = &frame_.positions[3 * i];
      values[i] = flat ? length(x) : std::hypot(x[0], x[1]);
    }
    return keep("radius", "m", std::move(values));
  }

  NamedValues keep(const std::string& name, const std::string& unit, std::vector<double> values) {
    made_.push_back(std::move(values));
    return {name, unit, made_.back().data(), 1, made_.back().size()};
  }

  static std::optional<NamedValues> renamed(std::optional<NamedValues> values, const std::string& name) {
    if (values) values->name = name;
    return values;
  }

  const Frame& frame_;
  std::deque<std::vector<double>> made_;
};

/// "plastic_strain, velocity (also velocity.x, ...)": what an error offers.
std::string list_of_arrays(const Frame& frame) {
  std::string list = "position (and .x, .y, .z)";
  for (const FrameArray& array : frame.arrays) {
    list += ", " + array.name;
    if (array.components == 3) list += " (and .x, .y, .z)";
    if (array.components == 6) list += " (.xx to .xz, .von_mises, .mean, .max_shear, .principal_1 to _3)";
  }
  return list;
}

[[noreturn]] void refuse(const Frame& frame, const std::string& name) {
  const auto names = field_names(frame);
  const std::string_view near = nearest_name(name, views_of(names));
  throw InputError(fmt::format("there is no field '{}' in the frame{}; it has {}", name,
                               near.empty() ? "" : fmt::format("; did you mean '{}'?", near), list_of_arrays(frame)));
}

}  // namespace

double von_mises(const double* tensor) {
  const double xy = tensor[0] - tensor[1];
  const double yz = tensor[1] - tensor[2];
  const double zx = tensor[2] - tensor[0];
  const double shear = tensor[3] * tensor[3] + tensor[4] * tensor[4] + tensor[5] * tensor[5];
  return std::sqrt(0.5 * (xy * xy + yz * yz + zx * zx) + 3.0 * shear);
}

Evaluated field_of(const Frame& frame, const std::string& expression) {
  Names names(frame);
  std::vector<NamedValues> used;
  for (const auto& name : used_names(expression)) {
    const auto found = names.find(name);
    if (!found) refuse(frame, name);
    used.push_back(*found);
  }
  // A number alone stands for itself at every particle.
  if (used.empty()) used.push_back({"", "", frame.positions.data(), 3, frame.particle_count()});
  return evaluate(expression, used);
}

std::vector<std::string> field_names(const Frame& frame) {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& name, int components) {
    if (components != 6) names.push_back(name);
    if (components == 3)
      for (const auto part : vector_parts) names.push_back(fmt::format("{}.{}", name, part));
    if (components != 6) return;
    for (const auto part : tensor_parts) names.push_back(fmt::format("{}.{}", name, part));
    for (const auto& [invariant, reduce] : invariants) names.push_back(fmt::format("{}.{}", name, invariant));
  };
  add("position", 3);
  for (const FrameArray& array : frame.arrays) add(array.name, array.components);
  if (frame.find("stress") != nullptr) names.emplace_back("von_mises");
  names.emplace_back("radius");
  return names;
}

}  // namespace anvil
