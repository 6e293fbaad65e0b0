// SPDX-License-Identifier: BSD-3-Clause
// Scenes at the ends of what can be asked: each has to end as extremes/cases.toml says, and leave no file with what is
// not a number.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "anvil/checkpoint/checkpoint.hpp"
#include "anvil/core/error.hpp"
#include "anvil/output/hdf5_series.hpp"
#include "anvil/output/history.hpp"
#include "anvil/scene/reader.hpp"
#include "anvil/scene/writer.hpp"
#include "anvil/solver/run.hpp"
#include "robustness/extremes/extreme_case.hpp"
#include "robustness/extremes/extreme_measures.hpp"
#include "unit/output/temporary_folder.hpp"

namespace anvil {
namespace {

namespace fs = std::filesystem;

fs::path scene_file(const ExtremeCase& extreme) {
  return fs::path(ANVIL_SOURCE_DIR "/tests/robustness/extremes/scenes") / (extreme.scene + ".toml");
}

void expect_numbers(const std::vector<double>& values, const std::string& what) {
  for (const double value : values) ASSERT_TRUE(std::isfinite(value)) << what << " holds " << value;
}

/// Reads back every file of a result.
void expect_numbers_in_all_files(const fs::path& folder) {
  for (const auto& [number, file] : numbered_frames(folder / "frames")) {
    const Frame frame = read_hdf5_frame(file);
    expect_numbers(frame.positions, file.filename().string());
    for (const auto& array : frame.arrays) expect_numbers(array.values, file.filename().string() + ": " + array.name);
  }
  if (fs::exists(folder / "history.csv")) {
    const History history = read_history(folder / "history.csv");
    for (const auto& column : history.columns()) expect_numbers(column.values, "history: " + column.name);
  }
  for (const auto& item : fs::directory_iterator(folder)) {
    if (!item.path().filename().string().starts_with("checkpoint_")) continue;
    const Checkpoint checkpoint = read_checkpoint(item.path());
    for (const auto& [name, array] : checkpoint.state)
      if (const auto* values = std::get_if<std::vector<double>>(&array.values)) expect_numbers(*values, name);
  }
}

class Silent : public Progress {
 public:
  void show(const RunPosition& /*position*/) override {}
};

/// Adds the gradient times the position to the velocity of every particle.
void set_in_motion(Simulation& simulation, std::size_t dimension, const std::vector<double>& velocity_gradient) {
  State state = simulation.state();
  const auto& position = std::get<std::vector<double>>(state.at("field/position").values);
  auto& velocity = std::get<std::vector<double>>(state.at("field/velocity").values);
  for (std::size_t i = 0; i < velocity.size(); i += dimension)
    for (std::size_t k = 0; k < velocity_gradient.size(); ++k)
      velocity[i + k / dimension] += velocity_gradient[k] * position[i + k % dimension];
  simulation.restore(state);
}

Result run_in(const fs::path& folder, const Scene& scene, const std::vector<double>& velocity_gradient) {
  const auto simulation = make_simulation(scene);
  if (!velocity_gradient.empty())
    set_in_motion(*simulation, static_cast<std::size_t>(scene.domain.dimension), velocity_gradient);
  Hdf5Series frames(folder, scene.name);
  RunOptions options;
  options.folder = {folder};
  Silent silent;
  run(*simulation, scene, options, frames, silent);
  return {scene, read_hdf5_frame(options.folder.last_frame()), read_history(folder / "history.csv")};
}

struct ProgramResult {
  int exit_code = -1;
  std::string text;  // of both streams
};

ProgramResult run_program(const ExtremeCase& extreme, const fs::path& results) {
  std::string command = "timeout 100 '" ANVIL_PROGRAM "' run '" + scene_file(extreme).string() + "' -o '" +
                        results.string() + "' --quiet --threads 1 --set output.format=hdf5";
  for (const auto& text : extreme.set) command += " --set '" + text + "'";
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("the program cannot be started");
  ProgramResult result;
  std::array<char, 4096> buffer{};
  for (std::size_t count = 1; count > 0;) {
    count = fread(buffer.data(), 1, buffer.size(), pipe);
    result.text.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
  return result;
}

void expect_stop(const ExtremeCase& extreme, ExitCode exit_code) {
  ASSERT_TRUE(fs::exists(ANVIL_PROGRAM));
  const TemporaryFolder folder;
  const fs::path results = folder / "results";
  const ProgramResult result = run_program(extreme, results);
  EXPECT_EQ(result.exit_code, static_cast<int>(exit_code)) << result.text;
  EXPECT_NE(result.text.find(extreme.phrase), std::string::npos) << "no '" << extreme.phrase << "' in:\n"
                                                                 << result.text;
  EXPECT_EQ(fs::exists(results), exit_code != ExitCode::bad_input) << "a refused scene leaves no results";
  if (fs::exists(results)) expect_numbers_in_all_files(results);
}

/// The same problem in other units of length and time.
Scene scaled(Scene scene, double factor) {
  scene.discretisation.spacing *= factor;
  scene.time.end *= factor;
  scene.output.interval *= factor;
  for (auto& body : scene.bodies)
    for (const auto& [key, value] : std::map(body.shape.parameters.all())) {
      if (const auto* number = std::get_if<double>(&value)) body.shape.parameters.set(key, *number * factor);
      if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
        std::vector<double> product = *numbers;
        for (double& each : product) each *= factor;
        body.shape.parameters.set(key, product);
      }
    }
  return scene;
}

/// Velocities, stresses and densities do not change with the unit of length when that of time changes with it; a factor
/// that is a power of two rounds nothing.
void expect_scaled(const Result& result, const Result& unscaled, double factor) {
  ASSERT_EQ(result.frame.step, unscaled.frame.step);
  ASSERT_GT(result.frame.step, 20);
  for (std::size_t k = 0; k < result.frame.positions.size(); ++k)
    ASSERT_EQ(result.frame.positions[k], factor * unscaled.frame.positions[k]) << "coordinate " << k;
  for (const auto& array : unscaled.frame.arrays) {
    const double by = array.unit == "m" ? factor : 1.0;
    const auto& values = result.frame.find(array.name)->values;
    for (std::size_t k = 0; k < values.size(); ++k)
      ASSERT_EQ(values[k], by * array.values[k]) << array.name << " " << k;
  }
}

void expect_answer(const ExtremeCase& extreme) {
  Scene scene = read_scene(scene_file(extreme), extreme.set);
  const TemporaryFolder folder;
  if (extreme.scale > 0.0) {
    const TemporaryFolder other;
    const Result unscaled = run_in(other.path(), scene, extreme.velocity_gradient);
    scene = scaled(scene, extreme.scale);
    std::vector<double> slower = extreme.velocity_gradient;
    for (double& rate : slower) rate /= extreme.scale;
    expect_scaled(run_in(folder.path(), scene, slower), unscaled, extreme.scale);
  } else {
    const Result result = run_in(folder.path(), scene, extreme.velocity_gradient);
    for (const auto& [measure, expected] : extreme.holds) {
      const double value = measure_extreme(measure, result, extreme);
      EXPECT_NEAR(value, expected.value, expected.within) << measure;
      if (std::getenv("ANVIL_SHOW") != nullptr) std::printf("    %s = %.9g\n", measure.c_str(), value);
    }
  }
  expect_numbers_in_all_files(folder.path());
}

class Extreme : public testing::TestWithParam<ExtremeCase> {};

TEST_P(Extreme, EndsAsItShould) {
  const ExtremeCase& extreme = GetParam();
  switch (extreme.ending) {
    case Ending::answer:
      return expect_answer(extreme);
    case Ending::failure:
      return expect_stop(extreme, ExitCode::numerical_failure);
    case Ending::refusal:
      return expect_stop(extreme, ExitCode::bad_input);
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, Extreme, testing::ValuesIn(extreme_cases()),
                         [](const auto& test) { return test.param.name; });

/// ANVIL_UPDATE_PAGES=1 in the environment writes the page anew instead.
TEST(Extremes, PageIsUpToDate) {
  const std::string file = ANVIL_SOURCE_DIR "/docs/robustness.md";
  const std::string page = robustness_page(extreme_cases());
  if (std::getenv("ANVIL_UPDATE_PAGES") != nullptr) std::ofstream(file) << page;
  std::ostringstream committed;
  committed << std::ifstream(file).rdbuf();
  EXPECT_EQ(committed.str(), page) << "run this test once with ANVIL_UPDATE_PAGES=1 and commit docs/robustness.md";
}

}  // namespace
}  // namespace anvil
