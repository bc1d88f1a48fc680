/// Control of the camera by quaternions.
#pragma once

#include <cstddef>
#include <optional>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/time.hpp>

#include "physics/attitude.hpp"

namespace sbgc::emulator {

/// CMD_CONTROL_QUAT. Assumption: speeds are rotation vectors in space, and the attitude of the
/// camera is that of its Euler angles.
class QuaternionControl {
 public:
  struct Target {
    msg::ControlQuatMode mode{};
    msg::ControlQuatFlags flags{};
    std::optional<Rotation> attitude{};
    Vector speed{};  ///< deg/s about the axes of the world
  };

  static bool are_supported(const BoardOptions& options);
  /// Follows a new target, or none if its mode is DISABLED.
  void command(Gimbal& gimbal, const Tuning& tuning, const Target& target, Instant now);
  /// Ends the control, because another command controls the axes.
  void end();
  void configure(const msg::ControlQuatConfig& config);
  msg::ControlQuatStatus status(Gimbal& gimbal, const Tuning& tuning,
                                msg::ControlQuatStatusFields fields, Instant now) const;
  /// True if the camera is within 1 degree of the target attitude.
  bool has_arrived(Gimbal& gimbal, const Tuning& tuning, Instant now) const;

  Instant next() const { return next_; }
  void advance(Instant now, Gimbal& gimbal, const Tuning& tuning);

 private:
  void turn(Gimbal& gimbal, const Tuning& tuning, Instant now) const;
  double limited(double speed, std::size_t direction) const;

  Target target_{};
  Xyz<double> max_speed_{};  ///< deg/s; 0: no limit
  Instant next_ = Instant::never;
};

/// Conversions of packed quaternions. Four components of 0 do not occur.
msg::PackedQuaternion packed(const Quaternion& quaternion);
Quaternion unpacked(msg::PackedQuaternion packed);

}  // namespace sbgc::emulator
