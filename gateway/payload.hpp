/// The topics of a gateway, and the payloads of commands, which are untrusted.
///
///     sbgc/<fleet>/<gimbal>/state                 retained
///     sbgc/<fleet>/<gimbal>/telemetry/<message>
///     sbgc/<fleet>/<gimbal>/event
///     sbgc/<fleet>/<gimbal>/cmd/<task>            to the gateway
///     sbgc/<fleet>/<gimbal>/raw                   to the gateway
/// sbgc/<fleet>/reply/…                        results, at the address of the command
///     sbgc/<fleet>/gateway/…                      of the gateway itself
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// The version of all payloads.
inline constexpr int payload_version = 1;

/// The level of the gateway's own topics.
inline constexpr const char* gateway_level = "gateway";

inline constexpr std::size_t longest_payload = 65'536;
inline constexpr std::size_t longest_key = 128;    ///< of idempotence
inline constexpr std::size_t longest_reply = 256;  ///< topic
inline constexpr std::size_t most_reply_levels = 32;
inline constexpr std::size_t longest_correlation = 128;

/// A refused command: a word for programs and a sentence for people.
class Refusal : public std::runtime_error {
 public:
  Refusal(const char* code, const std::string& message)
      : std::runtime_error(message), code_(code) {}

  const char* code() const noexcept { return code_; }

 private:
  const char* code_;
};

/// The topic of a command.
struct CommandTopic {
  std::string gimbal{};
  std::string task{};  ///< `raw` for the topic of that name
};

class Topics {
 public:
  explicit Topics(const std::string& fleet) : root_("sbgc/" + fleet + '/') {}

  std::string of(std::string_view gimbal, std::string_view rest) const {
    return root_ + std::string(gimbal) + '/' + std::string(rest);
  }
  /// Parses a command topic; returns nothing for other topics.
  std::optional<CommandTopic> command(std::string_view topic) const;
  /// True if results may be sent there: a topic that every broker accepts.
  bool is_reply(std::string_view topic) const;

 private:
  std::string root_;
};

/// The members of a payload besides the task.
struct CommandPayload {
  using Time = std::chrono::system_clock::time_point;

  std::string key{};
  std::string reply{};
  std::string correlation{};
  std::optional<Time> sent{};
  std::optional<Time> deadline{};
  Json parameters = Json::object();
};

bool is_utf8(std::string_view text);

/// True if it can be an idempotency key.
bool is_key(std::string_view text);

/// Parses into `payload`, which keeps the members before a problem. Throws Refusal.
void read_payload(std::string_view text, const Topics& topics, CommandPayload& payload);

/// The same for a `stop`, which needs no members: returns the problems, which are ignored.
std::vector<std::string> read_stop_payload(std::string_view text, const Topics& topics,
                                           CommandPayload& payload);

/// Converts a time to the format of payloads and the journal.
inline std::int64_t unix_milliseconds(std::chrono::system_clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

}  // namespace sbgc::tools
