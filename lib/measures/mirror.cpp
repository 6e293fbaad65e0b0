// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/mirror.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "anvil/core/tensor.hpp"

namespace anvil {
namespace {

class Mirror {
 public:
  explicit Mirror(const Plane& plane)
      : point_(plane.point[0], plane.point[1], plane.point[2]),
        normal_(plane.normal[0], plane.normal[1], plane.normal[2]) {
    normal_.normalize();
    turn_ = Tensor::Identity() - 2.0 * normal_ * normal_.transpose();
  }

  [[nodiscard]] double distance(const double* x) const { return normal_.dot(Vec<3>(x[0], x[1], x[2]) - point_); }

  void turn_point(const double* x, double* image) const {
    const Vec<3> place = point_ + turn_ * (Vec<3>(x[0], x[1], x[2]) - point_);
    std::copy(place.begin(), place.end(), image);
  }

  void turn_vector(const double* v, double* image) const {
    const Vec<3> turned = turn_ * Vec<3>(v[0], v[1], v[2]);
    std::copy(turned.begin(), turned.end(), image);
  }

  void turn_tensor(const double* t, double* image) const {
    Tensor full;
    full << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
    const Tensor turned = turn_ * full * turn_.transpose();
    const double six[] = {turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1), turned(1, 2), turned(0, 2)};
    std::copy(std::begin(six), std::end(six), image);
  }

 private:
  Vec<3> point_, normal_;
  Tensor turn_;
};

/// Particles that have an image: all but those on the plane, which are halves of themselves.
std::vector<std::size_t> beside_plane(const Frame& frame, const Mirror& mirror) {
  double largest = 0.0;
  for (const double x : frame.positions) largest = std::max(largest, std::abs(x));
  const double rounding = 1e-6 * largest;  // of positions in single precision
  std::vector<std::size_t> beside;
  for (std::size_t i = 0; i < frame.particle_count(); ++i)
    if (!(std::abs(mirror.distance(&frame.positions[3 * i])) <= rounding)) beside.push_back(i);
  return beside;
}

template <class Turn>
void add_images(std::vector<double>& values, std::size_t components, const std::vector<std::size_t>& of, Turn turn) {
  std::size_t image = values.size();
  values.resize(image + components * of.size());
  for (const std::size_t i : of) {
    turn(&values[i * components], &values[image]);
    image += components;
  }
}

/// Of the two halves together.
void double_masses_on_plane(std::vector<double>& masses, const std::vector<std::size_t>& beside) {
  std::vector<bool> is_beside(masses.size(), false);
  for (const std::size_t i : beside) is_beside[i] = true;
  for (std::size_t i = 0; i < masses.size(); ++i)
    if (!is_beside[i]) masses[i] *= 2.0;
}

}  // namespace

Frame with_mirror_image(const Frame& frame, const Plane& plane) {
  const Mirror mirror(plane);
  const auto beside = beside_plane(frame, mirror);
  const auto point = [&](const double* x, double* image) { mirror.turn_point(x, image); };
  Frame both = frame;
  add_images(both.positions, 3, beside, point);
  for (FrameArray& array : both.arrays) {
    const auto components = static_cast<std::size_t>(array.components);
    if (array.name == "mass") double_masses_on_plane(array.values, beside);
    if (array.name == "initial_position")
      add_images(array.values, 3, beside, point);
    else if (array.components == 3)
      add_images(array.values, 3, beside, [&](const double* v, double* image) { mirror.turn_vector(v, image); });
    else if (array.components == 6)
      add_images(array.values, 6, beside, [&](const double* t, double* image) { mirror.turn_tensor(t, image); });
    else
      add_images(array.values, components, beside,
                 [&](const double* value, double* image) { std::copy_n(value, components, image); });
  }
  return both;
}

}  // namespace anvil
