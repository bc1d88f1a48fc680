/// What the board tells of its present state: answers and samples of streams.
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

/// Whether the frame's attitude is known: its IMU measures it, or a host tells it.
bool knows_frame(Device& device, Instant now);
/// Without encoders and a second IMU nothing knows the joints.
bool knows_joints(const Device& device);

/// Whether this board can send the stream that a request asks for. That of the frame's attitude
/// goes on when no host tells it any more: ours.
bool can_stream(Device& device, const msg::DataStreamInterval& request, Instant now);
/// Sends a sample of it, if there is room. Precondition: can_stream().
bool offer_sample(Device& device, std::size_t port, const msg::DataStreamInterval& request,
                  Instant now);

}  // namespace sbgc::emulator
