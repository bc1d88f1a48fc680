#include "physics/attitude.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sbgc::emulator {

namespace {

constexpr double radian = std::numbers::pi / 180;

struct PlaneTurn {
  double sine, cosine;
};

PlaneTurn turn_of(double degrees) {
  const double angle = wrapped(degrees) * radian;
  return {std::sin(angle), std::cos(angle)};
}

using Three = std::array<double, 3>;

/// Applies the inverse rotation about `axis`: converts v to coordinates of the turned body.
void see(Three& v, std::size_t axis, const PlaneTurn& turn) {
  const std::size_t j = axis == 2 ? 0 : axis + 1;
  const std::size_t k = axis == 0 ? 2 : axis - 1;
  const double vj = v[j];
  v[j] = turn.cosine * vj + turn.sine * v[k];
  v[k] = turn.cosine * v[k] - turn.sine * vj;
}

Vector vector_of(const Three& v) { return {v[0], v[1], v[2]}; }

}  // namespace

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Vector cross(const Vector& a, const Vector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

std::optional<Vector> unit(const Vector& v) {
  // Scale first, because squares of large numbers are not finite.
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z)) return {};
  if (largest < 1e-3) return {};
  const Vector scaled{v.x / largest, v.y / largest, v.z / largest};
  const double length = std::sqrt(dot(scaled, scaled));
  return Vector{scaled.x / length, scaled.y / length, scaled.z / length};
}

Vector turned(const Vector& v, const Vector& from, const Vector& to) {
  const Vector axis = cross(from, to);
  const Vector once = cross(axis, v);
  const Vector twice = cross(axis, once);
  const double share = 1 / (1 + dot(from, to));
  return {v.x + once.x + twice.x * share, v.y + once.y + twice.y * share,
          v.z + once.z + twice.z * share};
}

double wrapped(double degrees) {
  return std::abs(degrees) <= 180 ? degrees : std::remainder(degrees, 360);
}

RotationOrder valid_order(const RotationOrder& order) {
  std::array<bool, 3> seen_axes{};
  for (const std::uint8_t axis : order) {
    if (axis > 2 || seen_axes[axis]) return {1, 0, 2};
    seen_axes[axis] = true;
  }
  return order;
}

Axes<double> turning(const Vector& rates) {
  Axes<double> turning;
  for (std::size_t i = 0; i < turning_axes.size(); ++i) {
    turning[i] = turning_axes[i].sign * rates[turning_axes[i].direction];
  }
  return turning;
}

Pose::Pose(const Axes<double>& angles, const RotationOrder& order) : axis_(order) {
  std::array<PlaneTurn, 3> turns{};
  const std::array<TurningAxis, 3> about{turning_axes[order[0]], turning_axes[order[1]],
                                         turning_axes[order[2]]};
  for (std::size_t i = 0; i < 3; ++i) turns[i] = turn_of(about[i].sign * angles[order[i]]);
  // World to body: undo the outermost rotation first.
  for (std::size_t row = 0; row < 3; ++row) {
    Three v{};
    v[row] = 1;
    for (std::size_t i = 3; i-- > 0;) see(v, about[i].direction, turns[i]);
    rotation_.rows[row] = vector_of(v);
  }
  for (std::size_t i = 0; i < 3; ++i) {
    Three v{};
    v[about[i].direction] = about[i].sign;
    for (std::size_t inner = i; inner-- > 0;) see(v, about[inner].direction, turns[inner]);
    directions_[i] = vector_of(v);
  }
}

Vector Pose::rates(const Axes<double>& speeds) const {
  Vector sum{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double speed = speeds[axis_[i]];
    sum.x += directions_[i].x * speed;
    sum.y += directions_[i].y * speed;
    sum.z += directions_[i].z * speed;
  }
  return sum;
}

std::optional<Rotation> rotation_of(const Vector& up, const Vector& north) {
  const std::optional<Vector> z = unit(up);
  const std::optional<Vector> about = unit(north);
  if (!z || !about) return {};
  const std::optional<Vector> x = unit(cross(*about, *z));
  if (!x) return {};
  return Rotation{{*x, cross(*z, *x), *z}};
}

Axes<double> angles_of(const Rotation& rotation, const RotationOrder& order,
                       const Axes<double>& near) {
  const std::size_t i = turning_axes[order[2]].direction;
  const std::size_t j = turning_axes[order[1]].direction;
  const std::size_t k = turning_axes[order[0]].direction;
  const double sign = (i + 1) % 3 == j ? 1 : -1;
  const auto& r = rotation.rows;
  const double middle = std::asin(std::clamp(sign * r[i][k], -1.0, 1.0)) / radian;
  const double outer = std::atan2(-sign * r[j][k], r[k][k]) / radian;
  const double inner = std::atan2(-sign * r[i][j], r[i][i]) / radian;

  const auto nearest = [&](double a, double b, double c) {
    Axes<double> angles;
    angles[order[0]] = a;
    angles[order[1]] = b;
    angles[order[2]] = c;
    double distance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = wrapped(turning_axes[axis].sign * angles[axis] - near[axis]);
      distance += std::abs(off);
      angles[axis] = near[axis] + off;
    }
    return std::pair{distance, angles};
  };
  const auto one = nearest(inner, middle, outer);
  const auto other = nearest(inner + 180, 180 - middle, outer + 180);
  return other.first < one.first ? other.second : one.second;
}

}  // namespace sbgc::emulator
