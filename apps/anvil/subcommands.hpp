// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace anvil {

using Arguments = std::vector<std::string>;

/// One of the verbs of `anvil`. `execute` gets what follows the verb and returns what goes back to the shell.
struct Subcommand {
  std::string_view name;
  std::string_view summary;
  int (*execute)(const Arguments& arguments);
};

/// All that this build has, in the order of the help.
std::span<const Subcommand> subcommands();

int execute_check(const Arguments& arguments);
int execute_compare(const Arguments& arguments);
int execute_exact(const Arguments& arguments);
int execute_explain(const Arguments& arguments);
int execute_info(const Arguments& arguments);
int execute_list(const Arguments& arguments);
int execute_plot(const Arguments& arguments);
int execute_render(const Arguments& arguments);  // only in a build with VTK
int execute_run(const Arguments& arguments);
int execute_sample(const Arguments& arguments);
int execute_recommend(const Arguments& arguments);
int execute_study(const Arguments& arguments);

}  // namespace anvil
