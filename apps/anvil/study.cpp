// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/runner.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "anvil/core/error.hpp"
#include "anvil/core/threads.hpp"
#include "anvil/figures/drawing.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/study/finest.hpp"
#include "anvil/study/journal.hpp"
#include "anvil/study/record.hpp"
#include "anvil/study/report.hpp"
#include "anvil/study/stability.hpp"
#include "command_line.hpp"
#include "figure_file.hpp"
#include "progress.hpp"
#include "table.hpp"

#if ANVIL_WITH_VTK
#include "vtk_io/sample_file.hpp"
#endif

namespace anvil {
namespace {

namespace fs = std::filesystem;
namespace po = boost::program_options;

Usage make_usage() {
  Usage usage{
      "anvil study STUDY [-o DIR] [options]",
      "Runs the scenes of a study file, or of the bundled study of that name, over all values of its axes;\n"
      "prints tables and writes results.csv, results.h5, study.json and, where the study has some, figures\n"
      "into a folder. Each run takes one thread. Runs that fail are listed with their reason. Started again,\n"
      "it goes on with the runs that the folder does not have yet. A study.json is shown again, and drawn with -o.",
      "STUDY"};
  auto add = usage.options.add_options();
  add("output,o", po::value<std::string>()->value_name("DIR"), "folder of the results (default: results/<study>)");
  add("threads", po::value<int>()->value_name("N"), "runs at the same time (default: all processors)");
  add("again", po::bool_switch(), "run everything, also what the folder has from an earlier start");
  add("quiet", po::bool_switch(), "no progress, no tables");
  add_scene_options(usage);
  return usage;
}

/// How many runs are done and how long the others will take, by what they are expected to cost: a line that is
/// overwritten on a terminal, otherwise one every tenth of the runs.
class StudyLines {
 public:
  void show(const StudyPosition& position) {
    const auto [done, all, share] = position;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const double left = share > 0.0 ? elapsed * (1.0 - share) / share : 0.0;
    const std::string text = fmt::format("{} of {} runs  {} left", done, all, duration_text(left));
    constexpr const char* clear_to_end_of_line = "\x1b[K";
    if (terminal_)
      fmt::print(stderr, "\r{}{}{}", text, clear_to_end_of_line, done == all ? "\n" : "");
    else if (10 * done / all != 10 * (done - 1) / all)
      fmt::print(stderr, "{}\n", text);
    std::fflush(stderr);
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_ = isatty(STDERR_FILENO) == 1;
};

int threads_from(const po::variables_map& values) {
  constexpr int most = 1024;
  const int threads = values.count("threads") != 0 ? values["threads"].as<int>() : thread_count();
  if (threads < 1 || threads > most)
    throw InputError(fmt::format("--threads must be a whole number from 1 to {}, found {}", most, threads));
  return threads;
}

void print_report(const StudyDescription& study, const std::vector<StudyRun>& runs) {
  for (const auto& table : study_tables(study, runs)) {
    fmt::print("{}\n", table.title);
    print_table(table.rows, table.alignment);
    fmt::print("\n");
  }
  if (study.report == StudyReport::stability) return;  // outcomes, with their reasons in stability.csv
  for (const auto& run : runs)
    if (run.status != StudyStatus::finished)
      fmt::print("{} {} {}: {}\n", study.grids[run.grid].title, fmt::join(run.axis_values, ", "),
                 status_name(run.status), run.reason);
}

/// Bisects for the limits that a study of stability asks for.
void print_limits(const StudyDescription& study, const std::vector<StudyRun>& runs,
                  const std::vector<std::string>& set) {
  const auto limits = find_stability_limits(study, runs, set);
  if (limits.empty()) return;
  const StudyTable table = limit_table(study, limits);
  fmt::print("{}\n", table.title);
  print_table(table.rows, table.alignment);
  fmt::print("\n");
}

/// SVG, and PNG where this build can write it.
void draw_figures(const StudyDescription& study, const std::vector<StudyRun>& runs, const fs::path& folder,
                  std::vector<fs::path>& files) {
  for (const auto& [suffix, figure] : study_figures(study, runs)) {
    const Drawing drawing = lay_out(figure);
    files.push_back(folder / (study.name + suffix + ".svg"));
    write_figure(drawing, files.back());
#if ANVIL_WITH_VTK
    files.push_back(folder / (study.name + suffix + ".png"));
    write_figure(drawing, files.back());
#endif
  }
}

/// Tables and figures of a study.json, without running anything.
void show_record(const fs::path& file, const po::variables_map& values) {
  const auto [study, runs] = read_study_record(file);
  // Its maps need the scenes of the runs.
  if (study.report == StudyReport::stability) throw InputError("a study of stability is drawn where it is run");
  std::vector<fs::path> files;
  if (values.count("output") != 0) {
    const fs::path folder = values["output"].as<std::string>();
    ensure_folder(folder);
    draw_figures(study, runs, folder, files);
  }
  print_report(study, runs);
  for (const auto& one : files) fmt::print("{}\n", one.string());
}

std::vector<fs::path> write_results(const StudyDescription& study, const std::vector<StudyRun>& runs,
                                    const StudyPeriod& period, const fs::path& folder) {
  std::vector<fs::path> files = {folder / "results.csv", folder / "results.h5", folder / "study.json"};
  write_text_atomically(files[0], study_csv(study, runs));
  write_study_h5(files[1], study, runs);
  write_text_atomically(files[2], study_json(study, runs, period));
  if (study.report == StudyReport::stability) {
    files.push_back(folder / "stability.csv");
    write_text_atomically(files.back(), stability_csv(study, runs));
#if ANVIL_WITH_VTK
    for (std::size_t grid = 0; grid < study.grids.size(); ++grid)
      if (const auto map = stability_map(study, runs, grid)) {
        files.push_back(folder / fmt::format("{}_{}.vti", study.name, grid + 1));
        write_sample_file(map->frame, map->grid, files.back());
      }
#endif
  }
  draw_figures(study, runs, folder, files);
  return files;
}

}  // namespace

int execute_study(const Arguments& arguments) {
  Usage usage = make_usage();
  const auto values = parse(usage, arguments);
  if (!values) return 0;
  const std::string argument = required(*values, usage, "STUDY");
  if (fs::path(argument).extension() == ".json") {
    show_record(argument, *values);
    return 0;
  }
  const StudyDescription study = read_study(locate_study(argument));
  const fs::path folder =
      values->count("output") != 0 ? fs::path((*values)["output"].as<std::string>()) : fs::path("results") / study.name;
  const bool quiet = (*values)["quiet"].as<bool>();
  const int threads = threads_from(*values);
  auto runs = prepare_study(study, repeated(*values, "set"));
  ensure_folder(folder);
  if ((*values)["again"].as<bool>()) remove_file(folder / "runs.jsonl");
  StudyJournal journal(folder / "runs.jsonl");
  const std::size_t known = journal.restore(study, runs);
  if (known > 0 && !quiet) fmt::print(stderr, "{} of {} runs are there already\n", known, runs.size());
  StudyLines lines;
  StudyPeriod period{utc_now(), ""};
  const auto show = [&](const StudyPosition& position) {
    if (!quiet) lines.show(position);
  };
  run_study(study, runs, threads, show, [&](const StudyRun& run) { journal.append(study, run); });
  period.ended = utc_now();
  compare_with_finest(study, runs);
  const auto files = write_results(study, runs, period, folder);
  if (quiet) return 0;
  print_report(study, runs);
  if (study.report == StudyReport::stability) print_limits(study, runs, repeated(*values, "set"));
  for (const auto& file : files) fmt::print("{}\n", file.string());
  return 0;
}

}  // namespace anvil
