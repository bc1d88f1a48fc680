/// The current state of the board, for responses and stream samples.
#pragma once

#include <cstddef>
#include <optional>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board_options.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Imus;
struct MeasuredParts;

// Precondition for the attitude: the board knows it.
msg::RealtimeData3 realtime_data_3(MeasuredParts& parts, std::size_t port, Instant now);
msg::RealtimeData4 realtime_data_4(MeasuredParts& parts, std::size_t port, Instant now);
msg::RealtimeDataCustom custom_data(MeasuredParts& parts, std::size_t port,
                                    msg::RealtimeDataCustomFlags blocks, Instant now);
msg::RealtimeDataCustom2 custom_data_2(MeasuredParts& parts, msg::RealtimeDataCustom2Flags blocks,
                                       Instant now);
/// Returns the requested blocks that the firmware knows; nothing if they do not fit into a body.
std::optional<msg::RealtimeDataCustomFlags> known_blocks(Availability versions,
                                                         msg::RealtimeDataCustomFlags blocks);
msg::GetAngles angles(Gimbal& gimbal, Instant now);
msg::GetAnglesExt angles(Gimbal& gimbal, bool has_joints, Instant now);
msg::AhrsHelper directions(Gimbal& gimbal, bool of_frame, Instant now);

/// True if the frame attitude is known: its IMU measures it, or a host reports it.
bool knows_frame(const Imus& imus, Gimbal& gimbal, Instant now);
/// True if the joint angles are known, which requires encoders or a second IMU.
bool knows_joints(const BoardOptions& options, const Imus& imus);

/// True if this board can send the requested stream. Assumption: a stream of the frame attitude
/// continues when hosts stop reporting it.
bool can_stream(const BoardOptions& options, const Imus& imus, Gimbal& gimbal,
                const msg::DataStreamInterval& request, Instant now);
/// Sends a sample of the stream if there is room. Precondition: can_stream().
bool offer_sample(MeasuredParts& parts, std::size_t port, const msg::DataStreamInterval& request,
                  Instant now);

}  // namespace sbgc::emulator
