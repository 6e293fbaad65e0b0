// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <queue>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/exact/plate.hpp"
#include "anvil/exact/wave_fan.hpp"
#include "anvil/exact/wave_profile.hpp"

namespace anvil {

/// How far front tracking goes into detail. Stresses are relative to PlateProblem::stress_scale.
struct TrackingAccuracy {
  /// Largest step of a load that varies, and of the fronts a spreading wave is cut into.
  double step = 1.0 / 256.0;
  /// Waves below this are not followed: the material keeps its stress, so one dropped wave leaves an error of at most
  /// this size where it would have passed, which the next wave through there removes.
  double smallest = 1e-9;
  /// Throws TooManyFronts beyond this number of meetings of fronts.
  std::size_t most_events = 4'000'000;
};

class TooManyFronts : public NumericalError {
 public:
  using NumericalError::NumericalError;
};

/// Elastic-plastic plane waves by front tracking (Dafermos 1972; Holden and Risebro 2015, chapter 2): between fronts
/// the material is uniform, where fronts meet a Riemann problem gives the new ones, and a front that stays behind
/// separates materials or different plastic histories. In small strain, under loads that are constant piece by piece,
/// this is the exact solution up to the waves too small to follow. In finite strain, and under smooth loads, the error
/// is of the order of `step`; halving `step` measures it. Mass, momentum and energy are kept by every front.
class FrontTracking {
 public:
  /// `end`: the last time anyone will ask for, s. Throws InputError when the problem cannot be solved as it stands.
  FrontTracking(const PlateProblem& problem, double end, const TrackingAccuracy& accuracy = {});

  /// `time` in s, between the time already reached and `end`. Throws NumericalError.
  void advance_to(double time);

  [[nodiscard]] WaveProfile profile() const;
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] std::size_t events() const { return events_; }
  /// What the faces have given to the plate so far, per unit of area: impulse in Pa s, work in J/m2.
  [[nodiscard]] double impulse() const { return impulse_; }
  [[nodiscard]] double work() const { return work_; }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  /// A front and the zone on its right. Fronts form a list from the left face (front 0) to the right face (front 1).
  struct Front {
    double position;  // at `since`
    double since;
    double speed;  // m/s, positive to the right; 0: a face or a contact
    std::size_t layer;
    WaveState right;
    std::size_t previous;
    std::size_t next;
    std::size_t serial;  // changes when the place in memory is used again
    bool fixed;          // a face or the boundary of a layer: stays where it is for ever
  };
  struct Meeting {
    double time;
    std::size_t left, right;
    std::size_t left_serial, right_serial;
    bool operator>(const Meeting& other) const { return time > other.time; }
  };
  struct LoadStep {
    double time;
    double pressure;
    bool on_left;
  };
  /// The fronts that replace those of a meeting, from left to right.
  struct NewFront {
    double speed;
    std::size_t layer;
    bool fixed;
    WaveState right;
  };

  void place_layers();
  void schedule_loads(const PlateFace& face, bool on_left, double end);
  void apply_load(const LoadStep& step);
  [[nodiscard]] double position_of(const Front& front) const;
  void move_clock(double time);
  void count_event();
  void meet(const Meeting& meeting);
  [[nodiscard]] bool meets_too(std::size_t left, std::size_t right) const;
  void solve_inside(std::size_t first, std::size_t last, double position);
  void solve_left_face(std::size_t last);
  void solve_right_face(std::size_t first);
  void fill_face_fan(const PlateFace& face, double stress, const Front& ahead, Direction direction);
  void forget_if_small(WaveFan& fan, const WaveState& ahead) const;
  void add_left_going(const WaveFan& fan, std::size_t layer);
  void add_right_going(const WaveFan& fan, std::size_t layer, const WaveState& ahead);
  [[nodiscard]] bool same_history(const WaveState& a, const WaveState& b) const;
  void replace(std::size_t before, std::size_t after, double position);
  void watch(std::size_t left);
  std::size_t make_front(const NewFront& front, double position);
  [[nodiscard]] const WaveMaterial& material(std::size_t layer) const { return problem_.layers[layer].material; }

  PlateProblem problem_;
  TrackingAccuracy accuracy_;
  WaveResolution resolution_;
  double smallest_energy_;  // J/kg, smaller differences between the sides of a contact are not followed
  double coincidence_;      // m, fronts closer than this meet together
  double time_ = 0.0;
  double left_stress_ = 0.0;  // on the faces, now
  double right_stress_ = 0.0;
  double left_face_position_ = 0.0;
  double impulse_ = 0.0;
  double work_ = 0.0;
  std::size_t events_ = 0;

  std::vector<Front> fronts_;
  std::vector<std::size_t> free_places_;
  std::priority_queue<Meeting, std::vector<Meeting>, std::greater<>> meetings_;
  std::vector<LoadStep> load_steps_;
  std::size_t next_load_step_ = 0;

  // Reused from meeting to meeting.
  ContactSolution contact_;
  WaveFan fan_;
  std::vector<NewFront> replacement_;
};

}  // namespace anvil
