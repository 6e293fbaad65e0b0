// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "anvil/study/runner.hpp"

namespace anvil {

/// The runs of a folder that have ended, a line of JSON each, so that a study that was interrupted, or grew, goes on
/// where it was. A run is known by its resolved scene, its times and measures and the program that made it.
class StudyJournal {
 public:
  /// Reads what is there; a torn last line, of a study that was killed, is left out.
  explicit StudyJournal(std::filesystem::path file);

  /// Puts the outcome of every run that is known in its place. Returns how many are.
  std::size_t restore(const StudyDescription& study, std::vector<StudyRun>& runs) const;
  /// Notes the outcome of a run that has ended. Throws MissingResourceError.
  void append(const StudyDescription& study, const StudyRun& run);

 private:
  std::filesystem::path file_;
  std::map<std::string, std::string> lines_;  // by the identifier of a run
};

}  // namespace anvil
