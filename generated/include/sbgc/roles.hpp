// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Messages by what they are in the conversation, whatever they are called.
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
struct AhrsHelper;

enum class BoardErrorCode : std::uint8_t;
}  // namespace msg

namespace roles {

/// Says that the board has carried out a command.
using Confirmation = msg::Confirm;
/// Says that it could not: one type, or a TypeList of forms.
using BoardError = TypeList<msg::Error, msg::ErrorExt>;
/// Why.
using ErrorReason = msg::BoardErrorCode;
/// Says that the board is about to restart.
using Reset = msg::Reset;
/// Says what the board is.
using Introduction = msg::BoardInfo;
/// Asks for the introduction.
using IntroductionRequest = msg::BoardInfoRequest;
/// Says what else there is to know about the board.
using Details = msg::BoardInfo3;
/// Asks for these details.
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
using StreamMessages = TypeList<msg::RealtimeData3, msg::RealtimeData4, msg::RealtimeDataCustom, msg::AhrsHelper>;

/// The command whose message a StreamRequest is about.
template <class Request>
constexpr auto& stream_command(Request& request) noexcept {
  return request.cmd_id;
}
/// The time between two messages of the stream.
template <class Request>
constexpr auto& stream_interval(Request& request) noexcept {
  return request.interval_ms;
}

/// Microseconds that one count of the interval is.
inline constexpr std::uint32_t stream_interval_us = 1000;
/// The interval, in counts, that ends a stream.
inline constexpr std::uint32_t stream_end = 0;
/// The interval, in counts, that stands for every cycle of the board, and how long one is.
inline constexpr std::uint32_t stream_cycle = 1;
inline constexpr std::uint32_t stream_cycle_us = 800;
/// Maximum number of streams at a time, on all ports of the board together; 0 if it is not known.
inline constexpr std::size_t stream_limit = 10;

/// The largest documented body of a confirmation.
inline constexpr std::size_t confirmation_size = 6;

constexpr bool is_confirmation([[maybe_unused]] const Frame& frame) noexcept {
  return frame.id == 67 && frame.body.size() >= 1;
}

/// The id of the command that a confirmation names. Precondition: is_confirmation(frame).
constexpr std::uint8_t confirmed_command([[maybe_unused]] const Frame& frame) noexcept {
  return frame.body[0];
}

constexpr bool is_error([[maybe_unused]] const Frame& frame) noexcept {
  return (frame.id == 255 && frame.body.size() == 5) ||
         (frame.id == 255 && frame.body.size() >= 6);
}

/// The id of the command that an error names, or 0. Precondition: is_error(frame).
constexpr std::uint8_t failed_command([[maybe_unused]] const Frame& frame) noexcept {
  if (frame.id == 255 && frame.body.size() >= 6) return frame.body[0];
  return 0;
}

/// What it says was the reason. Precondition: is_error(frame).
constexpr ErrorReason error_reason(const Frame& frame) noexcept {
  if (frame.id == 255 && frame.body.size() >= 6) {
    return static_cast<ErrorReason>(frame.body[1]);
  }
  return static_cast<ErrorReason>(frame.body[0]);
}

/// The number that says why a request failed: the code of an error, or the result in a confirmation or
/// in another response; 0 in a message that has neither.
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

/// How long after it the board restarts.
inline constexpr std::uint32_t reset_delay_ms = 1000;

/// The id of the request, with an empty body, that asks for the introduction; 0 if there is none.
inline constexpr std::uint8_t introduction_request_id = 86;

/// The largest documented body of an introduction.
inline constexpr std::size_t introduction_size = 18;

constexpr bool is_introduction([[maybe_unused]] const Frame& frame) noexcept {
  return frame.id == 86 && frame.body.size() >= 18;
}

}  // namespace roles

/// The versions in the introduction of a board.
template <class Info>
  requires std::is_same_v<Info, roles::Introduction>
constexpr Availability versions_of(const Info& info) noexcept {
  return {info.firmware_ver.raw(), info.board_ver.raw()};
}

}  // namespace sbgc
