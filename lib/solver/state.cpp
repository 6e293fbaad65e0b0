// SPDX-License-Identifier: BSD-3-Clause
// What a run needs to go on with the same bits: the fields, the clock and the ledger. The neighbour list is not stored:
// it follows from the positions it was made at, which are a field.
#include <algorithm>

#include "anvil/core/field_keys.hpp"
#include "anvil/solver/solver.hpp"

namespace anvil {
namespace {

template <int D>
std::vector<double> ledger_numbers(const Ledger<D>& ledger) {
  std::vector<double> numbers = {
      ledger.plastic_work,  ledger.viscous_loss, ledger.smoothing_loss, ledger.wall_loss, ledger.start_energy,
      ledger.pressure_work, ledger.uncorrected,  ledger.gravity_work,   ledger.wall_work, ledger.penetrations,
      ledger.contact_loss,  ledger.erosion_loss, ledger.contact_impulse};
  for (const Vec<D>* vector : {&ledger.smoothing_impulse, &ledger.wall_impulse, &ledger.pressure_impulse,
                               &ledger.gravity_impulse, &ledger.start_momentum})
    numbers.insert(numbers.end(), vector->data(), vector->data() + D);
  return numbers;
}

template <int D>
Ledger<D> ledger_from(const std::vector<double>& numbers) {
  Ledger<D> ledger;
  ledger.plastic_work = numbers[0];
  ledger.viscous_loss = numbers[1];
  ledger.smoothing_loss = numbers[2];
  ledger.wall_loss = numbers[3];
  ledger.start_energy = numbers[4];
  ledger.pressure_work = numbers[5];
  ledger.uncorrected = numbers[6];
  ledger.gravity_work = numbers[7];
  ledger.wall_work = numbers[8];
  ledger.penetrations = numbers[9];
  ledger.contact_loss = numbers[10];
  ledger.erosion_loss = numbers[11];
  ledger.contact_impulse = numbers[12];
  const double* next = numbers.data() + 13;
  for (Vec<D>* vector : {&ledger.smoothing_impulse, &ledger.wall_impulse, &ledger.pressure_impulse,
                         &ledger.gravity_impulse, &ledger.start_momentum}) {
    for (int a = 0; a < D; ++a) (*vector)[a] = *next++;
  }
  return ledger;
}

template <class T>
const std::vector<T>& numbers_of(const State& state, const std::string& name, std::size_t count) {
  const auto found = state.find(name);
  const auto* numbers = found == state.end() ? nullptr : std::get_if<std::vector<T>>(&found->second.values);
  if (numbers == nullptr || numbers->size() != count)
    throw InputError("the checkpoint does not fit the scene: '" + name + "' is missing or has another size");
  return *numbers;
}

constexpr const char* clock_name = "clock";    // time, last step, step limit, first step limit
constexpr const char* counts_name = "counts";  // steps, list builds, limiting particle
constexpr const char* ledger_name = "ledger";
constexpr const char* local_steps_name = "local_steps";  // of the stresses of particles, then of edges, by tile

}  // namespace

template <int D>
State Solver<D>::state() const {
  State state;
  for (const auto& field : fields_.fields())
    state["field/" + std::string(field.key->name)] = {field.components, field.values};
  if (recipe_.edges)
    for (const auto& field : recipe_.edges->fields().fields())
      state["edge/" + std::string(field.key->name)] = {field.components, field.values};
  state[clock_name] = {1, std::vector<double>{time_, time_step_, step_limit_, first_step_limit_}};
  state[counts_name] = {1, std::vector<std::int64_t>{step_, list_builds_, limiting_particle_}};
  state[ledger_name] = {1, ledger_numbers(ledger_)};
  if (local_steps_) {
    std::vector<double> steps = local_steps_->particle_step;
    steps.insert(steps.end(), local_steps_->edge_step.begin(), local_steps_->edge_step.end());
    state[local_steps_name] = {1, std::move(steps)};
  }
  return state;
}

template <int D>
void Solver<D>::restore(const State& state) {
  // All is checked before anything changes.
  for (const auto& field : fields_.fields())
    (void)numbers_of<double>(state, "field/" + std::string(field.key->name), field.values.size());
  if (recipe_.edges)
    for (const auto& field : recipe_.edges->fields().fields())
      (void)numbers_of<double>(state, "edge/" + std::string(field.key->name), field.values.size());
  const auto& clock = numbers_of<double>(state, clock_name, 4);
  const auto& counts = numbers_of<std::int64_t>(state, counts_name, 3);
  const auto& ledger = numbers_of<double>(state, ledger_name, 13 + 5 * D);
  if (local_steps_) (void)numbers_of<double>(state, local_steps_name, 2 * tiles_.size());
  const auto load = [&](const std::string& kind, FieldStore& store) {
    // The views of the terms point into the fields: their memory stays where it is.
    for (auto& field : store.fields()) {
      const auto& stored = numbers_of<double>(state, kind + std::string(field.key->name), field.values.size());
      std::copy(stored.begin(), stored.end(), field.values.begin());
    }
  };
  load("field/", fields_);

  // The list is made where it was made, then position and smoothing length become the present ones again.
  if (!recipe_.deformation) {
    for (std::size_t i = 0; i < particle_count(); ++i) {
      position_[i] = listed_position_[i];
      if (smoothing_length_varies_) smoothing_length_[i] = listed_smoothing_length_[i];
    }
    list_neighbours();
    load("field/", fields_);
  }
  if (recipe_.edges) load("edge/", recipe_.edges->fields());
  strain(0.0);  // no time passes: fills the records that the next step reads

  if (local_steps_) {
    const auto& steps = numbers_of<double>(state, local_steps_name, 2 * tiles_.size());
    std::copy_n(steps.begin(), tiles_.size(), local_steps_->particle_step.begin());
    std::copy_n(steps.begin() + static_cast<std::ptrdiff_t>(tiles_.size()), tiles_.size(),
                local_steps_->edge_step.begin());
  }
  time_ = clock[0];
  time_step_ = clock[1];
  step_limit_ = clock[2];
  first_step_limit_ = clock[3];
  step_ = counts[0];
  list_builds_ = counts[1];
  limiting_particle_ = static_cast<std::int32_t>(counts[2]);
  ledger_ = ledger_from<D>(ledger);
}

template State Solver<1>::state() const;
template State Solver<2>::state() const;
template State Solver<3>::state() const;
template void Solver<1>::restore(const State&);
template void Solver<2>::restore(const State&);
template void Solver<3>::restore(const State&);

}  // namespace anvil
