/// Attitudes as quaternions.
#pragma once

#include <array>
#include <optional>

#include "physics/attitude.hpp"

namespace sbgc::emulator {

/// A rotation from body to world coordinates: W, X, Y, Z, of length 1, about the axes of Vector.
/// Assumption: no source says about which axes, and which way.
using Quaternion = std::array<double, 4>;

/// Returns the quaternion of a rotation with W >= 0; the other sign is the same rotation.
Quaternion quaternion_of(const Rotation& rotation);
/// Returns the rotation of a quaternion, which is scaled to length 1 first; nothing if it is too
/// short or not finite.
std::optional<Rotation> rotation_of(const Quaternion& quaternion);
/// Returns the rotation from the coordinates of `from` to those of `to`.
Quaternion relative(const Quaternion& from, const Quaternion& to);
/// Returns the angle between two attitudes, in degrees.
double angle_between(const Quaternion& a, const Quaternion& b);

/// Returns a vector of the body in world coordinates, and the reverse.
Vector to_world(const Rotation& rotation, const Vector& body);
Vector to_body(const Rotation& rotation, const Vector& world);

/// Returns the derivatives of the Euler angles for a rotation about body axes; nothing where they
/// are ambiguous.
std::optional<Axes<double>> euler_speeds(const Pose& pose, const Vector& body_rates);

}  // namespace sbgc::emulator
