// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <toml++/toml.h>

#include <span>
#include <string>

#include "anvil/scene/value_reader.hpp"

namespace anvil {

/// Puts the values of `KEY=VALUE` texts into a document, where their nodes name `--set KEY=VALUE` as their place. VALUE
/// is TOML; what is not is taken as a text, so that words need no quotes. KEY addresses an element of an array of
/// tables by its name: body.rod.velocity. What cannot be placed becomes a problem of the context; whether a key exists
/// and a value fits is left to the reader.
void apply_overrides(toml::table& document, std::span<const std::string> overrides, ReadContext& context);

}  // namespace anvil
