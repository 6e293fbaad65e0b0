// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options.hpp>

#include "anvil/study/recommend.hpp"

namespace anvil {

/// Adds --error, --budget, --measure and --from.
void add_wish_options(boost::program_options::options_description& options);

/// Settings for a scene by these options; nothing when neither --error nor --budget is given. Throws InputError when
/// both are, and when `set` names a key that they would choose.
std::optional<Recommendation> recommendation_of(const boost::program_options::variables_map& values,
                                                const std::string& scene, const std::vector<std::string>& set);

/// What to expect, and what that rests on, for people.
std::string describe(const Recommendation& recommendation);

}  // namespace anvil
