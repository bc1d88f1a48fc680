// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Messages by their role in the conversation, independent of their names.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/type_list.hpp>

namespace sbgc {

namespace msg {
struct BoardInfo;
struct BoardInfo3;
struct Confirm;
struct DataStreamInterval;
struct Error;
struct ErrorExt;
struct Reset;
struct BoardInfoRequest;
struct BoardInfo3Request;
struct RealtimeData3;
struct RealtimeData4;
struct RealtimeDataCustom;
struct RealtimeDataCustom2;
struct AhrsHelper;
struct Event;
struct CanDrvTelemetry;
struct ExtMotorsState;

enum class BoardErrorCode : std::uint8_t;
}  // namespace msg

namespace roles {

/// Confirms that the board has executed a command.
using Confirmation = msg::Confirm;
/// Reports that the board could not execute a command: one type, or a TypeList of forms.
using BoardError = TypeList<msg::Error, msg::ErrorExt>;
/// The reason that an error reports.
using ErrorReason = msg::BoardErrorCode;
/// Announces that the board is about to restart.
using Reset = msg::Reset;
/// Describes the board and its versions.
using Introduction = msg::BoardInfo;
/// Requests the introduction.
using IntroductionRequest = msg::BoardInfoRequest;
/// Describes further properties of the board.
using Details = msg::BoardInfo3;
/// Requests the details.
using DetailsRequest = msg::BoardInfo3Request;

/// The bytes that identify the board, in Details.
template <class M>
constexpr auto& serial_number(M& details) noexcept {
  return details.device_id;
}

/// The size of its EEPROM, in Details.
template <class M>
constexpr auto& eeprom_size(M& details) noexcept {
  return details.eeprom_size;
}
/// Starts, changes and ends a data stream.
using StreamRequest = msg::DataStreamInterval;
/// The messages that streams consist of.
using StreamMessages = TypeList<msg::RealtimeData3, msg::RealtimeData4, msg::RealtimeDataCustom, msg::RealtimeDataCustom2, msg::AhrsHelper, msg::Event, msg::CanDrvTelemetry, msg::ExtMotorsState>;

/// The command whose messages the stream consists of.
template <class Request>
constexpr auto& stream_command(Request& request) noexcept {
  return request.cmd_id;
}
/// The time between two messages of the stream.
template <class Request>
constexpr auto& stream_interval(Request& request) noexcept {
  return request.interval_ms;
}

/// Microseconds per count of the interval.
inline constexpr std::uint32_t stream_interval_us = 1000;
/// The interval, in counts, that ends a stream.
inline constexpr std::uint32_t stream_end = 0;
/// The interval, in counts, that means every cycle of the board, and the length of a cycle.
inline constexpr std::uint32_t stream_cycle = 1;
inline constexpr std::uint32_t stream_cycle_us = 800;
/// Maximum number of simultaneous streams on all ports of the board together; 0 if unknown.
inline constexpr std::size_t stream_limit = 10;

/// The largest documented body of a confirmation.
inline constexpr std::size_t confirmation_size = 6;

constexpr bool is_confirmation([[maybe_unused]] const Frame& frame) noexcept {
  return frame.id == 67 && frame.body.size() >= 1;
}

/// Returns the id of the command that a confirmation names. Precondition: is_confirmation(frame).
constexpr std::uint8_t confirmed_command([[maybe_unused]] const Frame& frame) noexcept {
  return frame.body[0];
}

constexpr bool is_error([[maybe_unused]] const Frame& frame) noexcept {
  return (frame.id == 255 && frame.body.size() == 5) ||
         (frame.id == 255 && frame.body.size() >= 6);
}

/// Returns the id of the command that an error names, or 0. Precondition: is_error(frame).
constexpr std::uint8_t failed_command([[maybe_unused]] const Frame& frame) noexcept {
  if (frame.id == 255 && frame.body.size() >= 6) return frame.body[0];
  return 0;
}

/// Returns the reason that an error reports. Precondition: is_error(frame).
constexpr ErrorReason error_reason(const Frame& frame) noexcept {
  if (frame.id == 255 && frame.body.size() >= 6) {
    return static_cast<ErrorReason>(frame.body[1]);
  }
  return static_cast<ErrorReason>(frame.body[0]);
}

/// Returns the number that explains why a request failed: the code of an error, or the result in a
/// confirmation or another response; 0 if the message has neither.
constexpr std::uint32_t failure_code([[maybe_unused]] const Frame& frame) noexcept {
  if (frame.id == 255 && frame.body.size() == 5) return frame.body[0];
  if (frame.id == 255 && frame.body.size() >= 6) return frame.body[1];
  if (frame.id == 53 && frame.body.size() == 1) return frame.body[0];
  if (!is_confirmation(frame)) return 0;
  const std::uint8_t command = confirmed_command(frame);
  if (command == 54 && frame.body.size() >= 2) {
    return frame.body[1];
  }
  if (command == 55 && frame.body.size() >= 2) {
    return frame.body[1];
  }
  return 0;
}

constexpr bool is_reset([[maybe_unused]] const Frame& frame) noexcept {
  return frame.id == 114;
}

/// The time from the announcement of a restart to the restart.
inline constexpr std::uint32_t reset_delay_ms = 1000;

/// The id of the request for the introduction, which has an empty body; 0 if there is none.
inline constexpr std::uint8_t introduction_request_id = 86;

/// The largest documented body of an introduction.
inline constexpr std::size_t introduction_size = 18;

constexpr bool is_introduction([[maybe_unused]] const Frame& frame) noexcept {
  return frame.id == 86 && frame.body.size() >= 18;
}

}  // namespace roles

/// Returns the features that a board lacks, of those that the message reports.
template <class Message>
  requires std::is_same_v<Message, msg::BoardInfo>
constexpr std::uint64_t lacking_features(const Message& message) noexcept {
  return (std::uint64_t{0xFFFF} & ~std::uint64_t{message.board_features.raw()}) |
         (std::uint64_t{0xFD} & ~std::uint64_t{message.board_features_ext.raw()}) << 16;
}

/// Returns the features that a board lacks, of those that the message reports.
template <class Message>
  requires std::is_same_v<Message, msg::BoardInfo3>
constexpr std::uint64_t lacking_features(const Message& message) noexcept {
  return (std::uint64_t{0x1F} & ~std::uint64_t{message.board_features_ext2.raw()}) << 32;
}

/// Returns the versions in the introduction of a board, and the features that it lacks.
template <class Info>
  requires std::is_same_v<Info, roles::Introduction>
constexpr Availability versions_of(const Info& info) noexcept {
  return {info.firmware_ver.raw(), info.board_ver.raw(), lacking_features(info)};
}

}  // namespace sbgc
