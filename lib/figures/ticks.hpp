// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace anvil {

/// 1, 2, 2.5 or 5 times a power of ten, so that `span` (above 0) takes about `intervals` of them.
double nice_step(double span, int intervals);

/// The multiples of `step` from `low` to `high`, both included.
std::vector<double> multiples_between(double low, double high, double step);

/// printf format with as many decimals as the multiples of `step` need: "%.1f", or "%.2e" for very large and small
/// ones.
std::string tick_format(double step, double largest);

}  // namespace anvil
