// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// A plane along which a shape is one half of something symmetric about it, oblique to its lattice: it cuts cells, and
/// particles can stand on it. Lengths in m.
template <int D>
struct Cut {
  Vec<D> point;   // from the middle of the box around the shape
  Vec<D> normal;  // of unit length, towards the shape

  /// How far in front of it a place lies, seen from the middle of the box.
  [[nodiscard]] double height(const Vec<D>& offset) const { return normal.dot(offset - point); }
};

/// That of a half box or of a wedge of less than a quarter. Throws InputError when keys disagree.
template <int D>
std::optional<Cut<D>> cut_of(const TypedEntry& shape);

}  // namespace anvil
