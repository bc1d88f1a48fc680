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
/// about x, yaw about z, counter-clockwise looking against the axis. Ours: the specification does
/// not publish directions.
using Vector = Xyz<double>;

/// What an axis is told to do. Angles in degrees, speeds in degrees per second.
///
/// Angles of `angle`, `speed_angle` and RC signals mean the same angle modulo 4 turns, where the
/// protocol's 16 bits wrap: the nearest one to the present target. An axis that follows the frame
/// (or what set_followed() tells) does so in `remote`, `signal` and `speed`, and counts the angles
/// of RC signals from its neutral position, that is what it follows plus `follow_offset`.
enum class AxisMode : std::uint8_t {
  remote,          ///< no control: the RC signal of the axis
  speed,           ///< turn with `speed`
  angle,           ///< go to `angle` with `speed`, 0: the speed of the settings
  speed_angle,     ///< turn with `speed` and be pulled to `angle`; half a second after the command
                   ///< (ours) the angle alone counts
  signal,          ///< `signal` stands for the RC signal
  relative_angle,  ///< go to `angle`, counted from the frame, over all turns; speed as for `angle`
};

struct AxisCommand {
  AxisMode mode{};
  double speed{};
  double angle{};
  double signal{};  ///< -1..1
};

/// How the settings tune one axis.
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

/// The simulation. It moves in fixed steps of 4 ms, so that its state depends on time and commands
/// alone and not on how often it is asked; a sample between two steps is what the next one will do
/// up to then. Commands act from the step on that has begun. Same seed, same commands at the same
/// times: same samples.
///
/// If nobody asks for more than a minute, 10 s are simulated at the beginning and at the end of
/// that time; between them moves that have speed go on or arrive, the camera is held without error,
/// and battery, temperatures and drift go where they would.
///
/// What is handed in may be any number: angles are held within 10^6 degrees, speeds within
/// 2000 deg/s (which the gyroscope can measure), signals within -1..1; no number counts as 0. The
/// axes are independent of each other: an angle of the camera is that of the joint plus that of the
/// frame (plus the estimate's error). Motors are off at the beginning; the joints are at 0.
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

  /// The board starts anew: commands, targets and estimates are forgotten, the camera stays where
  /// it is, and moves to the start angles when the motors turn on. Motors are off; whole turns of
  /// the joints are forgotten, what calibrations and corrections of the gyroscope do is not.
  void restart(Instant now);
  /// As often as the settings change; what is under way goes on.
  void tune(const Tuning& tuning, Instant now);
  /// Targets are where the camera is when motors turn on; it goes on from there with its command.
  void set_motors(bool on, Instant now);
  bool motors_on() const;
  /// The battery has stopped the motors, until they are turned on and it has enough voltage.
  bool stopped_by_battery() const;

  void command(std::size_t axis, const AxisCommand& command, Instant now);
  const AxisCommand& command(std::size_t axis) const;
  /// The RC signal of an axis, -1..1; none: no signal, the axis holds its target.
  void set_remote(std::size_t axis, std::optional<double> signal, Instant now);
  /// The axis follows that angle, in degrees, and not the frame; none: as its tuning says.
  void set_followed(std::size_t axis, std::optional<double> angle, Instant now);

  /// An outer system tells what it knows of the frame; that improves the stabilization for a
  /// second. Ours: what it tells does not matter, the simulation knows the frame.
  void help(Instant now);
  /// Replaces what an IMU knows of its attitude for a second, or as a reference corrects it slowly
  /// for two. Vectors of any length; what is not given stays. Nothing happens if they are parallel,
  /// shorter than 0.001, not finite, or `up` alone is opposite to what it was.
  struct Attitude {
    std::optional<Vector> up{};
    std::optional<Vector> north{};
    bool of_frame = false;
    bool reference_only = false;
    /// By the joints it also tells the attitude of the other IMU, which takes it as a reference.
    bool translates = false;
  };
  void correct(const Attitude& attitude, Instant now);
  /// Whether the frame's attitude is replaced so now.
  bool is_frame_told(Instant now);
  /// Offset of a gyroscope's zero, deg/s: heading errors grow or shrink with it. `heading` turns
  /// about the vertical. Both replace what was given before.
  void correct_gyro(bool of_frame, const Vector& offset, double heading, Instant now);
  /// A calibration at rest has ended: the drift of that gyroscope is gone, until the temperature
  /// changes, and so is its correction.
  void gyro_calibrated(bool of_frame, Instant now);

  /// Test hooks: a hand turns the camera by so many degrees; a joint is stuck (or free again); the
  /// battery's voltage is this from now on.
  void push(std::size_t axis, double degrees, Instant now);
  void jam(std::size_t axis, bool is_jammed, Instant now);
  void set_battery(double volts, Instant now);
  /// Places the camera, at rest, with its targets there; commands end.
  void place(const Axes<double>& angles, Instant now);

  /// Precondition for all: times do not decrease.
  Sample sample(Instant now);

 private:
  std::unique_ptr<Mechanics> mechanics_;
};

}  // namespace sbgc::emulator
