#include "physics/quaternion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sbgc::emulator {

namespace {

constexpr double degrees_in_radian = 180 / 3.14159265358979323846;

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
  return 2 * std::acos(std::min(1.0, std::abs(cosine))) * degrees_in_radian;
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
