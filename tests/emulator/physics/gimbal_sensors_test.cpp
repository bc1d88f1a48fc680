// Tests of the sensors' measurements, of the IMU's estimate, and of attitudes and quaternions.

#include <numbers>
#include <random>

#include "gimbal_rig.hpp"
#include "physics/attitude.hpp"

namespace sbgc::emulator::test {
namespace {

constexpr double radian = std::numbers::pi / 180;

void expect_near(const Vector& actual, const Vector& expected, double error) {
  EXPECT_NEAR(actual.x, expected.x, error);
  EXPECT_NEAR(actual.y, expected.y, error);
  EXPECT_NEAR(actual.z, expected.z, error);
}

Sample placed(const Axes<double>& angles) {
  Gimbal gimbal(quiet(), ms(0));
  gimbal.place(angles, ms(0));
  return gimbal.sample(ms(0));
}

TEST(Sensors, GravityTellsTheAttitude) {
  expect_near(placed({}).acceleration, {0, 0, 1}, 1e-12);
  expect_near(placed({0, 90, 0}).acceleration, {0, -1, 0}, 1e-12);  // front down
  expect_near(placed({90, 0, 0}).acceleration, {-1, 0, 0}, 1e-12);  // right side down
  expect_near(placed({180, 0, 77}).acceleration, {0, 0, -1}, 1e-12);
  const double half = std::sin(30 * radian);
  expect_near(placed({0, -30, 123}).acceleration, {0, half, std::cos(30 * radian)}, 1e-12);
}

TEST(Sensors, NorthAndTheFieldTellTheHeading) {
  expect_near(placed({}).north, {0, 1, 0}, 1e-12);
  expect_near(placed({0, 0, 90}).north, {-1, 0, 0}, 1e-12);  // heads east: north is on the left
  expect_near(placed({0, 0, 720}).north, {0, 1, 0}, 1e-9);
  const Sample sample = placed({20, -40, 60});
  const double horizontal = dot(sample.magnetic, sample.north);
  EXPECT_GT(horizontal, 0.1);
  EXPECT_LT(dot(sample.magnetic, sample.up), 0);
  EXPECT_NEAR(dot(sample.magnetic, sample.magnetic), 1, 1e-9);
  EXPECT_NEAR(dot(sample.magnetic, cross(sample.up, sample.north)), 0, 1e-9);
}

constexpr std::array<std::array<std::uint8_t, 3>, 6> orders{
    {{1, 0, 2}, {0, 1, 2}, {2, 0, 1}, {2, 1, 0}, {0, 2, 1}, {1, 2, 0}}};

TEST(Attitudes, AreOrthonormalAndComeBackAsAngles) {
  for (const auto& order : orders) {
    for (double a = -350; a < 360; a += 63) {
      for (double b = -80; b < 90; b += 31) {
        for (double c = -700; c < 720; c += 171) {
          Axes<double> angles;
          angles[order[0]] = a;
          angles[order[1]] = b;
          angles[order[2]] = c;
          const Pose pose(angles, order);
          const Rotation& r = pose.rotation();
          for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t j = 0; j < 3; ++j) {
              ASSERT_NEAR(dot(r.rows[i], r.rows[j]), i == j ? 1 : 0, 1e-12);
            }
          }
          expect_near(cross(r.rows[0], r.rows[1]), r.rows[2], 1e-12);
          Axes<double> near = angles;
          near[order[0]] += 7;
          near[order[2]] -= 9;
          const Axes<double> back = angles_of(r, order, near);
          for (std::size_t i = 0; i < 3; ++i) ASSERT_NEAR(back[i], angles[i], 1e-6);
        }
      }
    }
  }
}

TEST(Attitudes, VectorsMakeThemOnlyIfTheyPointSomewhere) {
  EXPECT_TRUE(rotation_of({0, 0, 5}, {0, 3, 4}));
  EXPECT_TRUE(rotation_of({1e200, 0, 0}, {0, 1e300, 1e300}));
  EXPECT_FALSE(rotation_of({0, 0, 0}, {0, 1, 0}));
  EXPECT_FALSE(rotation_of({0, 0, 1}, {0, 0, -2}));
  EXPECT_FALSE(rotation_of({0, 0, 1}, {std::nan(""), 1, 0}));
}

Pose random_pose(std::mt19937& random) {
  std::uniform_real_distribution<double> angle(-180, 180);
  return {{angle(random), angle(random), angle(random)}, {1, 0, 2}};
}

TEST(Quaternion, IsTheHalfAngle) {
  const auto q = quaternion_of(Pose({0, 0, 90}, {1, 0, 2}).rotation());
  EXPECT_NEAR(q[0], std::cos(45 * radian), 1e-12);
  EXPECT_NEAR(q[3], -std::sin(45 * radian), 1e-12) << "yaw turns to the right, against Z";
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

/// Integrates the gyroscope's rates from one time to another, in small rotations.
Rotation integrated(Gimbal& gimbal, Rotation rotation, std::int64_t from, std::int64_t until) {
  for (std::int64_t t = from; t < until; ++t) {
    const Vector rates = gimbal.sample({t * 1000 + 500}).gyro;
    const double length = std::sqrt(dot(rates, rates));
    if (length == 0) continue;
    const double turn = length * 0.001 * radian;
    const Vector axis{rates.x / length, rates.y / length, rates.z / length};
    for (Vector& row : rotation.rows) {
      // A vector of the world in the coordinates of a rotating body: the inverse of Rodrigues'
      // formula.
      const Vector side = cross(row, axis);
      const double along = dot(row, axis) * (1 - std::cos(turn));
      for (std::size_t i = 0; i < 3; ++i) {
        row[i] = row[i] * std::cos(turn) + side[i] * std::sin(turn) + axis[i] * along;
      }
    }
  }
  return rotation;
}

TEST(Sensors, GyroscopeIntegratesToTheAttitude) {
  for (const auto& order : orders) {
    Tuning tuning;
    tuning.rotation_order = order;
    Gimbal gimbal = ready(moving(Disturbance::Kind::handheld), tuning);
    gimbal.command(roll, {AxisMode::angle, 30, 25, 0}, ms(0));
    gimbal.command(pitch, {AxisMode::angle, 40, -50, 0}, ms(0));
    gimbal.command(yaw, {AxisMode::speed, 60, 0, 0}, ms(0));
    const Sample first = gimbal.sample(ms(0));
    const Rotation start{{cross(first.north, first.up), first.north, first.up}};
    const Rotation end = integrated(gimbal, start, 0, 4000);
    const Sample last = gimbal.sample(ms(4000));
    expect_near(end.up(), last.up, 1e-3);
    expect_near(end.north(), last.north, 1e-3);
  }
}

TEST(Sensors, SpeedsAreDerivativesOfAngles) {
  Gimbal gimbal = ready(moving(Disturbance::Kind::drone));
  gimbal.command(pitch, {AxisMode::angle, 30, 25, 0}, ms(0));
  Sample before = gimbal.sample(ms(1001));
  for (std::int64_t t = 1002; t < 3000; ++t) {
    const Sample sample = gimbal.sample(ms(t));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_NEAR(sample.angles[axis] - before.angles[axis],
                  0.0005 * (sample.speeds[axis] + before.speeds[axis]), 1e-4);
    }
    before = sample;
  }
}

TEST(Sensors, FrameGyroscopeMeasuresTheFrame) {
  Gimbal::Options options = moving(Disturbance::Kind::handheld);
  Gimbal gimbal(options, ms(0));
  Sample before = gimbal.sample(ms(0));
  double roll_angle = before.frame.roll;
  for (std::int64_t t = 0; t < 2000; ++t) {
    roll_angle += 0.001 * gimbal.sample({t * 1000 + 500}).frame_gyro.y;
  }
  EXPECT_NEAR(roll_angle, gimbal.sample(ms(2000)).frame.roll, 0.2);
  const Sample sample = gimbal.sample(ms(2000));
  EXPECT_EQ(sample.frame_gyro, sample.frame_speed);
  EXPECT_EQ(sample.frame_acceleration, sample.frame_up);
}

struct Spread {
  double mean{}, deviation{};
};

template <class Value>
Spread spread(Gimbal& gimbal, const Value& value) {
  double sum = 0;
  double squares = 0;
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double x = value(gimbal.sample(ms(10 * i)));
    sum += x;
    squares += x * x;
  }
  return {sum / n, std::sqrt(squares / n - sum / n * sum / n)};
}

TEST(Sensors, NoiseIsAsStrongAsAskedFor) {
  const auto gyro = [](const Sample& sample) { return sample.gyro.x; };
  const auto acceleration = [](const Sample& sample) { return sample.acceleration.x; };
  Gimbal::Options options;
  options.imbalance = {};
  Gimbal usual = ready(options);
  const Spread usual_gyro = spread(usual, gyro);
  EXPECT_NEAR(usual_gyro.deviation, 0.05, 0.005);
  EXPECT_NEAR(usual_gyro.mean, 0, 0.02);
  Gimbal again = ready(options);
  EXPECT_NEAR(spread(again, acceleration).deviation, 0.002, 0.0002);
  options.noise = 3;
  Gimbal loud = ready(options);
  EXPECT_NEAR(spread(loud, gyro).deviation, 0.15, 0.015);
  options.noise = 0;
  Gimbal silent = ready(options);
  EXPECT_EQ(spread(silent, gyro).deviation, 0);
}

TEST(Sensors, TheyWarmUp) {
  Gimbal gimbal(quiet(), ms(0));
  EXPECT_EQ(gimbal.sample(ms(0)).temperature, 22);
  const double soon = gimbal.sample(ms(60'000)).temperature;
  const double late = gimbal.sample(ms(3'000'000)).temperature;
  EXPECT_GT(soon, 22.5);
  EXPECT_GT(late, soon + 5);
  EXPECT_LT(late, 45);
}

/// Returns the true heading of the camera, computed from the joint and the frame.
double heading_of(const Sample& sample) { return sample.joints.yaw; }

TEST(Drift, TurnsTheCameraUnnoticedUntilTheGyroscopeIsCalibrated) {
  Gimbal gimbal = ready({.noise = 20});
  const Sample start = gimbal.sample(ms(5000));
  const Sample drifted = gimbal.sample(ms(600'000));
  EXPECT_NEAR(drifted.angles.yaw, 0, 0.1);
  EXPECT_GT(std::abs(heading_of(drifted) - heading_of(start)), 1);

  gimbal.gyro_calibrated(false, ms(2'400'000));
  const Sample calibrated = gimbal.sample(ms(2'400'000));
  const Sample later = gimbal.sample(ms(3'000'000));
  EXPECT_NEAR(heading_of(later), heading_of(calibrated), 0.2);
}

TEST(Drift, CorrectionsByHandChangeIt) {
  Gimbal gimbal = ready();
  gimbal.correct_gyro(false, {}, 0.5, ms(0));
  EXPECT_NEAR(heading_of(gimbal.sample(ms(20'000))), -10, 0.5) << "to the left, as about z";
  gimbal.correct_gyro(false, {0, 0, -0.5}, 0.5, ms(20'000));  // one against the other
  EXPECT_NEAR(heading_of(gimbal.sample(ms(60'000))), -10, 0.5);
}

TEST(Drift, OfRollAndPitchIsHeldByGravityTheMoreTheLessTheGyroscopeIsTrusted) {
  const auto tilt = [](double trust) {
    Tuning tuning;
    tuning.gyro_trust = trust;
    Gimbal gimbal = ready(quiet(), tuning);
    gimbal.correct_gyro(false, {0.1, 0, 0}, 0, ms(0));
    const Sample sample = gimbal.sample(ms(300'000));
    EXPECT_NEAR(sample.gravity_error, std::abs(sample.joints.pitch), 0.05);
    return sample.gravity_error;
  };
  EXPECT_NEAR(tilt(100), 1.1, 0.1);
  EXPECT_LT(tilt(20), 0.4);
}

TEST(Reference, ReplacesTheEstimate) {
  Gimbal gimbal = ready();
  const Sample before = gimbal.sample(ms(1000));
  const double c = std::cos(20 * radian);
  const double s = std::sin(20 * radian);
  // North is 20 degrees further to the right than the IMU estimated: the camera heads to the left.
  gimbal.correct({Vector{0, 0, 1}, Vector{s, c, 0}, false, false}, ms(1000));
  const Sample told = gimbal.sample(ms(1000));
  EXPECT_NEAR(told.angles.yaw, -20, 1e-9);
  expect_near(told.north, {s, c, 0}, 1e-9);
  EXPECT_EQ(told.joints.yaw, before.joints.yaw);
  // Therefore the camera turns back.
  const Sample later = gimbal.sample(ms(6000));
  EXPECT_NEAR(later.angles.yaw, 0, 0.05);
  EXPECT_NEAR(later.joints.yaw, 20, 0.05);
}

TEST(Reference, OfOneVectorLeavesTheOther) {
  Gimbal gimbal(quiet(), ms(0));
  gimbal.place({0, 0, 40}, ms(0));
  gimbal.correct({Vector{0, std::sin(10 * radian), std::cos(10 * radian)}, {}, false, false},
                 ms(0));
  const Sample sample = gimbal.sample(ms(0));
  EXPECT_NEAR(sample.angles.pitch, -10, 1e-9) << "front up";
  EXPECT_NEAR(sample.angles.yaw, 40, 1e-9);
  // Gravity is the reference if no other one is given.
  EXPECT_NEAR(gimbal.sample(ms(90'000)).angles.pitch, 0, 0.01);
}

TEST(Reference, CorrectsSlowly) {
  Gimbal gimbal = ready();
  for (std::int64_t t = 0; t < 60'000; t += 100) {
    // Simulates an external sensor on the camera, which observes the camera's rotation.
    const double really = gimbal.sample(ms(t)).joints.yaw + 10;
    const Vector seen{-std::sin(really * radian), std::cos(really * radian), 0};
    gimbal.correct({{}, seen, false, true}, ms(t));
    if (t == 0) {
      EXPECT_NEAR(gimbal.sample(ms(0)).angles.yaw, 0, 1e-9);
      EXPECT_NEAR(gimbal.sample(ms(0)).heading_error, 10, 1e-6);
    }
    if (t == 3000) {
      EXPECT_GT(gimbal.sample(ms(t)).heading_error, 5);
    }
  }
  const Sample sample = gimbal.sample(ms(60'000));
  EXPECT_LT(sample.heading_error, 0.5);
  EXPECT_NEAR(sample.joints.yaw, -10, 0.5);
}

TEST(Reference, OfTheFrameLeavesTheCamera) {
  Gimbal::Options options = quiet();
  options.imbalance = {};
  Gimbal gimbal = ready(options);
  const Vector north{std::sin(15 * radian), std::cos(15 * radian), 0};
  gimbal.correct({Vector{0, 0, 1}, north, true, false}, ms(500));
  const Sample sample = gimbal.sample(ms(500));
  EXPECT_NEAR(sample.frame.yaw, -15, 1e-9);
  expect_near(sample.frame_north, north, 1e-9);
  EXPECT_NEAR(sample.angles.yaw, 0, 1e-9);
}

}  // namespace
}  // namespace sbgc::emulator::test
