/// The current state of the board, for responses and stream samples.
#pragma once

#include <cstddef>
#include <optional>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Fills `data` with current measurements. Precondition for the attitude: the board knows it.
void measure(Device& device, std::size_t port, Instant now, msg::RealtimeData3& data);
void measure(Device& device, std::size_t port, Instant now, msg::RealtimeData4& data);
void measure(Device& device, std::size_t port, msg::RealtimeDataCustomFlags blocks, Instant now,
             msg::RealtimeDataCustom& data);
void measure(Device& device, msg::RealtimeDataCustom2Flags blocks, Instant now,
             msg::RealtimeDataCustom2& data);
/// Returns the requested blocks that the firmware knows; nothing if they do not fit into a body.
std::optional<msg::RealtimeDataCustomFlags> known_blocks(const Device& device,
                                                         msg::RealtimeDataCustomFlags blocks);
void measure(Device& device, Instant now, msg::GetAngles& data);
void measure(Device& device, Instant now, msg::GetAnglesExt& data);
void measure(Device& device, bool of_frame, Instant now, msg::AhrsHelper& data);

/// True if the frame attitude is known: its IMU measures it, or a host reports it.
bool knows_frame(Device& device, Instant now);
/// True if the joint angles are known, which requires encoders or a second IMU.
bool knows_joints(const Device& device);

/// True if this board can send the requested stream. Assumption: a stream of the frame attitude
/// continues when hosts stop reporting it.
bool can_stream(Device& device, const msg::DataStreamInterval& request, Instant now);
/// Sends a sample of the stream if there is room. Precondition: can_stream().
bool offer_sample(Device& device, std::size_t port, const msg::DataStreamInterval& request,
                  Instant now);

}  // namespace sbgc::emulator
