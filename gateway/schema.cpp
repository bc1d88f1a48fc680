#include <string>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/client/calibrations.hpp>
#include <sbgc/client/profiles.hpp>

#include "gateway/fleet.hpp"
#include "gateway/payload.hpp"
#include "gateway/reports.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

Json reference_to(const std::string& definition) { return {{"$ref", "#/$defs/" + definition}}; }

Json text_schema() { return {{"type", "string"}}; }
Json time_schema(const char* description) {
  return {{"type", "integer"}, {"minimum", 0}, {"description", description}};
}
Json one_of_texts(const std::vector<std::string>& texts) { return {{"enum", texts}}; }

/// An object with exactly these members.
Json object_schema(Json properties, const std::vector<std::string>& required) {
  Json schema{{"type", "object"}};
  schema["properties"] = std::move(properties);
  schema["required"] = required;
  schema["additionalProperties"] = false;
  return schema;
}

Json value_schema(const FieldType& type, bool is_to_board);

Json members_schema(const std::vector<FieldType>& members, bool is_to_board) {
  Json properties = Json::object();
  std::vector<std::string> required;
  for (const FieldType& member : members) {
    properties[member.name] = value_schema(member, is_to_board);
    // A member that a command omits has the value of a new message.
    if (!is_to_board && !member.is_optional && !member.is_counter && !member.is_tail()) {
      required.emplace_back(member.name);
    }
  }
  return object_schema(std::move(properties), required);
}

Json integer_schema(const FieldType& type) {
  if (type.size == sizeof(std::int64_t)) {
    return {{"type", "string"}, {"pattern", type.is_wide ? "^[0-9]+$" : "^-?[0-9]+$"}};
  }
  return {{"type", "integer"}, {"minimum", type.lowest}, {"maximum", type.highest}};
}

/// Commands may use names of values.
Json number_schema(const FieldType& type, bool is_to_board) {
  Json number = type.shape == FieldShape::integer ? integer_schema(type)
                                                  // JSON has no infinities and NaN: they are words.
                                                  : Json{{"type", {"number", "string"}}};
  const bool has_names = type.names != nullptr || type.packed != nullptr;
  if (!is_to_board || !has_names || number["type"] == "string") return number;
  Json names = text_schema();
  Json list{{"type", "array"}, {"items", text_schema()}};
  return {{"anyOf", {std::move(number), std::move(names), std::move(list)}}};
}

Json shape_schema(const FieldType& type, bool is_to_board) {
  switch (type.shape) {
    case FieldShape::group: return members_schema(type.members, is_to_board);
    case FieldShape::axes: {
      Json properties = Json::object();
      std::vector<std::string> required;
      for (const char* const axis : type.axes) {
        properties[axis] = value_schema(type.members.front(), is_to_board);
        if (!is_to_board) required.emplace_back(axis);
      }
      return object_schema(std::move(properties), required);
    }
    case FieldShape::list: {
      Json schema{{"type", "array"}, {"items", value_schema(type.members.front(), is_to_board)}};
      if (type.count != 0) schema["maxItems"] = type.count;
      if (type.has_count) schema["minItems"] = type.count;
      return schema;
    }
    case FieldShape::integer:
    case FieldShape::real: return number_schema(type, is_to_board);
    // Secrets are replaced by text.
    case FieldShape::bytes: return {{"type", "string"}};
    case FieldShape::text: return text_schema();
    case FieldShape::announced:
      return {{"type", "object"}, {"minProperties", 1}, {"maxProperties", 1}};
  }
  return {};
}

Json value_schema(const FieldType& type, bool is_to_board) {
  Json schema = shape_schema(type, is_to_board);
  const bool is_member = *type.name != '\0' && type.info != nullptr;
  if (is_member && *type.info->summary != '\0') schema["description"] = type.info->summary;
  return schema;
}

std::string fields_name(const MessageType& type) {
  return std::string("fields.") + type.info->name;
}

/// The members of a message, and those of the enclosing payload.
Json message_schema(const MessageType& type, Json others,
                    const std::vector<std::string>& required) {
  others["message"] = {{"const", type.info->name}};
  others["fields"] = reference_to(fields_name(type));
  return object_schema(std::move(others), required);
}

/// A message with its fields: any type that passes `is_wanted`.
template <class Wanted>
Json messages_schema(const Json& others, const std::vector<std::string>& required,
                     Wanted is_wanted) {
  Json alternatives = Json::array();
  for (const MessageType* const type : message_types()) {
    if (is_wanted(*type)) alternatives.push_back(message_schema(*type, others, required));
  }
  return {{"oneOf", std::move(alternatives)}};
}

bool is_from_board(const MessageType& type) { return type.info->travels(Direction::from_board); }

Json version_schema() { return {{"const", payload_version}}; }
Json stamp_schema() {
  return {{"version", version_schema()},
          {"time", time_schema("Unix time of the gateway in milliseconds")}};
}

Json axes_schema(const char* description) {
  Json properties = Json::object();
  for (const char* const axis : axis_names) properties[axis] = {{"type", "number"}};
  Json schema = object_schema(std::move(properties), {});
  schema["minProperties"] = 1;
  schema["description"] = description;
  return schema;
}

Json profile_schema() {
  return {{"type", "integer"},
          {"minimum", 1},
          {"maximum", profile_count},
          {"description", "counted from 1; without it, the active one"}};
}
Json values_schema() {
  return {{"type", "object"}, {"additionalProperties", {{"type", {"number", "string"}}}}};
}

Json parameters_schema(std::string_view task) {
  if (task == "move") {
    return object_schema({{"angles", axes_schema("degrees")},
                          {"speed",
                           {{"type", "number"},
                            {"exclusiveMinimum", 0},
                            {"description", "degrees per second; 10 without it"}}},
                          {"timeout",
                           {{"type", "number"},
                            {"minimum", 0.1},
                            {"maximum", 600},
                            {"description", "seconds; 30 without it"}}}},
                         {"angles"});
  }
  if (task == "speed") {
    return object_schema({{"speeds", axes_schema("degrees per second; others hold still")}},
                         {"speeds"});
  }
  if (task == "motors") return object_schema({{"on", {{"type", "boolean"}}}}, {"on"});
  if (task == "menu") {
    return object_schema(
        {{"action", {{"type", "string"}, {"description", "as `sbgc menu --list`"}}}}, {"action"});
  }
  if (task == "calibrate") {
    std::vector<std::string> names;
    for (const Calibration& one : calibrations()) names.emplace_back(one.name);
    return object_schema({{"calibration", one_of_texts(names)}, {"values", values_schema()}},
                         {"calibration"});
  }
  if (task == "get") {
    return object_schema(
        {{"names",
          {{"type", "array"}, {"items", text_schema()}, {"minItems", 1}, {"maxItems", 256}}},
         {"profile", profile_schema()}},
        {"names"});
  }
  if (task == "set") {
    return object_schema({{"values", values_schema()}, {"profile", profile_schema()}}, {"values"});
  }
  if (task == "raw") {
    return messages_schema({}, {"message"},
                           [](const MessageType& type) { return type.is_sent_to_board(); });
  }
  return object_schema(Json::object(), {});  // stop, home
}

Json command_schema(std::string_view task) {
  const auto short_text = [](std::size_t longest) {
    return Json{{"type", "string"}, {"minLength", 1}, {"maxLength", longest}};
  };
  Json parameters = parameters_schema(task);
  std::vector<std::string> required;
  if (task != "stop") required = {"version", "key", "deadline"};
  // Some messages of `raw` need it.
  if (task != "stop" && task != "get" && task != "raw") required.emplace_back("sent");
  if (parameters.contains("oneOf") || !parameters["required"].empty()) {
    required.emplace_back("parameters");
  }
  return object_schema(
      {{"version", version_schema()},
       {"key", short_text(longest_key)},
       {"sent", time_schema("Unix time in milliseconds, at which it was sent")},
       {"deadline", time_schema("Unix time in milliseconds, before which it must begin")},
       {"reply", short_text(longest_reply)},
       {"correlation", short_text(longest_correlation)},
       {"parameters", std::move(parameters)}},
      required);
}

Json shortened_schema() {
  return {{"const", true}, {"description", "The whole was too large for the broker"}};
}

Json result_schema() {
  Json properties = stamp_schema();
  properties["gimbal"] = text_schema();
  properties["task"] = text_schema();
  properties["key"] = text_schema();
  properties["correlation"] = text_schema();
  properties["status"] = one_of_texts({"done", "failed", "refused", "unknown"});
  properties["error"] =
      object_schema({{"code", text_schema()}, {"message", text_schema()}}, {"code", "message"});
  properties["result"] = {{"type", "object"}};
  properties["ignored"] = {
      {"type", "array"}, {"items", text_schema()}, {"description", "What was wrong with a `stop`"}};
  properties["repeated"] = {{"const", true}};
  properties["shortened"] = shortened_schema();
  return object_schema(std::move(properties), {"version", "time", "gimbal", "task", "status"});
}

Json state_schema() {
  Json properties = stamp_schema();
  properties["state"] = one_of_texts({"offline", "connecting", "online"});
  for (const char* const name : {"reason", "firmware", "board", "serial_number"}) {
    properties[name] = text_schema();
  }
  properties["connections"] = {{"type", "integer"}};
  properties["stopping"] = {
      {"const", true}, {"description", "A stop has not succeeded for seconds; motion is refused"}};
  std::vector<std::string> tasks(gateway_tasks.begin(), gateway_tasks.end());
  properties["allow"] = {{"type", "array"}, {"items", one_of_texts(tasks)}};
  return object_schema(std::move(properties), {"version", "time", "state"});
}

/// The last will has no time and no statistics.
Json gateway_state_schema() {
  Json properties = stamp_schema();
  properties["state"] = one_of_texts({"offline", "online"});
  properties["since"] = time_schema("Unix time in milliseconds, at which the gateway has started");
  properties["process"] = text_schema();
  for (const char* const name : {"waiting", "most_waiting", "dropped", "thinned", "ignored"}) {
    properties[name] = {{"type", "integer"}, {"minimum", 0}};
  }
  return object_schema(std::move(properties), {"version", "state", "since", "process"});
}

Json event_schema() {
  Json properties = stamp_schema();
  properties["event"] = text_schema();
  properties["message"] = text_schema();
  properties["report"] = messages_schema({}, {"message", "fields"}, is_from_board);
  properties["result"] = reference_to("result");
  properties["shortened"] = shortened_schema();
  return object_schema(std::move(properties), {"version", "time", "event"});
}

}  // namespace

Json gateway_schema() {
  Json definitions = Json::object();
  for (const std::string_view task : gateway_tasks) {
    definitions["command." + std::string(task)] = command_schema(task);
  }
  definitions["result"] = result_schema();
  definitions["state"] = state_schema();
  definitions["event"] = event_schema();
  definitions["gateway_state"] = gateway_state_schema();
  for (const MessageType* const type : message_types()) {
    if (is_from_board(*type)) {
      Json others = stamp_schema();
      others["units"] = {{"type", "object"}, {"additionalProperties", {{"type", "object"}}}};
      definitions[std::string("telemetry.") + type->info->name] =
          message_schema(*type, std::move(others), {"version", "time", "message", "fields"});
    }
    Json fields = members_schema(type->fields(), type->is_sent_to_board());
    fields["description"] = type->info->summary;
    definitions[fields_name(*type)] = std::move(fields);
  }
  return {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
          {"title", "Payloads of sbgc gateway"},
          {"$defs", std::move(definitions)}};
}

}  // namespace sbgc::tools
