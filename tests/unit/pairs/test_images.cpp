// SPDX-License-Identifier: BSD-3-Clause
#include "anvil/pairs/images.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "anvil/terms/momentum.hpp"
#include "unit/pairs/cloud.hpp"

namespace anvil {
namespace {

constexpr double spacing = Cloud<2>::spacing;
constexpr double skin = 0.3 * spacing;

/// Everything a pair loop reads of one particle.
template <int D>
struct Particle {
  Vec<D> position, velocity;
  double smoothing_length, mass, density, pressure;
  std::array<double, symmetric_components<D>> deviator;
};

template <int D>
Particle<D> particle_of(Cloud<D>& cloud, std::size_t i) {
  Particle<D> one{cloud.position()[i],
                  cloud.velocity()[i],
                  cloud.scalar(field::smoothing_length, i),
                  cloud.scalar(field::mass, i),
                  cloud.scalar(field::density, i),
                  cloud.scalar(field::pressure, i),
                  {}};
  std::copy_n(cloud.deviator(i), symmetric_components<D>, one.deviator.begin());
  return one;
}

template <int D>
Particle<D> moved(const Particle<D>& one, const Transform<D>& transform) {
  Particle<D> other = one;
  other.position = transform(one.position);
  turn_vector<D>(transform.velocity_turn, one.velocity.data(), other.velocity.data());
  turn_symmetric<D>(transform.turn, one.deviator.data(), other.deviator.data());
  return other;
}

/// A cloud of given particles, with images when there are any to be found.
template <int D>
struct ImagedCloud {
  ImagedCloud(const std::vector<Particle<D>>& particles, Images<D> found)
      : images(std::move(found)), cloud(CubicSpline(), positions_of(particles)) {
    for (std::size_t i = 0; i < particles.size(); ++i) {
      cloud.velocity()[i] = particles[i].velocity;
      cloud.fields.scalar(field::smoothing_length)[i] = particles[i].smoothing_length;
      cloud.fields.scalar(field::mass)[i] = particles[i].mass;
      cloud.fields.scalar(field::density)[i] = particles[i].density;
      cloud.fields.scalar(field::pressure)[i] = particles[i].pressure;
      std::copy(particles[i].deviator.begin(), particles[i].deviator.end(), cloud.deviator(i));
    }
    const auto h = cloud.fields.scalar(field::smoothing_length);
    const double longest = *std::max_element(h.begin(), h.end());
    if (images.possible()) images.find(cloud.position(), h, cloud.support() * longest + skin);
    cloud.list.build(cloud.position(), h, cloud.support(), skin, pair_loops<D>(), images.sites());
    cloud.records.resize(cloud.count, {.medium = true});
    cloud.pack();
    momentum.pack({0, static_cast<std::int32_t>(cloud.count)}, cloud.records);
    cloud.records.set_images(images.count());
    images.fill_geometry(cloud.records, cloud.records.first_image());
    images.fill_motion(cloud.records, cloud.records.first_image());
    images.fill_traction(cloud.records, cloud.records.first_image());
    images.fill_medium(cloud.records, cloud.records.first_image());
  }

  static std::vector<Vec<D>> positions_of(const std::vector<Particle<D>>& particles) {
    std::vector<Vec<D>> positions;
    for (const auto& one : particles) positions.push_back(one.position);
    return positions;
  }

  /// Velocity gradient, acceleration and sum of V W of each particle: D D + D + 1 numbers.
  std::vector<double> sums() {
    const PairTile<D> tile = cloud.tile();
    std::vector<double> gradient(cloud.count * D * D), acceleration(cloud.count * D), loss(cloud.count);
    pair_loops<D>().velocity_gradient(tile, cloud.records, gradient.data());
    momentum.accumulate(tile, cloud.records, acceleration.data(), loss.data());
    std::vector<double> all;
    for (std::size_t i = 0; i < cloud.count; ++i) {
      all.insert(all.end(), gradient.begin() + static_cast<long>(i * D * D),
                 gradient.begin() + static_cast<long>((i + 1) * D * D));
      for (std::size_t a = 0; a < D; ++a) all.push_back(1e-9 * acceleration[i * D + a]);  // of the gradients' size
      double volume = 0.0;
      for (std::int64_t k = tile.first[i]; k < tile.first[i + 1]; ++k)
        volume += cloud.records.motion[static_cast<std::size_t>(tile.neighbour[k])][D] * tile.value[k];
      all.push_back(volume);
    }
    return all;
  }

  Images<D> images;
  Cloud<D> cloud;
  Momentum<D> momentum{cloud.fields, MomentumForm::sum};
};

/// Sums over the particles with images against those over all, written out: equal up to the order of the terms.
template <int D>
void expect_images_stand_for(const std::vector<Particle<D>>& part, const std::vector<Transform<D>>& copies,
                             const Images<D>& images) {
  std::vector<Particle<D>> whole = part;
  for (const auto& transform : copies)
    for (const auto& one : part) whole.push_back(moved(one, transform));
  ImagedCloud<D> imaged(part, images), full(whole, Images<D>());
  ASSERT_GT(imaged.images.count(), 0U);
  const auto found = imaged.sums(), wanted = full.sums();
  double largest = 0.0;
  for (const double number : wanted) largest = std::max(largest, std::abs(number));
  // Rounding of sums of some 60 terms of either sign, each up to the largest of the numbers.
  for (std::size_t k = 0; k < found.size(); ++k) ASSERT_NEAR(found[k], wanted[k], 1e-13 * largest) << k;
}

/// The jittered lattice begins at zero: half a spacing behind it all coordinates are positive.
template <int D>
std::vector<Particle<D>> jittered_particles() {
  Cloud<D> cloud;
  std::vector<Particle<D>> particles;
  for (std::size_t i = 0; i < cloud.count; ++i) {
    particles.push_back(particle_of(cloud, i));
    particles.back().position += Vec<D>::Constant(0.5 * spacing);
  }
  return particles;
}

template <int D>
Transform<D> mirror(const Vec<D>& normal) {
  const Mat<D> turn = Mat<D>::Identity() - 2.0 * normal * normal.transpose();
  return {turn, Vec<D>::Zero(), turn};
}

template <class T>
class ImagesInEachDimension : public InEachDimension<T> {};
TYPED_TEST_SUITE(ImagesInEachDimension, Dimensions);

/// An eighth, a quarter or a half of a cloud that is symmetric about the planes of coordinates.
TYPED_TEST(ImagesInEachDimension, APartStandsForTheWhole) {
  constexpr int D = TypeParam::value;
  std::vector<MirrorPlane<D>> planes;
  std::vector<Transform<D>> copies = {Transform<D>()};
  for (int a = 0; a < D; ++a) {
    planes.push_back({Vec<D>::Zero(), Vec<D>::Unit(a)});
    const auto before = copies;
    for (const auto& one : before) copies.push_back(mirror<D>(Vec<D>::Unit(a)) * one);
  }
  copies.erase(copies.begin());
  expect_images_stand_for<D>(jittered_particles<D>(), copies, Images<D>(planes, {}));
}

/// Beyond one reach from the middle copy nothing matters: 3^D of them stand for endless repetition.
TYPED_TEST(ImagesInEachDimension, APeriodStandsForEndlessRepetition) {
  constexpr int D = TypeParam::value;
  const double length = Cloud<D>::per_axis * spacing;
  std::vector<Period> periods;
  std::vector<Transform<D>> copies = {Transform<D>()};
  for (int a = 0; a < D; ++a) {
    periods.push_back({a, 0.0, length});
    const auto before = copies;
    for (const auto& one : before) {
      for (const double sign : {1.0, -1.0}) {
        Transform<D> shift = one;
        shift.shift[a] += sign * length;
        copies.push_back(shift);
      }
    }
  }
  copies.erase(copies.begin());
  expect_images_stand_for<D>(jittered_particles<D>(), copies, Images<D>({}, periods));
}

/// Planes that meet at 45 degrees give eight sectors, rotations and reflections.
TEST(Images, FillASectorOf45Degrees) {
  const Vec<2> diagonal = Vec<2>(1.0, -1.0).normalized();
  std::vector<Particle<2>> sector;
  for (const auto& one : jittered_particles<2>())
    if (one.position[0] - one.position[1] > 0.1 * spacing) sector.push_back(one);
  const Transform<2> first = mirror<2>(Vec<2>(0.0, 1.0)), second = mirror<2>(diagonal);
  // The seven copies besides the sector itself, by enumeration of distinct products.
  std::vector<Transform<2>> all = {Transform<2>()};
  for (std::size_t k = 0; k < all.size() && all.size() < 20; ++k) {
    for (const auto& generator : {first, second}) {
      const Transform<2> product = all[k] * generator;
      const bool known =
          std::any_of(all.begin(), all.end(), [&](const auto& one) { return (one.turn - product.turn).norm() < 1e-9; });
      if (!known) all.push_back(product);
    }
  }
  ASSERT_EQ(all.size(), 8U);
  all.erase(all.begin());
  expect_images_stand_for<2>(sector, all,
                             Images<2>({{Vec<2>::Zero(), Vec<2>(0.0, 1.0)}, {Vec<2>::Zero(), diagonal}}, {}));
}

/// A slab thinner than the reach between two planes has images of images of images.
TEST(Images, FillAThinSlab) {
  std::vector<Particle<2>> slab;
  for (const auto& one : jittered_particles<2>())
    if (one.position[1] < spacing) slab.push_back(one);
  const double width = 1.1 * spacing;
  std::vector<Transform<2>> copies;
  const Transform<2> bottom = mirror<2>(Vec<2>(0.0, 1.0));
  Transform<2> top = bottom;
  top.shift = Vec<2>(0.0, 2.0 * width);
  Transform<2> upward, downward;
  for (int k = 0; k < 6; ++k) {
    upward = (k % 2 == 0 ? upward * top : upward * bottom);
    downward = (k % 2 == 0 ? downward * bottom : downward * top);
    copies.push_back(upward);
    copies.push_back(downward);
  }
  expect_images_stand_for<2>(
      slab, copies, Images<2>({{Vec<2>::Zero(), Vec<2>(0.0, 1.0)}, {Vec<2>(0.0, width), Vec<2>(0.0, -1.0)}}, {}));
}

/// Half a particle on the plane and its image are the whole particle of the full cloud.
TEST(Images, OfAParticleOnThePlaneCarryItsOtherHalf) {
  std::vector<Particle<2>> half, whole;
  for (const auto& one : jittered_particles<2>()) {
    Particle<2> other = one;
    other.position[0] -= 0.5 * spacing;
    if (other.position[0] < 0.4 * spacing) {  // onto the plane, where what is odd vanishes
      other.position[0] = other.velocity[0] = other.deviator[2] = 0.0;
      whole.push_back(other);
      other.mass *= 0.5;
      half.push_back(other);
    } else {
      half.push_back(other);
      whole.push_back(other);
    }
  }
  const Transform<2> turn = mirror<2>(Vec<2>(1.0, 0.0));
  const std::size_t part = whole.size();
  for (std::size_t k = 0; k < part; ++k)
    if (whole[k].position[0] > 0.0) whole.push_back(moved(whole[k], turn));
  ImagedCloud<2> imaged(half, Images<2>({{Vec<2>::Zero(), Vec<2>(1.0, 0.0)}}, {})), full(whole, Images<2>());
  const auto found = imaged.sums(), wanted = full.sums();
  double largest = 0.0;
  for (const double number : wanted) largest = std::max(largest, std::abs(number));
  const std::size_t per_particle = 4 + 2 + 1;
  const double own_value = CubicSpline::normalisation(2) * CubicSpline::value(0.0);
  for (std::size_t k = 0; k < found.size(); ++k) {
    const std::size_t i = k / per_particle;
    double expected = wanted[k];
    if (k % per_particle == 6 && half[i].position[0] == 0.0)  // the sum of V W now holds its other half
      expected += half[i].mass / half[i].density * own_value / (half[i].smoothing_length * half[i].smoothing_length);
    ASSERT_NEAR(found[k], expected, 1e-13 * largest) << k;
  }
}

TEST(Images, WrapIntoThePeriodAndStayThere) {
  const Images<1> images({}, {{0, -1.0, 2.0}});
  EXPECT_EQ(images.wrapped(Vec<1>(2.5))[0], -0.5);
  EXPECT_EQ(images.wrapped(Vec<1>(-1.5))[0], 1.5);
  EXPECT_EQ(images.wrapped(Vec<1>(2.0))[0], -1.0);
  EXPECT_NEAR(images.wrapped(Vec<1>(302.5))[0], -0.5, 1e-12);  // rounding of 300
  for (const double x : {-1.0 - 1e-18, -1.0 - 1e-16, 2.0, 2.0 - 1e-16, 1e3, -1e3}) {
    const Vec<1> once = images.wrapped(Vec<1>(x));
    EXPECT_GE(once[0], -1.0);
    EXPECT_LT(once[0], 2.0);
    EXPECT_EQ(images.wrapped(once)[0], once[0]) << x;
  }
}

TEST(Transform, TurnsPackedAndFullTensorsAlike) {
  const Mat<3> turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -2.0).normalized()).toRotationMatrix();
  const double packed[6] = {1.0, 2.0, 3.0, 0.4, 0.5, 0.6};
  const double full[9] = {1.0, 0.4, 0.6, 0.4, 2.0, 0.5, 0.6, 0.5, 3.0};
  double turned_packed[6], turned_full[9];
  turn_symmetric<3>(turn, packed, turned_packed);
  turn_tensor<3>(turn, full, turned_full);
  const int place[6] = {0, 4, 8, 1, 5, 2};
  for (int c = 0; c < 6; ++c) EXPECT_NEAR(turned_packed[c], turned_full[place[c]], 1e-15);
  const double skew[9] = {0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};  // row x, column y
  Mat<3> quarter = Mat<3>::Zero();                                       // x -> y, y -> -x
  quarter(1, 0) = 1.0;
  quarter(0, 1) = -1.0;
  quarter(2, 2) = 1.0;
  turn_tensor<3>(quarter, skew, turned_full);
  EXPECT_EQ(turned_full[3], -1.0);  // row y, column x
  EXPECT_EQ(turned_full[1], 0.0);
}

}  // namespace
}  // namespace anvil
