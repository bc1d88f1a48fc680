/// Attitudes: Euler angles, rotation matrices, vectors and quaternions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>

namespace sbgc::emulator {

/// The axes from the camera outward: 0 roll, 1 pitch, 2 yaw.
using RotationOrder = std::array<std::uint8_t, 3>;

/// Returns the order if it contains each axis once, else the most common one: pitch, roll, yaw.
RotationOrder valid_order(const RotationOrder& order);

/// The direction of a Vector about which an angle turns, and the sign of the turn.
struct TurningAxis {
  std::size_t direction{};
  double sign{};
};

/// The axes of roll, pitch and yaw: forward, left, down. All signs of angles follow from them.
inline constexpr std::array<TurningAxis, 3> turning_axes{{{1, 1}, {0, -1}, {2, -1}}};

/// Returns the rates of a rotation about the axes of roll, pitch and yaw.
Axes<double> turning(const Vector& rates);

/// A rotation from body to world coordinates. The rows are the axes of the world (right, north, up)
/// in body coordinates. Always orthonormal.
struct Rotation {
  std::array<Vector, 3> rows{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

  const Vector& up() const { return rows[2]; }
  const Vector& north() const { return rows[1]; }
};

/// An attitude, and the relation of angle derivatives to body rates.
///
/// The first axis of the order is fixed to the body, the last one to the world.
class Pose {
 public:
  /// Angles in degrees.
  Pose(const Axes<double>& angles, const RotationOrder& order);

  const Rotation& rotation() const { return rotation_; }
  /// Returns the rates about x, y, z of the body for the given angle derivatives.
  Vector rates(const Axes<double>& speeds) const;

 private:
  Rotation rotation_;
  std::array<std::uint8_t, 3> axis_{};  ///< by order
  std::array<Vector, 3> directions_{};  ///< of each axis in body coordinates, by order
};

/// Returns the attitude given by two vectors: `up` is exact, `north` is made perpendicular to it.
/// Returns nothing if they are not finite, too short or parallel.
std::optional<Rotation> rotation_of(const Vector& up, const Vector& north);

/// Returns the Euler angles of an attitude: of the two solutions, and of all full turns, the one
/// nearest to `near`.
Axes<double> angles_of(const Rotation& rotation, const RotationOrder& order,
                       const Axes<double>& near);

/// Rotates `v` by the shortest rotation from one unit vector to another. Precondition: they are not
/// opposite.
Vector turned(const Vector& v, const Vector& from, const Vector& to);

/// Returns `v` scaled to length 1; nothing if it is not finite or shorter than 0.001.
std::optional<Vector> unit(const Vector& v);

/// Returns the equivalent angle in -180..180.
double wrapped(double degrees);

double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

/// A rotation from body to world coordinates: W, X, Y, Z, of length 1, about the axes of Vector.
/// Assumption: no source states the axes and the direction.
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

/// Convert a vector from body to world coordinates, and vice versa.
Vector to_world(const Rotation& rotation, const Vector& body);
Vector to_body(const Rotation& rotation, const Vector& world);

/// Returns the derivatives of the Euler angles for a rotation about body axes; nothing where they
/// are ambiguous.
std::optional<Axes<double>> euler_speeds(const Pose& pose, const Vector& body_rates);

}  // namespace sbgc::emulator
