// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/output/provenance.hpp"

#include <fmt/chrono.h>
#include <fmt/core.h>
#include <omp.h>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include "anvil/core/error.hpp"
#include "anvil/core/simd_level.hpp"
#include "anvil/output/atomic_file.hpp"
#include "anvil/version.hpp"

namespace anvil {
namespace {

/// Any fixed UUID does as the namespace of the names; this one is Anvil's.
constexpr boost::uuids::uuid scene_namespace = {{0x5d, 0x1c, 0x0e, 0x4e, 0x93, 0x0b, 0x4b, 0x1f,  //
                                                 0xa6, 0x6e, 0x2b, 0x7a, 0x0c, 0x41, 0x8d, 0x35}};

/// Calls visit(key, member) for every entry of run.json, in the order of the file.
template <class ProvenanceType, class Visitor>
void for_each_entry(ProvenanceType& provenance, Visitor&& visit) {
  visit("title", provenance.title);
  visit("scene", provenance.scene_name);
  visit("scene_id", provenance.scene_id);
  visit("status", provenance.status);
  visit("reason", provenance.reason);
  visit("version", provenance.version);
  visit("commit", provenance.commit);
  visit("compiler", provenance.compiler);
  visit("instruction_set", provenance.instruction_set);
  visit("threads", provenance.threads);
  visit("started", provenance.started);
  visit("ended", provenance.ended);
  visit("particles", provenance.particles);
  visit("steps", provenance.steps);
  visit("time", provenance.time);
  visit("first_step", provenance.first_step);
  visit("wall_time", provenance.wall_time);
  visit("step_time", provenance.step_time);
  visit("particle_steps_per_second", provenance.particle_steps_per_second);
  visit("scene_text", provenance.scene_text);
}

}  // namespace

Provenance make_provenance() {
  Provenance provenance;
  provenance.version = version;
  provenance.commit = commit;
  provenance.compiler = fmt::format("{}, {}", compiler, build_type);
  provenance.instruction_set = simd_level();
  provenance.threads = omp_get_max_threads();
  return provenance;
}

std::string identify_scene(const std::string& scene_text) {
  return boost::uuids::to_string(boost::uuids::name_generator_sha1(scene_namespace)(scene_text));
}

std::string utc_now() {
  const auto now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

void write_provenance(const std::filesystem::path& path, const Provenance& provenance) {
  nlohmann::ordered_json document;
  for_each_entry(provenance, [&](const char* key, const auto& member) { document[key] = member; });
  write_text_atomically(path, document.dump(2) + "\n");
}

Provenance read_provenance(const std::filesystem::path& path) {
  Provenance provenance;
  try {
    const auto document = nlohmann::json::parse(read_text(path));
    for_each_entry(provenance, [&](const char* key, auto& member) { document.at(key).get_to(member); });
  } catch (const nlohmann::json::exception& error) {
    throw InputError(fmt::format("'{}' is not a run.json of anvil: {}", path.string(), error.what()));
  }
  return provenance;
}

}  // namespace anvil
