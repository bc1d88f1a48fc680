
#include "physics/attitude.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
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

namespace {

Quaternion product(const Quaternion& a, const Quaternion& b) {
  return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
          a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
          a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
          a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

}  // namespace

Quaternion quaternion_of(const Rotation& rotation) {
  const auto& m = rotation.rows;
  const double trace = m[0].x + m[1].y + m[2].z;
  // The largest component is computed first, so that no division is by a small number.
  const std::array<double, 4> squares{1 + trace, 1 + 2 * m[0].x - trace, 1 + 2 * m[1].y - trace,
                                      1 + 2 * m[2].z - trace};
  const auto largest =
      static_cast<std::size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
  const double root = 2 * std::sqrt(squares[largest]);
  const double x = (m[2].y - m[1].z) / root;
  const double y = (m[0].z - m[2].x) / root;
  const double z = (m[1].x - m[0].y) / root;
  const double xy = (m[0].y + m[1].x) / root;
  const double xz = (m[0].z + m[2].x) / root;
  const double yz = (m[1].z + m[2].y) / root;
  Quaternion q{};
  switch (largest) {
    case 0: q = {root / 4, x, y, z}; break;
    case 1: q = {x, root / 4, xy, xz}; break;
    case 2: q = {y, xy, root / 4, yz}; break;
    default: q = {z, xz, yz, root / 4}; break;
  }
  if (q[0] < 0) {
    for (double& component : q) component = -component;
  }
  return q;
}

std::optional<Rotation> rotation_of(const Quaternion& quaternion) {
  double length = 0;
  for (const double component : quaternion) length += component * component;
  length = std::sqrt(length);
  if (!(length > 1e-3) || !std::isfinite(length)) return {};
  const double w = quaternion[0] / length;
  const double x = quaternion[1] / length;
  const double y = quaternion[2] / length;
  const double z = quaternion[3] / length;
  return Rotation{{Vector{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                   Vector{2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                   Vector{2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Quaternion relative(const Quaternion& from, const Quaternion& to) {
  return product({to[0], -to[1], -to[2], -to[3]}, from);
}

double angle_between(const Quaternion& a, const Quaternion& b) {
  double cosine = 0;
  for (std::size_t i = 0; i < a.size(); ++i) cosine += a[i] * b[i];
  return 2 * std::acos(std::min(1.0, std::abs(cosine))) / radian;
}

Vector to_world(const Rotation& rotation, const Vector& body) {
  return {dot(rotation.rows[0], body), dot(rotation.rows[1], body), dot(rotation.rows[2], body)};
}

Vector to_body(const Rotation& rotation, const Vector& world) {
  Vector body{};
  for (std::size_t i = 0; i < 3; ++i) {
    body.x += rotation.rows[i].x * world[i];
    body.y += rotation.rows[i].y * world[i];
    body.z += rotation.rows[i].z * world[i];
  }
  return body;
}

std::optional<Axes<double>> euler_speeds(const Pose& pose, const Vector& body_rates) {
  const Vector roll = pose.rates({1, 0, 0});
  const Vector pitch = pose.rates({0, 1, 0});
  const Vector yaw = pose.rates({0, 0, 1});
  // Cramer's rule.
  const double whole = dot(roll, cross(pitch, yaw));
  if (std::abs(whole) < 0.05) return {};
  return Axes<double>{dot(body_rates, cross(pitch, yaw)) / whole,
                      dot(roll, cross(body_rates, yaw)) / whole,
                      dot(roll, cross(pitch, body_rates)) / whole};
}

}  // namespace sbgc::emulator
