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

/// A vector in space: x points right, y forward, z up (normal position). As a rotation, it turns
/// counter-clockwise when looking against it.
///
/// Positive pitch lowers the front, positive yaw turns it to the right (E384), of camera, frame and
/// joints alike. Assumption: positive roll lowers the right side; no source says so.
using Vector = Xyz<double>;

/// A command for one axis. Angles in degrees, speeds in degrees per second.
///
/// Angles of `angle`, `speed_angle` and RC signals are equal modulo 4 turns, where the 16 bits of
/// the protocol wrap; the one nearest to the current target is used. An axis that follows the frame
/// (or the angle of set_followed()) does so in `remote`, `signal` and `speed`. It counts the angles
/// of RC signals from its neutral position: the followed angle plus `follow_offset`.
enum class AxisMode : std::uint8_t {
  remote,       ///< no control: use the RC signal of the axis
  speed,        ///< turn with `speed`
  angle,        ///< move to `angle` with `speed`; 0 selects the speed in the parameters
  speed_angle,  ///< turn with `speed` and be pulled to `angle`; half a second after the command (an
                ///< assumption) only the angle counts
  signal,       ///< `signal` replaces the RC signal
  relative_angle,  ///< move to `angle`, relative to the frame, over all turns; speed as for `angle`
};

/// A command for an axis.
struct AxisCommand {
  AxisMode mode{};
  double speed{};        ///< deg/s
  double angle{};        ///< degrees
  double signal{};       ///< -1..1
  bool is_lost = false;  ///< `signal` is lost: the axis holds its target
};

/// The tuning of one axis by the parameters.
struct AxisTuning {
  double p = 10, i = 0.1, d = 10;  ///< as in the parameters, multiplied by the gain factor
  double power = 100;              ///< 0..255; 0 means no holding torque
  double acceleration = 0;         ///< limit in deg/s^2; 0 means only the limit of the motor
  double speed = 50;  ///< default speed of moves, deg/s; with 0, a move without a speed of its own
                      ///< does not start
  double follow_speed = 50;                  ///< upper limit in deg/s
  double follow_deadband = 0;                ///< degrees
  double follow_offset = 0;                  ///< of the neutral position, degrees
  bool follows = false;                      ///< the target turns with the frame
  bool remote_is_speed = false;              ///< the RC signal is a speed, not an angle
  double remote_min = -90, remote_max = 90;  ///< angles of the lowest and highest signal
  double remote_speed = 50;                  ///< speed at full signal, deg/s
  double joint_min = 0, joint_max = 0;       ///< limits, degrees; none unless joint_min < joint_max
  double start_angle = 0;                    ///< the target of the axis when the board starts
};

/// Parameters of the board that the motion depends on.
struct Tuning {
  Axes<AxisTuning> axes{};
  std::array<std::uint8_t, 3> rotation_order{1, 0,
                                             2};  ///< axes in Euler order: 0 roll, 1 pitch, 2 yaw
  double gyro_trust = 100;                        ///< 0..255
  double battery_stop = -1;  ///< volts below which the motors stop; negative: never
};

/// All measurable quantities at one time. Angles in degrees, speeds in degrees per second.
struct Sample {
  Axes<double> angles{};   ///< Euler angles of the camera as the IMU estimates them; not wrapped
  Axes<double> speeds{};   ///< their derivatives
  Axes<double> targets{};  ///< the angles that the controller holds; not wrapped
  Axes<double> target_speeds{};  ///< 0 once a target is reached
  Axes<double> joints{};         ///< motor angles relative to the frame; not wrapped
  Axes<double> frame{};          ///< Euler angles of the frame
  Vector frame_speed{};          ///< true rates about x, y, z of the frame
  Vector gyro{};                 ///< deg/s about x, y, z of the camera, with noise and drift
  Vector acceleration{};         ///< in g, camera, with noise; (0, 0, 1) when level and at rest
  Vector frame_gyro{};           ///< deg/s, as `gyro`, of the frame's IMU
  Vector frame_acceleration{};   ///< g, as `acceleration`, of the frame's IMU
  Vector magnetic{};             ///< relative to the strength of the field, camera
  Vector up{};                   ///< unit vector that points up, as the main IMU knows it
  Vector north{};                ///< unit vector that points north, as the main IMU knows it
  Vector frame_up{};             ///< as `up`, of the frame's IMU
  Vector frame_north{};          ///< as `north`, of the frame's IMU
  Axes<double> power{};          ///< of each motor, 0..1
  Axes<double> imbalance{};      ///< share of the motor power needed to hold the axis, -1..1
  double battery{};              ///< volts
  double current{};              ///< amperes
  double temperature{};          ///< of the main IMU, Celsius
  double frame_temperature{};    ///< of the frame's IMU, Celsius
  double gravity_error{};  ///< angle between the estimated and the reference vector of the main
                           ///< IMU, degrees
  double heading_error{};  ///< of the main IMU, degrees
  double frame_gravity_error{};  ///< of the frame's IMU, degrees
  double frame_heading_error{};  ///< of the frame's IMU, degrees
};

/// A vibration of the camera that its motors excite: a resonance of the frame.
struct Vibration {
  double frequency{};    ///< hertz
  double rate = 0.5;     ///< amplitude of the angular speed, deg/s
  std::size_t axis = 1;  ///< 0 roll, 1 pitch, 2 yaw
};

struct Mechanics;

/// The simulation. It advances in fixed steps of 4 ms, so its state depends only on time and
/// commands, not on how often it is sampled; a sample between two steps includes the corresponding
/// part of the next step. Commands take effect in the current step. The same seed and the same
/// commands at the same times give the same samples.
///
/// If more than a minute passes between two calls, only the first and the last 10 s are simulated.
/// In between, moves continue or arrive, the camera is held without error, and battery,
/// temperatures and drift change accordingly.
///
/// Arguments may be any number: angles are limited to 10^6 degrees, speeds to 2000 deg/s (the range
/// of the gyroscope), signals to -1..1; NaN counts as 0. The axes are independent: the camera angle
/// is the sum of the joint and frame angles (plus the error of the estimate). Initially the motors
/// are off and the joints at 0.
class Gimbal {
 public:
  struct Options {
    std::uint32_t seed = 1;
    Disturbance frame{};    ///< the motion of the frame
    double noise = 1;       ///< factor of the noise and drift of all sensors; 0 disables both
    double battery = 16.4;  ///< volts, when full
    double capacity = 3.0;  ///< ampere hours; 0 means that it never runs empty
    double ambient = 22;    ///< Celsius
    Axes<double> imbalance{0.02, 0.03, 0.01};  ///< share of the motor's torque at power 100
    std::optional<Vibration> vibration{};      ///< while the motors are on
    Axes<double> strain{};  ///< share of the motor's power that holds the camera against a force
    Vector gyro_drift{};    ///< of the main gyroscope, deg/s; no calibration removes it
  };

  /// A gimbal at rest, with its motors off.
  Gimbal(const Options& options, Instant start);
  Gimbal(const Gimbal&) = delete;
  Gimbal(Gimbal&&) noexcept;
  Gimbal& operator=(const Gimbal&) = delete;
  /// Takes over the other.
  Gimbal& operator=(Gimbal&&) noexcept;
  ~Gimbal();

  /// Restarts the board: clears commands, targets and estimates and turns the motors off. The
  /// camera stays where it is and moves to the start angles when the motors turn on. Whole turns of
  /// the joints are forgotten; calibrations and gyroscope corrections are kept.
  void restart(Instant now);
  /// Call when the parameters change; moves in progress continue.
  void tune(const Tuning& tuning, Instant now);
  /// Applies the motion of the frame, battery, imbalance, vibration, strain and drift in these
  /// options from now on. The charge drawn from the battery stays drawn; the frame moves at once to
  /// the position of the new motion. Seed, noise and temperature stay unchanged.
  void change(const Options& options, Instant now);
  /// When the motors turn on, the targets start at the current camera angles; commands continue
  /// from there.
  void set_motors(bool on, Instant now);
  /// True if the motors have power.
  bool motors_on() const;
  /// True if the battery stopped the motors and they have not been turned on since with enough
  /// voltage.
  bool stopped_by_battery() const;

  /// Makes an axis turn or hold an angle; without a time, returns its command.
  void command(std::size_t axis, const AxisCommand& command, Instant now);
  const AxisCommand& command(std::size_t axis) const;
  /// Sets the RC signal of an axis, -1..1. Without a signal the axis holds its target.
  void set_remote(std::size_t axis, std::optional<double> signal, Instant now);
  /// Makes the axis follow this angle, in degrees, instead of the frame. Without an angle, it
  /// follows the tuning.
  void set_followed(std::size_t axis, std::optional<double> angle, Instant now);

  /// Reports the motion of the frame from an external system, which improves the stabilization for
  /// a second. Assumption: the reported values do not matter, because the simulation knows the
  /// frame.
  void help(Instant now);
  /// Replaces the attitude of an IMU for a second or, as a reference, corrects it slowly for two
  /// seconds. Vectors may have any length; a missing one leaves its part unchanged. No effect if
  /// the vectors are parallel, shorter than 0.001 or not finite, or if `up` alone is reversed.
  struct Attitude {
    std::optional<Vector> up{};
    std::optional<Vector> north{};
    bool of_frame = false;
    bool reference_only = false;
    /// The other IMU uses the attitude as a reference, through the joints.
    bool translates = false;
  };
  /// Corrects the estimate of an IMU; see Attitude.
  void correct(const Attitude& attitude, Instant now);
  /// True if the frame's attitude is currently replaced this way.
  bool is_frame_reported(Instant now);
  /// Sets the zero offset of a gyroscope in deg/s, which makes heading errors grow or shrink.
  /// `heading` turns about the vertical, up. Replaces earlier values of both.
  void correct_gyro(bool of_frame, const Vector& offset, double heading, Instant now);
  /// Ends a calibration at rest: removes the drift of this gyroscope until the temperature changes,
  /// and its correction.
  void gyro_calibrated(bool of_frame, Instant now);

  /// Test hooks: turn the camera by hand; block or release a joint; fix the battery voltage.
  void push(std::size_t axis, double degrees, Instant now);
  /// Blocks or releases a joint, for tests.
  void jam(std::size_t axis, bool is_jammed, Instant now);
  /// Fixes the voltage of the battery, for tests.
  void set_battery(double volts, Instant now);
  /// Places the camera and its targets at these angles, at rest, and ends all commands.
  void place(const Axes<double>& angles, Instant now);

  /// Precondition for all functions: times do not decrease.
  Sample sample(Instant now);

 private:
  std::unique_ptr<Mechanics> mechanics_;
};

}  // namespace sbgc::emulator
