// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/study/journal.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

#include "anvil/output/atomic_file.hpp"
#include "anvil/output/provenance.hpp"
#include "anvil/scene/writer.hpp"
#include "anvil/study/record.hpp"
#include "anvil/version.hpp"

namespace anvil {
namespace {

std::string identify_run(const StudyGrid& grid, const StudyRun& run) {
  return identify_scene(fmt::format("{}\n{}\n{}\n{} {}", write_scene(*run.scene), fmt::join(grid.times, " "),
                                    fmt::join(grid.measures, " "), version, commit));
}

}  // namespace

StudyJournal::StudyJournal(std::filesystem::path file) : file_(std::move(file)) {
  std::ifstream stream(file_);
  for (std::string line; std::getline(stream, line);) {
    const auto entry = nlohmann::json::parse(line, nullptr, false);
    if (entry.is_object() && entry.contains("id") && entry.contains("run"))
      lines_[entry["id"].get<std::string>()] = entry["run"].dump();
  }
}

std::size_t StudyJournal::restore(const StudyDescription& study, std::vector<StudyRun>& runs) const {
  std::size_t known = 0;
  for (auto& run : runs) {
    if (!run.scene) continue;
    const auto found = lines_.find(identify_run(study.grids[run.grid], run));
    if (found == lines_.end()) continue;
    read_outcome(found->second, run);
    run.known = true;
    ++known;
  }
  return known;
}

void StudyJournal::append(const StudyDescription& study, const StudyRun& run) {
  if (!run.scene) return;  // refused: there is nothing to save
  const std::string id = identify_run(study.grids[run.grid], run);
  std::ofstream stream(file_, std::ios::app);
  // A new line first: the last one may be torn.
  stream << fmt::format("\n{{\"id\":\"{}\",\"run\":{}}}", id, outcome_json(run)) << std::flush;
  if (!stream) throw_system_error("write", file_, errno);
}

}  // namespace anvil
