#include "gateway/reports.hpp"

#include <utility>

#include <fmt/format.h>

#include <sbgc/text.hpp>

#include "command/wording.hpp"
#include "gateway/payload.hpp"
#include "values/leaf_value.hpp"

namespace sbgc::tools {

namespace {

std::string units_text(const AnyMessage& message) {
  Json units = Json::object();
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.field.reserved) return;
    Json meaning = leaf_json(leaf);
    meaning.erase("raw");
    if (!meaning.empty()) units[to_string(leaf.path)] = std::move(meaning);
  });
  return ",\"units\":" + detail::json_text(units);
}

}  // namespace

Json stamped(std::chrono::system_clock::time_point time) {
  return {{"version", payload_version}, {"time", unix_milliseconds(time)}};
}

std::string payload_text(const Json& json) { return detail::json_text(json); }

std::string sample_text(const AnyMessage& message, std::chrono::system_clock::time_point time,
                        bool has_units) {
  return fmt::format(R"({{"version":{},"time":{},"message":"{}","fields":{}{}}})", payload_version,
                     unix_milliseconds(time), message.type().info->name, message.to_json(),
                     has_units ? units_text(message) : "");
}

std::string event_text(const GimbalEvent& event, std::chrono::system_clock::time_point time) {
  Json json = stamped(time);
  json["event"] = event.kind;
  json["message"] = event.message;
  if (event.report != nullptr) {
    json["report"] = {{"message", event.report->type().info->name},
                      {"fields", Json::parse(event.report->to_json())}};
  }
  return payload_text(json);
}

Json result_json(const std::string& gimbal, const std::string& task, const std::string& key,
                 const TaskOutcome& outcome) {
  Json result = stamped();
  result["gimbal"] = gimbal;
  result["task"] = task;
  if (!key.empty()) result["key"] = key;
  result["status"] = outcome.status;
  if (!outcome.code.empty()) {
    result["error"] = {{"code", outcome.code}, {"message", outcome.message}};
  }
  if (!outcome.result.is_null()) result["result"] = outcome.result;
  return result;
}

WaitingMessage answer_to(const Topics& topics, const std::string& gimbal,
                         const ReplyAddress& address, Json result) {
  if (!address.correlation.empty() && is_utf8(address.correlation)) {
    result["correlation"] = address.correlation;
  }
  WaitingMessage message{.kind = WaitingKind::notice, .correlation = address.correlation};
  if (address.topic.empty()) {
    Json event = stamped();
    event["event"] = "result";
    event["result"] = std::move(result);
    message.topic = topics.of(gimbal, "event");
    message.payload = payload_text(event);
  } else {
    message.topic = address.topic;
    message.payload = payload_text(result);
  }
  return message;
}

std::optional<std::string> shortened(const std::string& payload) {
  Json json = Json::parse(payload);
  Json& result = json.contains("event") && json.contains("result") ? json["result"] : json;
  const std::size_t erased =
      json.erase("report") + result.erase("result") + result.erase("ignored");
  if (erased == 0) return {};
  json["shortened"] = true;
  return payload_text(json);
}

}  // namespace sbgc::tools
