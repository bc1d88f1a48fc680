#include "gateway/payload.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include <sbgc/internal/characters.hpp>
#include <sbgc/parse_json.hpp>

#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

constexpr std::size_t deepest_payload = 16;

/// True if a text can be part of a topic, and is displayable.
bool is_plain_text(std::string_view text) {
  bool is_plain = true;
  detail::for_each_sequence(text, [&](std::string_view sequence, bool is_valid) {
    is_plain = is_plain && is_valid && !detail::is_control(detail::code_point(sequence));
  });
  return is_plain;
}

bool is_ascii(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; });
}

std::string text_member(const Json& value, const std::string& name, std::size_t longest) {
  if (!value.is_string()) throw Refusal("invalid", fmt::format("'{}' must be a string", name));
  const auto text = value.get<std::string>();
  if (text.empty() || text.size() > longest || !is_plain_text(text)) {
    throw Refusal("invalid", fmt::format("'{}' must be 1 to {} bytes without control characters",
                                         name, longest));
  }
  return text;
}

CommandPayload::Time time_member(const Json& value, const std::string& name) {
  using std::chrono::milliseconds;
  // The range of the clock.
  constexpr std::int64_t most =
      std::chrono::duration_cast<milliseconds>(CommandPayload::Time::duration::max()).count();
  if (!value.is_number_integer() || value < 0 || value > most) {
    throw Refusal("invalid", fmt::format("'{}' must be Unix time in milliseconds", name));
  }
  return CommandPayload::Time(milliseconds(value.get<std::int64_t>()));
}

void read_member(const std::string& name, const Json& value, const Topics& topics,
                 CommandPayload& payload) {
  if (name == "version") {
    if (value != payload_version) {
      throw Refusal("version", fmt::format("'version' must be {}", payload_version));
    }
  } else if (name == "key") {
    payload.key = text_member(value, name, longest_key);
  } else if (name == "correlation") {
    payload.correlation = text_member(value, name, longest_correlation);
  } else if (name == "reply") {
    const std::string reply = text_member(value, name, longest_reply);
    if (!topics.is_reply(reply)) {
      throw Refusal("invalid",
                    fmt::format("'reply' must be a topic below {}, of at most {} levels in ASCII, "
                                "without wildcards",
                                topics.of("reply", ""), most_reply_levels));
    }
    payload.reply = reply;
  } else if (name == "deadline") {
    payload.deadline = time_member(value, name);
  } else if (name == "sent") {
    payload.sent = time_member(value, name);
  } else if (name == "parameters") {
    if (!value.is_object()) throw Refusal("invalid", "'parameters' must be an object");
    payload.parameters = value;
  } else {
    throw Refusal("invalid", fmt::format("unknown key '{}'", clipped(name)));
  }
}

/// Returns the members of a payload.
Json payload_members(std::string_view text) {
  ParsedJson parsed = parse_json(text, {.size = longest_payload, .depth = deepest_payload});
  if (!parsed) {
    throw Refusal("invalid", fmt::format("the payload is no JSON: {}, at line {}, column {}",
                                         parsed.problem->reason, parsed.problem->line,
                                         parsed.problem->column));
  }
  if (!parsed.value.is_object()) throw Refusal("invalid", "the payload must be a JSON object");
  return std::move(parsed.value);
}

}  // namespace

std::optional<CommandTopic> Topics::command(std::string_view topic) const {
  if (!topic.starts_with(root_)) return {};
  topic.remove_prefix(root_.size());
  const std::size_t end = topic.find('/');
  if (end == 0 || end == std::string_view::npos) return {};
  const std::string gimbal(topic.substr(0, end));
  topic.remove_prefix(end + 1);
  if (topic == "raw") return CommandTopic{gimbal, "raw"};
  constexpr std::string_view commands = "cmd/";
  if (!topic.starts_with(commands)) return {};
  topic.remove_prefix(commands.size());
  if (topic.empty() || topic.find('/') != std::string_view::npos) return {};
  return CommandTopic{gimbal, std::string(topic)};
}

bool Topics::is_reply(std::string_view topic) const {
  const std::string box = of("reply", "");
  return topic.size() > box.size() && topic.size() <= longest_reply && topic.starts_with(box) &&
         topic.find_first_of("+#") == std::string_view::npos && is_ascii(topic) &&
         std::ranges::count(topic, '/') < static_cast<std::ptrdiff_t>(most_reply_levels);
}

bool is_utf8(std::string_view text) {
  bool is_valid = true;
  detail::for_each_sequence(text, [&](std::string_view, bool valid) { is_valid &= valid; });
  return is_valid;
}

bool is_key(std::string_view text) {
  return !text.empty() && text.size() <= longest_key && is_plain_text(text);
}

void read_payload(std::string_view text, const Topics& topics, CommandPayload& payload) {
  const Json members = payload_members(text);
  // The reply address is parsed first: it also gets refusals of the rest.
  for (const char* const name : {"reply", "correlation", "key"}) {
    const auto found = members.find(name);
    if (found != members.end()) read_member(name, *found, topics, payload);
  }
  const char* const version = "version";
  read_member(version, members.contains(version) ? members[version] : Json(), topics, payload);
  for (const auto& [name, value] : members.items()) read_member(name, value, topics, payload);
}

std::vector<std::string> read_stop_payload(std::string_view text, const Topics& topics,
                                           CommandPayload& payload) {
  std::vector<std::string> ignored;
  const auto attempt = [&](auto read) {
    try {
      read();
    } catch (const Refusal& refusal) {
      ignored.emplace_back(refusal.what());
    }
  };
  Json members = Json::object();
  if (!text.empty()) attempt([&] { members = payload_members(text); });
  for (const auto& item : members.items()) {
    attempt([&] { read_member(item.key(), item.value(), topics, payload); });
  }
  for (const auto& item : payload.parameters.items()) {
    ignored.push_back(fmt::format("unknown parameter '{}'", clipped(item.key())));
  }
  constexpr std::size_t most = 8;
  if (ignored.size() > most) {
    ignored.resize(most);
    ignored.emplace_back("and more");
  }
  return ignored;
}

}  // namespace sbgc::tools
