// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ostream.h>

#include <ostream>

#include "anvil/scene/schema.hpp"
#include "anvil/scene/writer.hpp"

namespace anvil {
namespace {

std::string default_text(const Key& key) {
  if (key.standard) return fmt::format("`{}`", write_value(*key.standard));
  if (!key.derived.empty()) return std::string(key.derived);
  return key.optional ? "none" : "**required**";
}

void write_keys(std::ostream& page, const std::vector<const Key*>& keys) {
  if (keys.empty()) {
    fmt::print(page, "No keys.\n\n");
    return;
  }
  fmt::print(page, "| key | value | default | meaning |\n|---|---|---|---|\n");
  for (const Key* key : keys)
    fmt::print(page, "| `{}` | {} | {} | {} |\n", key->name, expected_value(*key, 0), default_text(*key), key->help);
  fmt::print(page, "\n");
}

void write_kinds(std::ostream& page, std::string_view owner, const Key& entry) {
  for (const EntryKind& kind : entry.entries()) {
    fmt::print(page, "### {} `{}`\n\n{}.", entry.name == "type" ? owner : entry.name, kind.type, kind.summary);
    if (kind.dimensions != std::vector<int>{1, 2, 3}) {
      fmt::print(page, " In scenes of dimension");
      for (std::size_t i = 0; i < kind.dimensions.size(); ++i)
        fmt::print(page, "{} {}", i == 0 ? "" : " or", kind.dimensions[i]);
      fmt::print(page, ".");
    }
    fmt::print(page, "\n\n");
    std::vector<const Key*> keys;
    for (const Key& key : kind.keys) keys.push_back(&key);
    write_keys(page, keys);
  }
}

}  // namespace

void write_scene_reference(std::ostream& page) {
  fmt::print(
      page,
      "# Keys of a scene file\n\n"
      "Made from the tables the reader uses; a test fails when this page and the tables differ.\n"
      "Numbers are in SI units and written without them. A vector has as many components as the scene has dimensions;\n"
      "a default of one component holds for all of them. `--set KEY=VALUE` overrides any key, for example\n"
      "`--set time.end=1e-5`, `--set body.rod.velocity=[0,0,-300]` (body and boundary by their name),\n"
      "`--set material.copper.strength.yield_stress=3e8`.\n\n");
  for (const SectionKeys& section : scene_sections()) {
    const std::string heading = section_heading(section.name, section.occurrence);
    fmt::print(page, "## {}\n\n{}\n\n", heading.empty() ? "Top of the file" : "`" + heading + "`", section.help);
    write_keys(page, section.keys);
    for (const Key* key : section.keys)
      if (key->kind == ValueKind::entry) write_kinds(page, section.name, *key);
  }
}

}  // namespace anvil
