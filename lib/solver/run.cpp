// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/solver/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "anvil/checkpoint/checkpoint.hpp"
#include "anvil/core/error.hpp"
#include "anvil/output/history.hpp"

namespace anvil {
namespace {

constexpr double history_parts = 2000.0;
/// Times that differ by less than this part of an interval are the same: steps are far longer, rounding errors of a
/// sum of steps far shorter.
constexpr double same_time = 1e-9;

/// How many whole intervals have passed at `time`.
double passed(double time, double interval) { return std::floor(time / interval + same_time); }

/// A frame is refused rather than written with what is no number, or none in the precision of its file: guards look at
/// what a step needs, and a stress breaks a step before the velocity does.
void check_numbers(const Frame& frame, const std::string& precision) {
  const double largest = precision == "float32" ? static_cast<double>(std::numeric_limits<float>::max())
                                                : std::numeric_limits<double>::max();
  for (const FrameArray& array : frame.arrays)
    for (std::size_t k = 0; k < array.values.size(); ++k)
      if (!(std::abs(array.values[k]) <= largest))
        throw NumericalError(fmt::format("step {} at {:.6g} s: particle {}: {} is {}, which is no number in {}",
                                         frame.step, frame.time, k / static_cast<std::size_t>(array.components),
                                         array.name, array.values[k], precision));
}

void check_numbers(const std::vector<Quantity>& row) {
  for (const Quantity& quantity : row)
    if (!std::isfinite(quantity.value))
      throw NumericalError(fmt::format("step {:g} at {:.6g} s: {} of the history is {}", row[1].value, row[0].value,
                                       quantity.name, quantity.value));
}

HistoryWriter open_history(const RunOptions& options) {
  if (options.restart) return {options.folder.history(), options.restart->history_rows};
  return HistoryWriter(options.folder.history());
}

class RunLoop {
 public:
  RunLoop(Simulation& simulation, const Scene& scene, const RunOptions& options, FrameWriter& frames,
          Progress& progress)
      : simulation_(simulation),
        scene_(scene),
        options_(options),
        frames_(frames),
        progress_(progress),
        history_(open_history(options)),
        first_time_(simulation.time()) {
    if (options.restart) {
      next_frame_ = options.restart->next_frame;
      last_frame_time_ = passed(first_time_, scene.output.interval) * scene.output.interval;
      for (const double compared : scene.compare.times)
        if (reached(compared)) last_frame_time_ = std::max(last_frame_time_, compared);
    }
    provenance_ = make_provenance();
    provenance_.title = scene.title;
    provenance_.scene_name = scene.name;
    provenance_.scene_text = options.scene_text;
    provenance_.scene_id = identify_scene(options.scene_text);
    provenance_.started = utc_now();
    provenance_.particles = static_cast<std::int64_t>(simulation.particle_count());
    provenance_.first_step = simulation.step();
  }

  Provenance run() {
    record("running", "");
    try {
      const bool finished = run_to_end();
      write_state();
      record(finished ? "finished" : "stopped", finished ? "" : "interrupted; restart from the last checkpoint");
    } catch (const NumericalError& error) {
      const std::string reason =
          fmt::format("{}; last good frame: {} at {:.6g} s", error.what(), next_frame_ - 1, last_frame_time_);
      record("failed", reason);
      throw NumericalError(reason);
    } catch (const std::exception& error) {
      record_failure(error.what());
      throw;
    }
    return provenance_;
  }

 private:
  /// Returns false when it was asked to stop before the end.
  bool run_to_end() {
    if (!options_.restart) {
      write_frame();
      write_row();
    }
    while (!reached(scene_.time.end)) {
      if (options_.stop_requested()) return false;
      advance();
    }
    return true;
  }

  void advance() {
    const double before = simulation_.time();
    const double target = next_frame_time(before);
    const double start = wall_seconds();
    simulation_.advance(target);
    provenance_.step_time += wall_seconds() - start;
    const bool frame_due = reached(target);
    if (frame_due) write_frame();
    if (frame_due || entered_next(before, scene_.time.end / history_parts)) write_row();
    const bool finished = reached(scene_.time.end);
    if (!finished && scene_.output.checkpoint_interval > 0 && entered_next(before, scene_.output.checkpoint_interval))
      write_state();
    progress_.show(position());
  }

  [[nodiscard]] double next_frame_time(double time) const {
    const double interval = scene_.output.interval;
    double next = (passed(time, interval) + 1.0) * interval;
    // A multiple that is the end but for rounding would leave a step of no length.
    if (next > scene_.time.end - same_time * interval) next = scene_.time.end;
    for (const double compared : scene_.compare.times)  // the comparison wants a frame
      if (!reached(compared) && compared < next - same_time * interval) next = compared;
    return next;
  }

  [[nodiscard]] bool reached(double time) const {
    return simulation_.time() >= time - same_time * scene_.output.interval;
  }

  [[nodiscard]] bool entered_next(double before, double interval) const {
    return passed(simulation_.time(), interval) > passed(before, interval);
  }

  void write_frame() {
    Frame frame = simulation_.frame();
    check_numbers(frame, scene_.output.precision);
    frame.scene = scene_.name;
    frame.index = next_frame_;
    frame.provenance.insert(frame.provenance.end(), {{"title", scene_.title},
                                                     {"scene_id", provenance_.scene_id},
                                                     {"version", provenance_.version},
                                                     {"commit", provenance_.commit}});
    frames_.write(frame);
    ++next_frame_;
    last_frame_time_ = frame.time;
  }

  void write_row() {
    std::vector<Quantity> row = {{"time", "s", simulation_.time()},
                                 {"step", "", static_cast<double>(simulation_.step())},
                                 {"time_step", "s", simulation_.last_time_step()}};
    const auto audit = simulation_.audit();
    row.insert(row.end(), audit.begin(), audit.end());
    check_numbers(row);
    history_.append(row);
  }

  void write_state() {
    Checkpoint checkpoint;
    checkpoint.scene_name = scene_.name;
    checkpoint.scene_text = options_.scene_text;
    checkpoint.version = provenance_.version;
    checkpoint.commit = provenance_.commit;
    checkpoint.time = simulation_.time();
    checkpoint.step = simulation_.step();
    checkpoint.next_frame = next_frame_;
    checkpoint.history_rows = history_.rows();
    checkpoint.state = simulation_.state();
    write_checkpoint(options_.folder.checkpoint(checkpoint.step), checkpoint);
  }

  [[nodiscard]] double wall_seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  [[nodiscard]] RunPosition position() const {
    const double end = scene_.time.end;
    const double fraction = (simulation_.time() - first_time_) / (end - first_time_);
    return {simulation_.time(),      end,           simulation_.last_time_step(), simulation_.step(),
            std::min(fraction, 1.0), wall_seconds()};
  }

  void record(const std::string& status, const std::string& reason) {
    provenance_.status = status;
    provenance_.reason = reason;
    provenance_.steps = simulation_.step();
    provenance_.time = simulation_.time();
    provenance_.wall_time = wall_seconds();
    const auto steps = static_cast<double>(provenance_.steps - provenance_.first_step);
    const double particle_steps = steps * static_cast<double>(provenance_.particles);
    provenance_.particle_steps_per_second = steps > 0.0 ? particle_steps / provenance_.wall_time : 0.0;
    if (status != "running") provenance_.ended = utc_now();
    write_provenance(options_.folder.provenance(), provenance_);
  }

  /// The error on its way to the user matters more than one of writing it down: the disk may be full.
  void record_failure(const std::string& reason) noexcept {
    try {
      record("failed", reason);
    } catch (const std::exception&) {
    }
  }

  Simulation& simulation_;
  const Scene& scene_;
  const RunOptions& options_;
  FrameWriter& frames_;
  Progress& progress_;
  HistoryWriter history_;
  double first_time_;
  double last_frame_time_ = 0.0;
  int next_frame_ = 0;
  Provenance provenance_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

Provenance run(Simulation& simulation, const Scene& scene, const RunOptions& options, FrameWriter& frames,
               Progress& progress) {
  return RunLoop(simulation, scene, options, frames, progress).run();
}

}  // namespace anvil
