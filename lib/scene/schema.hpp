// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iosfwd>
#include <string_view>
#include <variant>
#include <vector>

#include "anvil/scene/key.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// Where the value of a key goes.
template <class Owner>
using Member = std::variant<double Owner::*, int Owner::*, bool Owner::*, std::string Owner::*,
                            std::vector<double> Owner::*, Texts Owner::*, NamedNumbers Owner::*, TypedEntry Owner::*>;

template <class Owner>
struct KeyRow {
  Key key;
  Member<Owner> member;
};

/// How a section stands in a file.
enum class Occurrence { top_level, once /* [name] */, list /* [[name]] */, by_name /* [name.NAME] */ };

/// One section of a scene file and the struct it fills. A key of kind entry that is called `type` takes the keys of its
/// entry from the section itself, any other from a table of its own.
template <class Owner>
struct Section {
  std::string_view name;
  Occurrence occurrence = Occurrence::once;
  std::string_view help;
  std::vector<KeyRow<Owner>> rows;
};

struct Schema {
  Section<Scene> scene;
  Section<Domain> domain;
  Section<Discretisation> discretisation;
  Section<Shock> shock;
  Section<Stabiliser> stabiliser;
  Section<TimeControl> time;
  Section<BodyDescription> body;
  Section<MaterialDescription> material;
  Section<BoundaryDescription> boundary;
  Section<OutputControl> output;
  Section<Comparison> compare;
};

/// Every key a scene file can hold: a new one is one row here and one member in scene.hpp.
const Schema& schema();

/// Calls visit(section, member of the scene) for each section, in the order of the reference page. The member is a list
/// for the sections that can stand more than once. `SceneType` is Scene or const Scene.
template <class SceneType, class Visitor>
void for_each_section(SceneType& scene, Visitor&& visit) {
  const Schema& all = schema();
  visit(all.scene, scene);
  visit(all.domain, scene.domain);
  visit(all.discretisation, scene.discretisation);
  visit(all.shock, scene.shock);
  visit(all.stabiliser, scene.stabiliser);
  visit(all.time, scene.time);
  visit(all.body, scene.bodies);
  visit(all.material, scene.materials);
  visit(all.boundary, scene.boundaries);
  visit(all.output, scene.output);
  visit(all.compare, scene.compare);
}

/// A section without its struct, for lists and pages.
struct SectionKeys {
  std::string_view name;
  Occurrence occurrence;
  std::string_view help;
  std::vector<const Key*> keys;
};
std::vector<SectionKeys> scene_sections();

/// How a section's heading is written in a file: [time], [[body]], [material.NAME]; "" for the top level.
std::string section_heading(std::string_view name, Occurrence occurrence);

/// The reference page of all scene keys, in Markdown: docs/scene_keys.md.
void write_scene_reference(std::ostream& page);

}  // namespace anvil
