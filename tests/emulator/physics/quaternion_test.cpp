// Tests of quaternions against rotation matrices and against rotations that are easily imagined.

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "physics/attitude.hpp"

namespace sbgc::emulator {
namespace {

constexpr double right_angle = 3.14159265358979323846 / 2;

Pose random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-180, 180);
  return {{angle(random), angle(random), angle(random)}, {1, 0, 2}};
}

TEST(Quaternion, IsTheHalfAngle) {
  const auto q = quaternion_of(Pose({0, 0, 90}, {1, 0, 2}).rotation());
  EXPECT_NEAR(q[0], std::cos(right_angle / 2), 1e-12);
  EXPECT_NEAR(q[3], -std::sin(right_angle / 2), 1e-12) << "yaw turns to the right, against Z";
  const auto pitch = quaternion_of(Pose({0, -10, 0}, {1, 0, 2}).rotation());
  EXPECT_NEAR(pitch[0], 0.9962, 1e-4);
  EXPECT_NEAR(pitch[1], 0.0872, 1e-4) << "a camera that turns up turns about X";
}

TEST(Quaternion, IsTheSameRotation) {
  std::mt19937 random(1);
  for (int i = 0; i < 1000; ++i) {
    const Rotation rotation = random_pose(random).rotation();
    const Quaternion q = quaternion_of(rotation);
    EXPECT_GE(q[0], 0);
    const auto again = rotation_of(q);
    ASSERT_TRUE(again);
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) {
        EXPECT_NEAR(again->rows[row][column], rotation.rows[row][column], 1e-12);
      }
    }
    EXPECT_NEAR(angle_between(q, q), 0, 1e-5);
    // The rotation between an attitude and itself turns nothing.
    EXPECT_NEAR(std::abs(relative(q, q)[0]), 1, 1e-12);
  }
}

TEST(Quaternion, NeedsALength) {
  EXPECT_FALSE(rotation_of(Quaternion{}));
  EXPECT_FALSE(rotation_of(Quaternion{NAN, 0, 0, 0}));
  EXPECT_FALSE(rotation_of(Quaternion{INFINITY, 0, 0, 0}));
  EXPECT_TRUE(rotation_of(Quaternion{0, 0, 0, -5}));
}

TEST(Quaternion, AnglesBetweenAttitudes) {
  const auto level = quaternion_of(Rotation{});
  const auto turned = quaternion_of(Pose({0, 0, 120}, {1, 0, 2}).rotation());
  EXPECT_NEAR(angle_between(level, turned), 120, 1e-9);
  const Quaternion other_sign{-turned[0], -turned[1], -turned[2], -turned[3]};
  EXPECT_NEAR(angle_between(level, other_sign), 120, 1e-9);
}

TEST(EulerSpeeds, AreTheInverseOfRates) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> speed(-100, 100);
  int known = 0;
  for (int i = 0; i < 1000; ++i) {
    const Pose pose = random_pose(random);
    const Axes<double> speeds{speed(random), speed(random), speed(random)};
    const auto found = euler_speeds(pose, pose.rates(speeds));
    if (!found) continue;
    ++known;
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR((*found)[axis], speeds[axis], 1e-9);
  }
  EXPECT_GT(known, 900) << "all but those near the singularity";
}

TEST(Vectors, ToTheWorldAndBack) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const Rotation rotation = random_pose(random).rotation();
    const Vector v{1, 2, 3};
    const Vector again = to_body(rotation, to_world(rotation, v));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(again[k], v[k], 1e-12);
    EXPECT_NEAR(to_world(rotation, rotation.up()).z, 1, 1e-12);
  }
}

}  // namespace
}  // namespace sbgc::emulator
