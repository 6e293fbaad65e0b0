// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/runner.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <chrono>
#include <cmath>
#include <ctime>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "anvil/core/error.hpp"
#include "anvil/core/threads.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/solver/simulation.hpp"
#include "anvil/study/measures.hpp"
#include "anvil/study/published.hpp"

namespace anvil {
namespace {

/// Exact solutions, each solved once for all runs that share bodies, materials and loads.
class ExactSolutions {
 public:
  const SceneReference& of(const Scene& scene, const std::vector<double>& times) {
    const std::scoped_lock lock(mutex_);
    for (const auto& known : known_)
      if (known->times == times && known->scene.domain == scene.domain && known->scene.bodies == scene.bodies &&
          known->scene.materials == scene.materials && known->scene.boundaries == scene.boundaries &&
          known->scene.compare.reference == scene.compare.reference)
        return known->solution;
    known_.push_back(std::make_unique<Solved>(scene, times));
    return known_.back()->solution;
  }

 private:
  struct Solved {
    Solved(const Scene& for_scene, const std::vector<double>& at_times)
        : scene(for_scene), times(at_times), solution(scene, times, strain_measure_of(scene)) {}
    Scene scene;
    std::vector<double> times;
    SceneReference solution;
  };
  std::mutex mutex_;
  std::vector<std::unique_ptr<Solved>> known_;
};

std::vector<std::string> overrides_of(const StudyGrid& grid, const std::vector<std::string>& axis_values,
                                      const std::vector<std::string>& set) {
  std::vector<std::string> overrides = grid.set;
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
    if (grid.axes[axis].key != threads_axis)
      overrides.push_back(fmt::format("{}={}", grid.axes[axis].key, axis_values[axis]));
  overrides.insert(overrides.end(), set.begin(), set.end());
  return overrides;
}

/// Throws InputError for what is no number of threads.
int threads_of(const StudyGrid& grid, const std::vector<std::string>& axis_values) {
  constexpr int most = 1024;
  for (std::size_t axis = 0; axis < grid.axes.size(); ++axis) {
    if (grid.axes[axis].key != threads_axis) continue;
    const std::string& text = axis_values[axis];
    int threads = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), threads);
    if (error != std::errc() || end != text.data() + text.size() || threads < 1 || threads > most)
      throw InputError(fmt::format("threads must be a whole number from 1 to {}, found {}", most, text));
    return threads;
  }
  return 1;
}

/// A run would not be what its line of the table says.
void refuse_axes(const StudyGrid& grid, const std::vector<std::string>& set) {
  for (const auto& text : set)
    for (const auto& axis : grid.axes)
      if (text.starts_with(axis.key + "="))
        throw InputError(fmt::format("--set {}: the key is an axis of the study, which gives it its values", text));
}

void prepare_grid(const StudyDescription& study, std::size_t number, const std::vector<std::string>& set,
                  std::vector<StudyRun>& runs) {
  const StudyGrid& grid = study.grids[number];
  refuse_axes(grid, set);
  const auto file = locate_scene(grid.scene);
  std::string reason;
  bool any = false;
  for (std::size_t k = 0; k < grid.run_count(); ++k) {
    StudyRun& run = runs.emplace_back();
    run.grid = number;
    run.axis_values = grid.values_of(k);
    try {
      run.threads = threads_of(grid, run.axis_values);
      run.scene = read_scene(file, overrides_of(grid, run.axis_values, set));
      any = true;
    } catch (const InputError& error) {
      run.reason = error.what();
      if (reason.empty()) reason = error.what();
    }
  }
  if (!any) throw InputError(reason);
}

void measure(const StudyGrid& grid, const StudySample& sample, StudyRun& run) {
  StudyRow row{sample.frames[sample.number].time, {}};
  for (const auto& name : grid.measures) row.values.push_back(find_study_measure(name)->of(sample, name));
  run.rows.push_back(std::move(row));  // whole rows only: a measure may throw
}

/// CPU time of this thread, s: what a run on one thread costs, whatever else the machine does.
double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The rows that `anvil run` would write into history.csv.
class RecordedHistory {
 public:
  RecordedHistory(const StudyGrid& grid, const Scene& scene)
      : wanted_(std::ranges::any_of(grid.measures, [](const auto& name) { return reads_history(name); })),
        interval_(scene.time.end / 2000.0) {}

  [[nodiscard]] bool due(double time) const { return wanted_ && time >= next_; }
  void add(const Simulation& simulation) {
    if (!wanted_) return;
    auto row = simulation.audit();
    row.insert(row.begin(), {"time", "s", simulation.time()});
    if (columns_.empty())
      for (const auto& entry : row) columns_.push_back({entry.name, entry.unit, {}});
    for (std::size_t k = 0; k < row.size(); ++k) columns_[k].values.push_back(row[k].value);
    next_ = (std::floor(simulation.time() / interval_) + 1.0) * interval_;
  }
  [[nodiscard]] History history() const { return History(columns_); }

 private:
  bool wanted_;
  double interval_, next_ = 0.0;
  std::vector<HistoryColumn> columns_;
};

/// The steps to a time, and what they took.
void advance_to(double time, Simulation& simulation, RecordedHistory& history, StudyRun& run) {
  const auto start = std::chrono::steady_clock::now();
  const double start_of_thread = thread_seconds();
  while (simulation.time() < time) {
    simulation.advance(time);
    if (history.due(simulation.time())) history.add(simulation);
  }
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  run.cpu_seconds += run.threads == 1 ? thread_seconds() - start_of_thread : wall;
  run.seconds += wall;
  run.steps = simulation.step();
}

/// The first run of some milliseconds pays for cold caches, and any may be disturbed: the least of three counts.
void repeat_if_short(const StudyGrid& grid, StudyRun& run) {
  constexpr double short_run = 0.2;  // s
  if (run.cpu_seconds > short_run) return;
  for (int again = 0; again < 2; ++again) {
    StudyRun other;
    other.threads = run.threads;
    RecordedHistory history(grid, *run.scene);
    const auto simulation = make_simulation(*run.scene);
    for (const double time : grid.times) advance_to(time, *simulation, history, other);
    run.cpu_seconds = std::min(run.cpu_seconds, other.cpu_seconds);
  }
}

void perform(const StudyGrid& grid, ExactSolutions& exact, StudyRun& run) {
  const Scene& scene = *run.scene;
  const auto simulation = make_simulation(scene);
  run.particles = simulation->particle_count();
  run.neighbours = simulation->explain().neighbours_per_particle;
  run.status = StudyStatus::failed;
  std::vector<Frame> frames;
  RecordedHistory recorded(grid, scene);
  recorded.add(*simulation);
  for (std::size_t number = 0; number < grid.times.size(); ++number) {
    advance_to(grid.times[number], *simulation, recorded, run);
    recorded.add(*simulation);
    frames.push_back(simulation->frame());
    const double particle_steps = static_cast<double>(run.steps) * static_cast<double>(run.particles);
    const History history = recorded.history();
    measure(grid,
            {scene, frames, number, [&]() -> const SceneReference& { return exact.of(scene, grid.times); },
             simulation->audit(), history, simulation->last_time_step(), run.cpu_seconds / particle_steps},
            run);
  }
  repeat_if_short(grid, run);
  run.status = StudyStatus::finished;
}

/// Errors that Anvil throws on purpose are outcomes; others end the study.
void perform_or_note(const StudyGrid& grid, ExactSolutions& exact, StudyRun& run) {
  try {
    perform(grid, exact, run);
  } catch (const Error& error) {
    run.reason = error.what();
  }
}

/// In proportion to particles times steps, as far as the scene tells it.
double expected_work(const StudyRun& run) {
  if (!run.scene) return 0.0;
  const Scene& scene = *run.scene;
  return scene.time.end / (scene.time.cfl * std::pow(scene.discretisation.spacing, scene.domain.dimension + 1));
}

/// Calls work(item) for all items on several threads; the first exception is thrown on when all have stopped.
void share_out(const std::vector<std::size_t>& items, int threads, const std::function<void(std::size_t)>& work) {
  const std::size_t count = items.size();
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr fault;
  const auto worker = [&] {
    for (std::size_t item = next++; item < count; item = next++) {
      try {
        work(items[item]);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (!fault) fault = std::current_exception();
        next = count;
      }
    }
  };
  std::vector<std::thread> workers;
  for (int k = 0; k < threads; ++k) workers.emplace_back(worker);
  for (auto& one : workers) one.join();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace

bool has_threads_axis(const StudyGrid& grid) {
  return std::ranges::find(grid.axes, threads_axis, &StudyAxis::key) != grid.axes.end();
}

std::vector<StudyRun> prepare_study(const StudyDescription& study, const std::vector<std::string>& set) {
  std::vector<StudyRun> runs;
  for (std::size_t grid = 0; grid < study.grids.size(); ++grid) prepare_grid(study, grid, set, runs);
  return runs;
}

void run_study(const StudyDescription& study, std::vector<StudyRun>& runs, int threads, const StudyProgress& progress,
               const StudyKeeper& keep) {
  ExactSolutions exact;
  std::mutex mutex;
  std::vector<std::size_t> waiting;
  double all_work = 0.0, done_work = 0.0;
  for (std::size_t k = 0; k < runs.size(); ++k)
    if (!runs[k].known) {
      waiting.push_back(k);
      all_work += expected_work(runs[k]);
    }
  // The longest first: the last ones are then short, and no thread waits long for another.
  std::ranges::stable_sort(waiting, std::greater<>(), [&](std::size_t k) { return expected_work(runs[k]); });
  const auto alone = std::stable_partition(waiting.begin(), waiting.end(),
                                           [&](std::size_t k) { return !has_threads_axis(study.grids[runs[k].grid]); });
  std::size_t done = runs.size() - waiting.size();
  const auto perform_one = [&](std::size_t number) {
    StudyRun& run = runs[number];
    set_thread_count(run.threads);  // holds for this thread
    if (run.scene) perform_or_note(study.grids[run.grid], exact, run);
    const std::scoped_lock lock(mutex);
    if (keep) keep(run);
    done_work += expected_work(run);
    progress({++done, runs.size(), all_work > 0.0 ? done_work / all_work : 1.0});
  };
  share_out({waiting.begin(), alone}, threads, perform_one);
  share_out({alone, waiting.end()}, 1, perform_one);
}

}  // namespace anvil
