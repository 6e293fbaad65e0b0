// SPDX-License-Identifier: BSD-3-Clause
#include "subcommands.hpp"

#include <array>

#include "figures_program.hpp"

namespace anvil {
namespace {

#if !ANVIL_DRAWS
constexpr auto plot = [](const Arguments& arguments) { return execute_figures_program("plot", arguments); };
constexpr auto study = [](const Arguments& arguments) { return execute_figures_program("study", arguments); };
constexpr auto render = [](const Arguments& arguments) { return execute_figures_program("render", arguments); };
#else
constexpr auto plot = execute_plot;
constexpr auto study = execute_study;
#if ANVIL_WITH_VTK
constexpr auto render = execute_render;
#endif
#endif

}  // namespace

std::span<const Subcommand> subcommands() {
  static constexpr std::array table = {
    Subcommand{"run", "run a scene and write its result", execute_run},
    Subcommand{"check", "say whether a scene is fine, or all that is wrong with it", execute_check},
    Subcommand{"explain", "show what a scene computes with, and what it will cost", execute_explain},
    Subcommand{"list", "list scenes, materials, kernels, models, keys", execute_list},
    Subcommand{"compare", "compare a result with the reference of its scene", execute_compare},
    Subcommand{"exact", "print the exact solution of a scene at a time", execute_exact},
    Subcommand{"plot", "draw profiles, histories and x-t diagrams of a result", plot},
    Subcommand{"sample", "values between the particles on a line or a plane", execute_sample},
    Subcommand{"study", "run a scene over many settings and tabulate what comes out", study},
    Subcommand{"recommend", "settings that reach an error or keep to a time, from measured runs", execute_recommend},
#if ANVIL_WITH_VTK
    Subcommand{"render", "draw a frame of a result", render},
#endif
    Subcommand{"info", "show where a result, a frame or a checkpoint comes from", execute_info},
  };
  return table;
}

}  // namespace anvil
