// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "anvil/core/quantity.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// One number of the audit: a column of history.csv.
using AuditValue = Quantity;

/// A field or a term as `anvil explain` lists it.
struct ExplainedField {
  std::string name;
  std::string unit;
  int bytes_per_particle = 0;
  std::string purpose;
};
struct ExplainedTerm {
  std::string name;
  std::string purpose;
};
struct Explanation {
  std::vector<ExplainedTerm> terms;
  std::vector<ExplainedField> fields;
  std::size_t particles = 0;
  double neighbours_per_particle = 0.0;
  int bytes_per_particle = 0;       // fields, records and neighbour list together
  double first_time_step = 0.0;     // s
  std::int64_t steps_expected = 0;  // to the end, at the first time step
};

/// Everything a run needs to go on with the same bits: named arrays, exactly as they stand in memory.
struct StateArray {
  int components = 1;
  std::variant<std::vector<double>, std::vector<std::int64_t>> values;
};
using State = std::map<std::string, StateArray>;

/// A scene in motion, whatever its dimension.
class Simulation {
 public:
  Simulation() = default;
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  virtual ~Simulation() = default;

  [[nodiscard]] virtual double time() const = 0;            // s
  [[nodiscard]] virtual double last_time_step() const = 0;  // s, 0 before the first step
  [[nodiscard]] virtual std::int64_t step() const = 0;
  [[nodiscard]] virtual std::size_t particle_count() const = 0;

  /// One step, never beyond `latest` (s), which lies after time(). Throws NumericalError with the time, the particle
  /// and its values when a guard trips; the state is then the one that tripped it.
  virtual void advance(double latest) = 0;

  [[nodiscard]] virtual Frame frame() const = 0;
  /// The conserved quantities and their parts at time(), in a fixed order for a scene.
  [[nodiscard]] virtual std::vector<AuditValue> audit() const = 0;
  [[nodiscard]] virtual Explanation explain() const = 0;
  [[nodiscard]] virtual State state() const = 0;
  virtual void restore(const State& state) = 0;
};

/// Builds the particles and the list of terms of a scene; the recipe refuses what cannot work with an InputError.
std::unique_ptr<Simulation> make_simulation(const Scene& scene);

}  // namespace anvil
