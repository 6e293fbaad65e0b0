// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "anvil/study/runner.hpp"

namespace anvil {

/// What a run gave, as one line of JSON without its settings: status, reason, rows, cost.
std::string outcome_json(const StudyRun& run);
/// Fills in what outcome_json wrote. Throws InputError for another text.
void read_outcome(const std::string& json, StudyRun& run);

/// When a study ran.
struct StudyPeriod {
  std::string started, ended;  // UTC, ISO 8601
};

/// study.json: the study, the program that ran it, and every run with all its settings, outcome and cost.
/// It names no machine and no user.
std::string study_json(const StudyDescription& study, const std::vector<StudyRun>& runs, const StudyPeriod& period);

/// A study as it stands in its study.json: grids with `values_of` and `times` as they were run.
struct StudyRecord {
  StudyDescription study;
  std::vector<StudyRun> runs;
};
/// Throws InputError when the file cannot be read or is no study.json of anvil.
StudyRecord read_study_record(const std::filesystem::path& file);

/// results.h5: per grid the values of the axes as text, times, measures as runs x times x measures (NaN where not
/// seen), and cost, with units.
void write_study_h5(const std::filesystem::path& file, const StudyDescription& study,
                    const std::vector<StudyRun>& runs);

}  // namespace anvil
