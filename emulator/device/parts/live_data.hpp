/// The present state of the board, for responses and samples of streams.
#pragma once

#include <cstddef>

#include <sbgc/messages/control.hpp>
#include <sbgc/messages/imu.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct Device;

/// Sets `data` to what the board measures now. Precondition for the attitude: the board knows it.
void measure(Device& device, std::size_t port, Instant now, msg::RealtimeData3& data);
void measure(Device& device, std::size_t port, Instant now, msg::RealtimeData4& data);
void measure(Device& device, msg::RealtimeDataCustomFlags blocks, Instant now,
             msg::RealtimeDataCustom& data);
void measure(Device& device, Instant now, msg::GetAngles& data);
void measure(Device& device, Instant now, msg::GetAnglesExt& data);
void measure(Device& device, bool of_frame, Instant now, msg::AhrsHelper& data);

/// Whether the frame's attitude is known: its IMU measures it, or a host reports it.
bool knows_frame(Device& device, Instant now);
/// Whether the angles of the joints are known: that takes encoders or a second IMU.
bool knows_joints(const Device& device);

/// Whether this board can send the stream that a request asks for. Assumption: a stream of the
/// frame's attitude continues when no host reports it any longer.
bool can_stream(Device& device, const msg::DataStreamInterval& request, Instant now);
/// Sends a sample of it, if there is room. Precondition: can_stream().
bool offer_sample(Device& device, std::size_t port, const msg::DataStreamInterval& request,
                  Instant now);

}  // namespace sbgc::emulator
