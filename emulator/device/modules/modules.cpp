
#include "device/modules/modules.hpp"

#include <cmath>
#include <utility>

#include <sbgc/internal/crc32.hpp>

#include "device/external_motors/external_motors.hpp"
#include "device/features.hpp"
#include "physics/attitude.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

constexpr std::uint16_t imu_firmware = 120;
constexpr std::uint16_t driver_firmware = 142;

template <class E>
E counted(E first, std::size_t index) {
  return static_cast<E>(static_cast<std::size_t>(first) + index);
}

}  // namespace

std::size_t can_drivers(const BoardOptions& options) {
  if (!features_of(options).has(msg::BoardFeature::can_port)) return 0;
  return ExternalMotors::are_supported(options) ? ExternalMotors::count : 3;
}

std::vector<Module> modules_of(const BoardOptions& options) {
  using Kind = msg::CanDeviceKind;
  std::vector<Module> modules;
  if (!features_of(options).has(msg::BoardFeature::can_port)) return modules;
  modules.push_back({msg::ModuleId::imu_main, msg::CanDeviceId::can_imu_main, Kind::imu,
                     msg::TransparentDevice::can_imu_main, imu_firmware});
  if (options.has_frame_imu) {
    modules.push_back({msg::ModuleId::imu_frame, msg::CanDeviceId::can_imu_frame, Kind::imu,
                       msg::TransparentDevice::can_imu_frame, imu_firmware});
  }
  constexpr std::size_t reachable = 4;
  for (std::size_t i = 0; i < can_drivers(options); ++i) {
    const auto transparent =
        i < reachable ? counted(msg::TransparentDevice::can_drv1, i) : msg::TransparentDevice{};
    modules.push_back({counted(msg::ModuleId::can_drv1, i), counted(msg::CanDeviceId::can_drv1, i),
                       Kind::motor_driver, transparent, driver_firmware});
  }
  return modules;
}

msg::CanDrvTelemetry telemetry(const BoardOptions& options, ExternalMotors& external_motors,
                               Gimbal& gimbal, std::size_t driver, msg::CanDrvTelemetryFlags fields,
                               msg::MillisecondClock time, Instant now) {
  using enum msg::CanDrvTelemetryFlag;
  const Sample sample = gimbal.sample(now);
  // Assumption: the drivers are those of the external motors, or of the axes without them.
  ExternalMotors::Motion motion;
  if (ExternalMotors::are_supported(options)) {
    motion = external_motors.motion(driver, now);
  } else {
    motion = {sample.speeds[driver] - turning(sample.frame_speed)[driver], sample.power[driver]};
  }
  const double milliamperes = 50 + 2000 * std::abs(motion.load);
  constexpr double degrees_per_turn = 360;
  msg::CanDrvTelemetry data;
  data.drv_id = static_cast<std::uint8_t>(driver);
  data.timestamp_ms = time;
  if (fields.has(can_bus_flags)) data.can_bus_flags = std::uint8_t{0};
  if (fields.has(can_bus_err_cnt)) data.can_bus_err_cnt = std::uint16_t{0};
  if (fields.has(temp_board)) data.temp_board = saturated<msg::Temperature>(sample.temperature + 2);
  if (fields.has(temp_motor)) data.temp_motor = saturated<msg::Temperature>(sample.temperature);
  if (fields.has(avg_current)) data.avg_current = saturated<msg::Current>(milliamperes);
  if (fields.has(bus_voltage)) data.bus_voltage = saturated<msg::Millivolts>(sample.battery);
  if (fields.has(pin_state)) data.pin_state.emplace();
  if (fields.has(phase_current)) {
    auto& phases = data.phase_current.emplace();
    phases[0] = saturated<msg::SignedCurrent>(milliamperes);
    phases[1] = phases[2] = saturated<msg::SignedCurrent>(-milliamperes / 2);
  }
  if (fields.has(encoder_error_cnt)) data.encoder_error_cnt = std::uint16_t{0};
  if (fields.has(iq_id_current)) {
    data.iq_current = saturated<msg::SignedCurrent>(2000 * motion.load);
    data.id_current = msg::SignedCurrent{};
  }
  if (fields.has(motor_speed)) {
    data.motor_speed = saturated<msg::RevolutionsPerMinute>(motion.speed * 60 / degrees_per_turn);
  }
  if (fields.has(pid_pos_err)) data.pid_pos_err = std::int16_t{0};
  if (fields.has(pid_speed_err)) data.pid_speed_err = std::int16_t{0};
  if (fields.has(iq_ref)) data.iq_ref = saturated<msg::CurrentShare>(100 * motion.load);
  if (fields.has(pid_current_err)) data.pid_current_err = std::int16_t{0};
  return data;
}

bool ModuleFlash::start(const msg::ModuleFlashStart& request) {
  // Assumption: no module accepts more.
  constexpr std::uint32_t most_words = 1U << 20U;
  const std::uint32_t words = request.firmware_size.raw();
  if (words == 0 || words > most_words) return false;
  run_ = Run{request.device_id, std::size_t{words} * 4, 0, {}};
  firmware_[request.device_id].clear();
  return true;
}

bool ModuleFlash::write(const msg::ModuleFlashWrite& request) {
  if (!run_ || run_->module != request.device_id) return false;
  const std::span<const std::uint8_t> data(request.data.data(), request.data.size());
  const bool is_next = request.packet_id == run_->packet && request.address == run_->data.size();
  if (!is_next || run_->data.size() + data.size() > run_->size) return false;
  if (sbgc::detail::crc32(data) != request.data_crc32) return false;
  run_->data.insert(run_->data.end(), data.begin(), data.end());
  ++run_->packet;
  return true;
}

bool ModuleFlash::finish(const msg::ModuleFlashFinish& request) {
  if (!run_ || run_->module != request.device_id || run_->data.size() != run_->size) return false;
  if (sbgc::detail::crc32(run_->data) != request.file_crc32) return false;
  firmware_[run_->module] = std::move(run_->data);
  run_.reset();
  return true;
}

}  // namespace sbgc::emulator
