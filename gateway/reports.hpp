/// The payloads that a gateway publishes, and the JSON Schema of all payloads.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include <sbgc/any.hpp>
#include <sbgc/json_dom.hpp>

#include "gateway/gimbal.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/payload.hpp"

namespace sbgc::tools {

/// Returns the common members of every payload.
Json stamped(std::chrono::system_clock::time_point time = std::chrono::system_clock::now());

std::string payload_text(const Json& json);

/// With `has_units`, "units" has the values of "fields" in their units, by path.
std::string sample_text(const AnyMessage& message, std::chrono::system_clock::time_point time,
                        bool has_units);

std::string event_text(const GimbalEvent& event, std::chrono::system_clock::time_point time);

/// The common members of results; with a key, the result is stored without the address.
Json result_json(const std::string& gimbal, const std::string& task, const std::string& key,
                 const TaskOutcome& outcome);

/// Returns a message with a result: to the address or, without one, as an event of the gimbal.
WaitingMessage answer_to(const Topics& topics, const std::string& gimbal,
                         const ReplyAddress& address, Json result);

/// Removes the lengthy part of a result or an event; returns nothing if there is none.
std::optional<std::string> shortened(const std::string& payload);

/// Returns a JSON Schema (draft 2020-12) with a definition for each kind of payload:
/// "command.TASK", "telemetry.MESSAGE", "result", "state", "event" and "gateway_state". The
/// messages are those of the model.
Json gateway_schema();

}  // namespace sbgc::tools
