// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/measures/mirror.hpp"

#include <Eigen/Core>

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

  /// Adds the images of the points, vectors or tensors in `values` behind them.
  void double_points(std::vector<double>& values) const {
    double_tuples<3>(values, [this](const double* x, double* image) {
      const Vec<3> place = point_ + turn_ * (Vec<3>(x[0], x[1], x[2]) - point_);
      std::copy(place.begin(), place.end(), image);
    });
  }

  void double_vectors(std::vector<double>& values) const {
    double_tuples<3>(values, [this](const double* v, double* image) {
      const Vec<3> turned = turn_ * Vec<3>(v[0], v[1], v[2]);
      std::copy(turned.begin(), turned.end(), image);
    });
  }

  void double_tensors(std::vector<double>& values) const {
    double_tuples<6>(values, [this](const double* t, double* image) {
      Tensor full;
      full << t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2];
      const Tensor turned = turn_ * full * turn_.transpose();
      const double six[] = {turned(0, 0), turned(1, 1), turned(2, 2), turned(0, 1), turned(1, 2), turned(0, 2)};
      std::copy(std::begin(six), std::end(six), image);
    });
  }

 private:
  template <std::size_t Components, class Turn>
  static void double_tuples(std::vector<double>& values, Turn turn) {
    const std::size_t size = values.size();
    values.resize(2 * size);
    for (std::size_t i = 0; i < size; i += Components) turn(&values[i], &values[size + i]);
  }

  Vec<3> point_, normal_;
  Tensor turn_;
};

void repeat(std::vector<double>& values) {
  const std::size_t size = values.size();
  values.resize(2 * size);
  std::copy_n(values.begin(), size, values.begin() + static_cast<std::ptrdiff_t>(size));
}

}  // namespace

Frame with_mirror_image(const Frame& frame, const Plane& plane) {
  const Mirror mirror(plane);
  Frame both = frame;
  mirror.double_points(both.positions);
  for (FrameArray& array : both.arrays) {
    if (array.name == "initial_position")
      mirror.double_points(array.values);
    else if (array.components == 3)
      mirror.double_vectors(array.values);
    else if (array.components == 6)
      mirror.double_tensors(array.values);
    else
      repeat(array.values);
  }
  return both;
}

}  // namespace anvil
