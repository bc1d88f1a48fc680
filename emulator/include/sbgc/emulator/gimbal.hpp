/// The mechanics of an emulated gimbal: camera, joints, frame, sensors and battery.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>

#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// A vector of space: x points right, y forward, z up (normal position). Roll turns about y, pitch
/// about x, yaw about z, counter-clockwise looking against the axis. Assumption: the specification
/// does not publish directions.
using Vector = Xyz<double>;

/// A command for one axis. Angles in degrees, speeds in degrees per second.
///
/// Angles of `angle`, `speed_angle` and RC signals are equal modulo 4 turns, where the protocol's
/// 16 bits wrap: the one nearest to the present target counts. An axis that follows the frame (or
/// the angle of set_followed()) does so in `remote`, `signal` and `speed`, and counts the angles of
/// RC signals from its neutral position, that is what it follows plus `follow_offset`.
enum class AxisMode : std::uint8_t {
  remote,          ///< no control: the RC signal of the axis
  speed,           ///< turn with `speed`
  angle,           ///< go to `angle` with `speed`, 0: the speed of the settings
  speed_angle,     ///< turn with `speed` and be pulled to `angle`; half a second after the command
                   ///< (an assumption) the angle alone counts
  signal,          ///< `signal` stands for the RC signal
  relative_angle,  ///< go to `angle`, counted from the frame, over all turns; speed as for `angle`
};

struct AxisCommand {
  AxisMode mode{};
  double speed{};
  double angle{};
  double signal{};  ///< -1..1
};

/// How the parameters tune one axis.
struct AxisTuning {
  double p = 10, i = 0.1, d = 10;            ///< as in the settings, times the gain factor
  double power = 100;                        ///< 0..255; 0: the motor holds nothing
  double acceleration = 0;                   ///< limit in deg/s^2; 0: none but the motor's own
  double speed = 50;                         ///< of a move without a speed of its own, deg/s; 0:
                                             ///< such a move does not begin
  double follow_speed = 50;                  ///< deg/s at most
  double follow_deadband = 0;                ///< degrees
  double follow_offset = 0;                  ///< of the neutral position, degrees
  bool follows = false;                      ///< the target turns with the frame
  bool remote_is_speed = false;              ///< the RC signal is a speed, not an angle
  double remote_min = -90, remote_max = 90;  ///< angles of the lowest and the highest signal
  double remote_speed = 50;                  ///< speed of the full signal, deg/s
  double joint_min = 0, joint_max = 0;       ///< limits, degrees; none if `joint_min` is not
                                             ///< the smaller one
  double start_angle = 0;                    ///< where the axis points when the board starts
};

struct Tuning {
  Axes<AxisTuning> axes{};
  std::array<std::uint8_t, 3> rotation_order{1, 0,
                                             2};  ///< axes by Euler order: 0 roll, 1 pitch, 2 yaw
  double gyro_trust = 100;                        ///< 0..255
  double battery_stop = -1;  ///< volts below which the motors stop; negative: never
};

/// Everything that can be measured at one moment. Angles in degrees, speeds in degrees per second.
struct Sample {
  Axes<double> angles{};   ///< Euler angles of the camera as the IMU estimates them; not wrapped
  Axes<double> speeds{};   ///< their derivatives
  Axes<double> targets{};  ///< where the controller holds the camera; not wrapped
  Axes<double> target_speeds{};  ///< 0 once a target is reached
  Axes<double> joints{};         ///< of the motors, from the frame; not wrapped
  Axes<double> frame{};          ///< Euler angles of the frame
  Vector frame_speed{};          ///< true rates about x, y, z of the frame
  Vector gyro{};                 ///< deg/s about x, y, z of the camera, with noise and drift
  Vector acceleration{};         ///< in g, camera, with noise; (0, 0, 1) when level and at rest
  Vector frame_gyro{};
  Vector frame_acceleration{};
  Vector magnetic{};  ///< relative to the strength of the field, camera
  Vector up{};        ///< unit vector that points up, as the main IMU knows it
  Vector north{};     ///< unit vector that points north, as the main IMU knows it
  Vector frame_up{};
  Vector frame_north{};
  Axes<double> power{};      ///< of each motor, 0..1
  Axes<double> imbalance{};  ///< share of the motor power that holding costs, -1..1
  double battery{};          ///< volts
  double current{};          ///< amperes
  double temperature{};      ///< of the main IMU, Celsius
  double frame_temperature{};
  double gravity_error{};  ///< degrees between the estimated and the reference vector, main IMU
  double heading_error{};
  double frame_gravity_error{};
  double frame_heading_error{};
};

struct Mechanics;

/// The simulation. It moves in fixed steps of 4 ms, so its state depends on time and commands only,
/// not on how often it is sampled; a sample between two steps shows the part of the next step up to
/// then. Commands act from the current step on. The same seed and the same commands at the same
/// times give the same samples.
///
/// If more than a minute passes between two calls, 10 s are simulated at the beginning and at the
/// end of it; in between, moves continue or arrive, the camera is held without error, and battery,
/// temperatures and drift change as they would.
///
/// Arguments may be any number: angles are limited to 10^6 degrees, speeds to 2000 deg/s (the range
/// of the gyroscope), signals to -1..1; NaN counts as 0. The axes are independent: the angle of the
/// camera is that of the joint plus that of the frame (plus the error of the estimate). Initially
/// motors are off and joints at 0.
class Gimbal {
 public:
  struct Options {
    std::uint32_t seed = 1;
    Disturbance frame{};    ///< how the frame moves
    double noise = 1;       ///< factor on noise and drift of all sensors; 0: none
    double battery = 16.4;  ///< volts, when full
    double capacity = 3.0;  ///< ampere hours; 0: it never gets empty
    double ambient = 22;    ///< Celsius
    Axes<double> imbalance{0.02, 0.03, 0.01};  ///< share of the motor's torque at power 100
  };

  Gimbal(const Options& options, Instant start);
  Gimbal(const Gimbal&) = delete;
  Gimbal(Gimbal&&) noexcept;
  Gimbal& operator=(const Gimbal&) = delete;
  Gimbal& operator=(Gimbal&&) noexcept;
  ~Gimbal();

  /// The board restarts: commands, targets and estimates are cleared, the camera stays where it is
  /// and moves to the start angles when the motors turn on. Motors are off; whole turns of the
  /// joints are forgotten, calibrations and corrections of the gyroscope are kept.
  void restart(Instant now);
  /// Whenever the parameters change; moves in progress continue.
  void tune(const Tuning& tuning, Instant now);
  /// When motors turn on, the targets are where the camera is; commands continue from there.
  void set_motors(bool on, Instant now);
  bool motors_on() const;
  /// The battery has stopped the motors; until they are turned on with enough voltage.
  bool stopped_by_battery() const;

  void command(std::size_t axis, const AxisCommand& command, Instant now);
  const AxisCommand& command(std::size_t axis) const;
  /// The RC signal of an axis, -1..1; empty: no signal, the axis holds its target.
  void set_remote(std::size_t axis, std::optional<double> signal, Instant now);
  /// The axis follows that angle, in degrees, instead of the frame; empty: as tuned.
  void set_followed(std::size_t axis, std::optional<double> angle, Instant now);

  /// An outer system reports the motion of the frame, which improves the stabilization for a
  /// second. Assumption: the report itself does not matter, the simulation knows the frame.
  void help(Instant now);
  /// Replaces the attitude of an IMU for a second or, as a reference, corrects it slowly for two.
  /// Vectors may have any length; an empty one leaves its part unchanged. Has no effect if they are
  /// parallel, shorter than 0.001 or not finite, or if `up` alone reverses.
  struct Attitude {
    std::optional<Vector> up{};
    std::optional<Vector> north{};
    bool of_frame = false;
    bool reference_only = false;
    /// The other IMU takes the attitude as a reference, through the joints.
    bool translates = false;
  };
  void correct(const Attitude& attitude, Instant now);
  /// Whether the frame's attitude is replaced in that way now.
  bool is_frame_reported(Instant now);
  /// Offset of a gyroscope's zero, deg/s: heading errors grow or shrink with it. `heading` turns
  /// about the vertical. Both replace what was given before.
  void correct_gyro(bool of_frame, const Vector& offset, double heading, Instant now);
  /// A calibration at rest has ended: the drift of that gyroscope is gone until the temperature
  /// changes, and so is its correction.
  void gyro_calibrated(bool of_frame, Instant now);

  /// Test hooks: a hand turns the camera by that angle; a joint sticks (or is free again); the
  /// battery keeps that voltage.
  void push(std::size_t axis, double degrees, Instant now);
  void jam(std::size_t axis, bool is_jammed, Instant now);
  void set_battery(double volts, Instant now);
  /// Places the camera at rest, with its targets there; commands end.
  void place(const Axes<double>& angles, Instant now);

  /// Precondition for all functions: times do not decrease.
  Sample sample(Instant now);

 private:
  std::unique_ptr<Mechanics> mechanics_;
};

}  // namespace sbgc::emulator
