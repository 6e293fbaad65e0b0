// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "anvil/scene/scene.hpp"
#include "anvil/study/record.hpp"

namespace anvil {

/// How near a scene that was measured is to one that is asked about.
enum class Nearness {
  none,
  kind,  // dimension, strain state, kinds of boundaries and materials; speeds and loads within a factor of two
  same   // the same problem: only how it is computed differs
};
Nearness nearness(const Scene& asked, const Scene& measured);

/// What is wanted of a run: an error that it must reach, or CPU time that it may take.
struct Wish {
  std::optional<double> error;    // of the measure
  std::optional<double> seconds;  // on one thread of this machine
  std::string measure;            // "": the first one of the record
};

/// Settings for a scene, and what measured runs say about them.
struct Recommendation {
  std::vector<std::string> settings;  // KEY=VALUE
  Nearness rests_on = Nearness::none;
  std::string study;           // name of the record
  std::string measured_scene;  // the scene of its runs
  std::string measure;
  std::vector<double> times;  // s, that the error is a mean over
  std::size_t points = 0;     // measured runs it was chosen from
  double error = 0.0;
  double particles = 0.0, steps = 0.0;
  double seconds = 0.0;        // CPU time expected on this machine, one thread
  double machine_ratio = 1.0;  // time of a run here, now, over that of the record
};

/// Time of a run of a record on this machine over what the record says: the dearest run of `grid` that takes less than
/// half a second is repeated.
double machine_ratio(const StudyRecord& record, std::size_t grid);

/// The cheapest measured settings that reach the error, or the most accurate ones within the time. Records of the same
/// scene go before those of its kind. For a scene of its kind, the spacing is scaled to keep the number of particles
/// along the longest side, and the steps as the first time step asks. `scene` is a file or a bundled name, `set`
/// (KEY=VALUE) belongs to it. Throws InputError when no record is near, or none of its runs does what is wished, with
/// the best there is.
Recommendation recommend(const std::string& scene, const std::vector<std::string>& set, const Wish& wish,
                         const std::vector<StudyRecord>& records);

/// The records that come with Anvil (data/fronts).
std::vector<StudyRecord> bundled_study_records();

}  // namespace anvil
