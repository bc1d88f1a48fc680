/// Blocks of CMD_REALTIME_DATA_CUSTOM of later firmware.
#pragma once

#include <cstddef>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Parameters;
struct Imus;
struct MeasuredParts;

/// The state of the attitude estimation, as hosts see it.
msg::AhrsDebugInfo attitude_debug(const Sample& sample, const Imus& imus,
                                  const Parameters& parameters);
/// Fills the blocks from MOTOR4_CONTROL on.
void measure_later(MeasuredParts& parts, std::size_t port, msg::RealtimeDataCustomFlags blocks,
                   Instant now, msg::RealtimeDataCustom& data);

}  // namespace sbgc::emulator
