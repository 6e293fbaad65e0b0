// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <memory>
#include <span>

#include "anvil/core/tensor.hpp"
#include "anvil/scene/key.hpp"
#include "anvil/scene/scene.hpp"

namespace anvil {

/// The kinds of shapes a body can have, with their keys.
std::span<const EntryKind> shape_kinds();

/// The region a body fills at the start; lengths in m.
template <int D>
class Shape {
 public:
  Shape() = default;
  Shape(const Shape&) = delete;
  Shape& operator=(const Shape&) = delete;
  virtual ~Shape() = default;

  /// Middle and size of the box around the shape.
  [[nodiscard]] virtual Vec<D> centre() const = 0;
  [[nodiscard]] virtual Vec<D> size() const = 0;
  /// Whether the shape ends in two planes across that axis, so that only whole spacings fit between them.
  [[nodiscard]] virtual bool ends_in_planes(int axis) const = 0;
  /// Whether centre() + offset lies in the shape.
  [[nodiscard]] virtual bool contains(const Vec<D>& offset) const = 0;
  /// Where a particle at centre() + offset stands after the turn that the shape asks for, about its own axis.
  [[nodiscard]] virtual Vec<D> turned(const Vec<D>& offset) const { return offset; }
  /// Exact volume in m^D.
  [[nodiscard]] virtual double volume() const = 0;
  /// Largest offset . direction over the shape.
  [[nodiscard]] virtual double reach(const Vec<D>& direction) const = 0;
};

/// Throws InputError when the kind is unknown or not made for D dimensions, or when the shape is empty.
template <int D>
std::unique_ptr<Shape<D>> make_shape(const TypedEntry& entry);

}  // namespace anvil
