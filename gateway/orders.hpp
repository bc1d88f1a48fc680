/// Commands from the broker, whose parameters are checked before anything is sent.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/meta.hpp>

#include "parameters/parameter_messages.hpp"

namespace sbgc::tools {

/// Moves to angles.
struct MoveOrder {
  MoveTarget target{};
  MoveOptions options{};
};
struct StopOrder {};
/// Turns at a speed until a dead man's switch triggers.
struct SpeedOrder {
  Axes<msg::ControlSpeed> speed{};
};
/// One request and its response.
struct CallOrder {
  AnyMessage request;
};
struct CalibrateOrder {
  AnyMessage request;
};
/// The profile counts from 0; without one, the active profile.
struct GetOrder {
  std::vector<FoundParameters> parameters{};
  std::optional<std::uint8_t> profile{};
};
struct SetOrder {
  std::vector<MessageValues> values{};
  std::optional<std::uint8_t> profile{};
};

struct Order {
  std::variant<StopOrder, MoveOrder, SpeedOrder, CallOrder, CalibrateOrder, GetOrder, SetOrder>
      what{};
  /// It must run soon or never: the camera can move, the motors gain or lose power, the board
  /// restarts, or the effect is unknown.
  bool must_not_wait = false;
  /// It turns the motors off, so it takes precedence over all others but `stop`.
  bool is_urgent = false;
  /// The duration of the motion after the response.
  std::chrono::milliseconds goes_on{0};

  static constexpr auto forever = std::chrono::milliseconds::max();

  /// True if the camera must be stopped when nobody is in control any more.
  bool sets_in_motion() const {
    return std::holds_alternative<MoveOrder>(what) || std::holds_alternative<SpeedOrder>(what) ||
           goes_on.count() != 0;
  }
};

/// Parses the parameters of a task. Throws Refusal. Messages of `raw` may read and have
/// `raw_effects`.
Order read_order(std::string_view task, const Json& parameters, Effects raw_effects);

}  // namespace sbgc::tools
