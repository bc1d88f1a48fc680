/// Attitudes: Euler angles, rotation matrices and vectors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>

namespace sbgc::emulator {

/// Axes from the camera outwards: 0 roll, 1 pitch, 2 yaw.
using RotationOrder = std::array<std::uint8_t, 3>;

/// The order if it contains each axis once, else that of most gimbals: pitch, roll, yaw.
RotationOrder valid_order(const RotationOrder& order);

/// Rows are the world's axes (right, north, up) in coordinates of the body: the matrix turns what a
/// body sees into coordinates of the world. Always orthonormal.
struct Rotation {
  std::array<Vector, 3> rows{Vector{1, 0, 0}, Vector{0, 1, 0}, Vector{0, 0, 1}};

  const Vector& up() const { return rows[2]; }
  const Vector& north() const { return rows[1]; }
};

/// An attitude, and how speeds of the angles turn the body.
///
/// Roll turns about y, pitch about x, yaw about z, counter-clockwise looking against the axis; the
/// first axis of the order is the body's own, the last one the world's. Assumption: the
/// specification does not publish directions.
class Pose {
 public:
  /// Angles in degrees.
  Pose(const Axes<double>& angles, const RotationOrder& order);

  const Rotation& rotation() const { return rotation_; }
  /// Rates about x, y, z of the body that belong to speeds of the angles.
  Vector rates(const Axes<double>& speeds) const;

 private:
  Rotation rotation_;
  std::array<std::uint8_t, 3> axis_{};  ///< by order
  std::array<Vector, 3> directions_{};  ///< of each axis in coordinates of the body, by order
};

/// The attitude given by two vectors: `up` is exact, `north` is made perpendicular to it. Empty if
/// they are not finite, too short or parallel.
std::optional<Rotation> rotation_of(const Vector& up, const Vector& north);

/// The Euler angles of an attitude, those of the two sets (and of all turns) that are nearest to
/// `near`.
Axes<double> angles_of(const Rotation& rotation, const RotationOrder& order,
                       const Axes<double>& near);

/// `v`, turned by the shortest turn from one unit vector to another. Precondition: they are not
/// opposite.
Vector turned(const Vector& v, const Vector& from, const Vector& to);

/// `v` with length 1. Empty if it is not finite or shorter than 0.001.
std::optional<Vector> unit(const Vector& v);

/// -180..180.
double wrapped(double degrees);

double dot(const Vector& a, const Vector& b);
Vector cross(const Vector& a, const Vector& b);

}  // namespace sbgc::emulator
