// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/record.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "anvil/core/error.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/hdf5_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/study/measures.hpp"

namespace anvil {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* format_name = "anvil study 1";
constexpr std::array reports = {"table", "orders", "speeds", "cost", "stability"};

/// JSON knows no NaN: null stands for it.
Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
double number_of(const Json& json) { return json.is_null() ? std::nan("") : json.get<double>(); }

Json outcome(const StudyRun& run) {
  Json rows = Json::array();
  for (const auto& row : run.rows) {
    Json values = Json::array();
    for (const double value : row.values) values.push_back(number_or_null(value));
    rows.push_back({{"time", row.time}, {"values", values}});
  }
  return {{"status", status_name(run.status)}, {"reason", run.reason},   {"particles", run.particles},
          {"neighbours", run.neighbours},      {"steps", run.steps},     {"wall_time", run.seconds},
          {"cpu_time", run.cpu_seconds},       {"rows", std::move(rows)}};
}

void read_outcome_from(const Json& json, StudyRun& run) {
  const auto status = json.at("status").get<std::string>();
  for (const auto one : {StudyStatus::finished, StudyStatus::failed, StudyStatus::refused})
    if (status == status_name(one)) run.status = one;
  run.reason = json.at("reason").get<std::string>();
  run.particles = json.at("particles").get<std::size_t>();
  run.neighbours = json.at("neighbours").get<double>();
  run.steps = json.at("steps").get<std::int64_t>();
  run.seconds = json.at("wall_time").get<double>();
  run.cpu_seconds = json.at("cpu_time").get<double>();
  run.rows.clear();
  for (const auto& entry : json.at("rows")) {
    StudyRow& row = run.rows.emplace_back();
    row.time = entry.at("time").get<double>();
    for (const auto& value : entry.at("values")) row.values.push_back(number_of(value));
  }
}

Json grid_json(const StudyGrid& grid) {
  Json axes = Json::array();
  for (const auto& axis : grid.axes) axes.push_back({{"key", axis.key}, {"values", axis.values}});
  // A scene file of the user's is named without its folder.
  return {{"title", grid.title}, {"scene", std::filesystem::path(grid.scene).stem().string()},
          {"set", grid.set},     {"times", grid.times},
          {"axes", axes},        {"measures", grid.measures}};
}

StudyGrid read_grid(const Json& json) {
  StudyGrid grid;
  grid.title = json.at("title").get<std::string>();
  grid.scene = json.at("scene").get<std::string>();
  grid.set = json.at("set").get<std::vector<std::string>>();
  grid.times = json.at("times").get<std::vector<double>>();
  grid.measures = json.at("measures").get<std::vector<std::string>>();
  for (const auto& axis : json.at("axes"))
    grid.axes.push_back({axis.at("key").get<std::string>(), axis.at("values").get<std::vector<std::string>>()});
  return grid;
}

}  // namespace

std::string outcome_json(const StudyRun& run) { return outcome(run).dump(); }

void read_outcome(const std::string& json, StudyRun& run) {
  try {
    read_outcome_from(Json::parse(json), run);
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("a run of a study cannot be read: {}", error.what()));
  }
}

std::string study_json(const StudyDescription& study, const std::vector<StudyRun>& runs, const StudyPeriod& period) {
  const Provenance program = make_provenance();
  Json document = {{"format", format_name},        {"name", study.name},
                   {"title", study.title},         {"report", reports[static_cast<std::size_t>(study.report)]},
                   {"version", program.version},   {"commit", program.commit},
                   {"compiler", program.compiler}, {"started", period.started},
                   {"ended", period.ended},        {"grids", Json::array()}};
  for (std::size_t number = 0; number < study.grids.size(); ++number) {
    Json grid = grid_json(study.grids[number]);
    grid["runs"] = Json::array();
    for (const auto& run : runs) {
      if (run.grid != number) continue;
      Json entry = {{"values", run.axis_values}};
      entry.update(outcome(run));
      grid["runs"].push_back(std::move(entry));
    }
    document["grids"].push_back(std::move(grid));
  }
  return document.dump(1) + "\n";
}

StudyRecord read_study_record(const std::filesystem::path& file) {
  StudyRecord record;
  try {
    const auto document = Json::parse(read_text(file));
    if (document.at("format") != format_name)
      throw InputError(fmt::format("'{}' is no {}", file.string(), format_name));
    record.study.name = document.at("name").get<std::string>();
    record.study.title = document.at("title").get<std::string>();
    for (std::size_t kind = 0; kind < reports.size(); ++kind)
      if (document.at("report") == reports[kind]) record.study.report = static_cast<StudyReport>(kind);
    for (const auto& json : document.at("grids")) {
      record.study.grids.push_back(read_grid(json));
      for (const auto& entry : json.at("runs")) {
        StudyRun& run = record.runs.emplace_back();
        run.grid = record.study.grids.size() - 1;
        run.axis_values = entry.at("values").get<std::vector<std::string>>();
        read_outcome_from(entry, run);
      }
    }
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("'{}' is no study.json of anvil: {}", file.string(), error.what()));
  }
  return record;
}

void write_study_h5(const std::filesystem::path& file, const StudyDescription& study,
                    const std::vector<StudyRun>& runs) {
  write_atomically(file, [&](const std::filesystem::path& temporary) {
    Hdf5File h5 = Hdf5File::create(temporary, format_name);
    h5.write("title", study.title);
    for (std::size_t number = 0; number < study.grids.size(); ++number) {
      const StudyGrid& grid = study.grids[number];
      const std::string group = fmt::format("grid_{}/", number + 1);
      const std::size_t measures = grid.measures.size(), times = grid.times.size();
      std::string settings;
      Hdf5Table<double> values{static_cast<int>(measures), "", {}}, cpu{1, "s", {}}, wall{1, "s", {}},
          neighbours{1, "", {}};
      Hdf5Table<std::int64_t> particles{1, "", {}}, steps{1, "", {}};
      for (const auto& run : runs) {
        if (run.grid != number) continue;
        settings += fmt::format("{}\t{}\n", fmt::join(run.axis_values, "\t"), status_name(run.status));
        for (std::size_t time = 0; time < times; ++time)
          for (std::size_t m = 0; m < measures; ++m)
            values.values.push_back(time < run.rows.size() ? run.rows[time].values[m] : std::nan(""));
        cpu.values.push_back(run.cpu_seconds);
        wall.values.push_back(run.seconds);
        neighbours.values.push_back(run.neighbours);
        particles.values.push_back(static_cast<std::int64_t>(run.particles));
        steps.values.push_back(run.steps);
      }
      h5.write(group + "title", grid.title);
      h5.write(group + "runs", settings);
      h5.write(group + "measures", fmt::format("{}", fmt::join(grid.measures, "\n")));
      h5.write(group + "times", Hdf5Table<double>{1, "s", grid.times});
      h5.write(group + "values", values);
      h5.write(group + "cpu_time", cpu);
      h5.write(group + "wall_time", wall);
      h5.write(group + "neighbours", neighbours);
      h5.write(group + "particles", particles);
      h5.write(group + "steps", steps);
    }
    h5.close();
  });
}

}  // namespace anvil
