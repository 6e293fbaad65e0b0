// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "anvil/figures/description.hpp"
#include "anvil/figures/figure.hpp"
#include "anvil/output/frame.hpp"
#include "anvil/output/history.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// A result as figures read it, whatever the format of its frames.
struct PlottedResult {
  std::string label;                        // tells results of one figure apart
  std::optional<Scene> scene;               // absent: not left behind by a run of Anvil
  std::optional<History> history;           // absent likewise
  std::vector<double> times;                // of the frames, s, ascending
  std::function<Frame(std::size_t)> frame;  // by its place in `times`; reads it
};

/// The number of the frame at a time (s) in an ascending list; throws InputError with the nearest times when there is
/// none. `result` names the result in errors.
std::size_t frame_at(const std::vector<double>& times, double time, const std::string& result);

/// The figure of a description: fields and histories of all results, each curve once per result, the exact solution of
/// the first. Throws InputError when a field, a time, a column or a unit does not exist or fit.
Figure build_figure(const FigureDescription& description, const std::vector<PlottedResult>& results);

}  // namespace anvil
