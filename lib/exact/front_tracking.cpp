// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/exact/front_tracking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace anvil {
namespace {

// Places of the faces in the list of fronts.
constexpr std::size_t left_face = 0;
constexpr std::size_t right_face = 1;

// Of the plate's thickness. Waves between two fronts that close in on each other are reflected infinitely often before
// these meet; within this distance all meet at once. Far below what any profile shows, and it moves a front no further.
constexpr double coincidence = 1e-7;

/// Elastic energy at the stress scale, J/kg, in the material that stores most.
double largest_energy(const PlateProblem& problem, double stress) {
  double largest = 0.0;
  for (const PlateLayer& layer : problem.layers)
    largest = std::max(largest, 0.5 * stress * stress / (layer.material.elastic_modulus() * layer.material.density()));
  return largest;
}

}  // namespace

FrontTracking::FrontTracking(const PlateProblem& problem, double end, const TrackingAccuracy& accuracy)
    : problem_(problem), accuracy_(accuracy), left_face_position_(problem.left_position) {
  problem_.check();
  const double scale = problem_.stress_scale();
  resolution_ = {accuracy.step * scale, accuracy.smallest * scale};
  smallest_energy_ = largest_energy(problem_, scale) * accuracy.smallest;
  coincidence_ = coincidence * problem_.thickness();
  schedule_loads(problem_.left_face, true, end);
  schedule_loads(problem_.right_face, false, end);
  std::stable_sort(load_steps_.begin(), load_steps_.end(),
                   [](const LoadStep& a, const LoadStep& b) { return a.time < b.time; });
  place_layers();
}

void FrontTracking::schedule_loads(const PlateFace& face, bool on_left, double end) {
  if (face.rigid) return;
  for (const PressureHistory::Step& step : face.pressure.steps(end, resolution_.step))
    load_steps_.push_back({step.time, step.pressure, on_left});
}

void FrontTracking::place_layers() {
  double position = problem_.left_position;
  make_front({0.0, 0, true, {}}, position);
  make_front({0.0, 0, true, {}}, position + problem_.thickness());
  fronts_[left_face].next = right_face;
  fronts_[right_face].previous = left_face;
  std::size_t before = left_face;
  for (std::size_t layer = 0; layer < problem_.layers.size(); ++layer) {
    const PlateLayer& description = problem_.layers[layer];
    const WaveState state = description.material.rest(description.velocity, description.deviator);
    if (layer == 0) {
      fronts_[left_face].right = state;
    } else {
      replacement_.assign(1, {0.0, layer, true, state});
      replace(before, right_face, position);
      before = fronts_[before].next;
    }
    position += description.thickness;
  }
  for (std::size_t front = fronts_[left_face].next; front != right_face;) {
    const std::size_t next = fronts_[front].next;
    solve_inside(front, front, fronts_[front].position);
    front = next;
  }
  solve_left_face(left_face);
  solve_right_face(right_face);
}

double FrontTracking::position_of(const Front& front) const {
  return front.position + front.speed * (time_ - front.since);
}

void FrontTracking::move_clock(double time) {
  const double step = time - time_;
  const WaveState& left = fronts_[left_face].right;
  const WaveState& right = fronts_[fronts_[right_face].previous].right;
  left_face_position_ += step * left.velocity;
  impulse_ += step * (right.stress - left.stress);
  work_ += step * (right.stress * right.velocity - left.stress * left.velocity);
  time_ = time;
}

void FrontTracking::count_event() {
  if (++events_ <= accuracy_.most_events) return;
  throw TooManyFronts("the exact solution needs more than " + std::to_string(accuracy_.most_events) +
                      " meetings of wave fronts by " + std::to_string(time_ * 1e6) +
                      " us: ask for an earlier time or a coarser accuracy");
}

void FrontTracking::advance_to(double time) {
  if (time < time_) throw InputError("front tracking cannot go back in time");
  for (;;) {
    const double load_time = next_load_step_ < load_steps_.size() ? load_steps_[next_load_step_].time
                                                                  : std::numeric_limits<double>::infinity();
    if (!meetings_.empty() && meetings_.top().time <= std::min(time, load_time)) {
      const Meeting meeting = meetings_.top();
      meetings_.pop();
      meet(meeting);
    } else if (load_time <= time) {
      move_clock(load_time);
      apply_load(load_steps_[next_load_step_++]);
    } else {
      break;
    }
  }
  move_clock(time);
}

void FrontTracking::apply_load(const LoadStep& step) {
  count_event();
  if (step.on_left) {
    left_stress_ = -step.pressure;
    solve_left_face(left_face);
  } else {
    right_stress_ = -step.pressure;
    solve_right_face(right_face);
  }
}

/// Fronts beside the ones that meet belong to the same meeting when they are as good as there already.
bool FrontTracking::meets_too(std::size_t left, std::size_t right) const {
  return fronts_[left].speed > fronts_[right].speed &&
         position_of(fronts_[right]) - position_of(fronts_[left]) < coincidence_;
}

void FrontTracking::meet(const Meeting& meeting) {
  std::size_t first = meeting.left;
  std::size_t last = meeting.right;
  const bool outdated = fronts_[first].serial != meeting.left_serial || fronts_[last].serial != meeting.right_serial ||
                        fronts_[first].next != last;
  if (outdated) return;
  count_event();
  move_clock(std::max(time_, meeting.time));
  while (first != left_face && meets_too(fronts_[first].previous, first)) first = fronts_[first].previous;
  while (last != right_face && meets_too(last, fronts_[last].next)) last = fronts_[last].next;
  if (first == left_face) {
    solve_left_face(last);
  } else if (last == right_face) {
    solve_right_face(first);
  } else {
    solve_inside(first, last, 0.5 * (position_of(fronts_[first]) + position_of(fronts_[last])));
  }
}

void FrontTracking::forget_if_small(WaveFan& fan, const WaveState& ahead) const {
  if (std::abs(fan.end(ahead).stress - ahead.stress) <= resolution_.smallest) fan.fronts.clear();
}

void FrontTracking::fill_face_fan(const PlateFace& face, double stress, const Front& ahead, Direction direction) {
  if (face.rigid)
    fill_fan_from_rigid_face(material(ahead.layer), ahead.right, direction, resolution_, fan_);
  else
    fill_fan(material(ahead.layer), ahead.right, stress, direction, resolution_, fan_);
  forget_if_small(fan_, ahead.right);
}

void FrontTracking::solve_left_face(std::size_t last) {
  const Front ahead = fronts_[last];
  const std::size_t after = ahead.next;
  fill_face_fan(problem_.left_face, left_stress_, ahead, Direction::right);
  replacement_.clear();
  add_right_going(fan_, ahead.layer, ahead.right);
  fronts_[left_face].right = fan_.end(ahead.right);
  replace(left_face, after, fronts_[left_face].position);
}

void FrontTracking::solve_right_face(std::size_t first) {
  const std::size_t before = fronts_[first].previous;
  fill_face_fan(problem_.right_face, right_stress_, fronts_[before], Direction::left);
  replacement_.clear();
  add_left_going(fan_, fronts_[before].layer);
  replace(before, right_face, fronts_[right_face].position);
}

void FrontTracking::solve_inside(std::size_t first, std::size_t last, double position) {
  const std::size_t before = fronts_[first].previous;
  const std::size_t after = fronts_[last].next;
  const Front left = fronts_[before];
  const Front right = fronts_[last];
  bool boundary = false;
  for (std::size_t front = first; front != after; front = fronts_[front].next) {
    if (!fronts_[front].fixed) continue;
    boundary = true;
    position = fronts_[front].position;
  }
  solve_contact(material(left.layer), left.right, material(right.layer), right.right, resolution_, contact_);
  forget_if_small(contact_.left_fan, left.right);
  forget_if_small(contact_.right_fan, right.right);
  const WaveState& left_star = contact_.left_fan.end(left.right);
  const WaveState& right_star = contact_.right_fan.end(right.right);

  replacement_.clear();
  add_left_going(contact_.left_fan, left.layer);
  if (boundary || !same_history(left_star, right_star))
    replacement_.push_back({0.0, right.layer, boundary, right_star});
  add_right_going(contact_.right_fan, right.layer, right.right);
  if (!replacement_.empty()) replacement_.back().right = right.right;
  replace(before, after, position);
}

void FrontTracking::add_left_going(const WaveFan& fan, std::size_t layer) {
  for (const WaveFan::Front& front : fan.fronts) replacement_.push_back({-front.speed, layer, false, front.behind});
}

void FrontTracking::add_right_going(const WaveFan& fan, std::size_t layer, const WaveState& ahead) {
  for (std::size_t i = fan.fronts.size(); i-- > 0;)
    replacement_.push_back({fan.fronts[i].speed, layer, false, i == 0 ? ahead : fan.fronts[i - 1].behind});
}

bool FrontTracking::same_history(const WaveState& a, const WaveState& b) const {
  const auto near = [this](double x, double y) { return x == y || std::abs(x - y) <= resolution_.smallest; };
  return near(a.deviator, b.deviator) && near(a.pressure(), b.pressure()) && near(a.back_deviator, b.back_deviator) &&
         near(a.yield_deviator, b.yield_deviator) && std::abs(a.energy - b.energy) <= smallest_energy_;
}

std::size_t FrontTracking::make_front(const NewFront& front, double position) {
  if (free_places_.empty()) {
    fronts_.push_back({});
    free_places_.push_back(fronts_.size() - 1);
  }
  const std::size_t place = free_places_.back();
  free_places_.pop_back();
  const std::size_t serial = fronts_[place].serial + 1;
  fronts_[place] = {position, time_, front.speed, front.layer, front.right, none, none, serial, front.fixed};
  return place;
}

/// Puts the replacement between the two fronts, in place of whatever is there.
void FrontTracking::replace(std::size_t before, std::size_t after, double position) {
  for (std::size_t front = fronts_[before].next; front != after;) {
    const std::size_t next = fronts_[front].next;
    ++fronts_[front].serial;
    free_places_.push_back(front);
    front = next;
  }
  std::size_t last = before;
  for (const NewFront& description : replacement_) {
    const std::size_t front = make_front(description, position);
    fronts_[last].next = front;
    fronts_[front].previous = last;
    last = front;
  }
  fronts_[last].next = after;
  fronts_[after].previous = last;
  for (std::size_t front = before; front != after; front = fronts_[front].next) watch(front);
}

/// Schedules the meeting of a front with its right neighbour, if there will be one.
void FrontTracking::watch(std::size_t left) {
  const Front& a = fronts_[left];
  const Front& b = fronts_[a.next];
  if (a.speed <= b.speed) return;
  const double gap = std::max(0.0, position_of(b) - position_of(a));
  meetings_.push({time_ + gap / (a.speed - b.speed), left, a.next, a.serial, b.serial});
}

WaveProfile FrontTracking::profile() const {
  WaveProfile result;
  result.time = time_;
  result.left_face_position = left_face_position_;
  for (std::size_t front = left_face; front != right_face; front = fronts_[front].next) {
    const Front& begin = fronts_[front];
    // Fronts about to meet may have passed each other by a unit of round-off.
    const double from = result.zones.empty() ? begin.position : result.zones.back().end;
    const double to = std::max(from, position_of(fronts_[begin.next]));
    if (to > from) result.zones.push_back({from, to, begin.layer, material(begin.layer).density(), begin.right});
  }
  return result;
}

}  // namespace anvil
