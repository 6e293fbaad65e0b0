// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "anvil/output/frame.hpp"
#include "anvil/output/history.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// What a run left behind, as far as it is measured.
struct Result {
  Scene scene;
  Frame frame;  // the last one
  History history;
};

}  // namespace anvil
