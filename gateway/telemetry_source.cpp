#include "gateway/telemetry_source.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/meta/all.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

bool is_telemetry_name(std::string_view word, const MessageInfo& info) {
  return detail::is_same_word(word, info.name) || is_command_name(word, info.command);
}

/// True if the message only requests data, and needs no content.
bool is_plain_request(const MessageType& type) {
  const MessageInfo& info = *type.info;
  return type.is_sent_to_board() && info.min_size == 0 && info.effects == Effects(Effect::reads) &&
         info.answers.size() == 1;
}

}  // namespace

TelemetrySource TelemetrySource::find(std::string_view message, std::string_view contents) {
  TelemetrySource source;
  std::vector<std::string> streams;
  for (const MessageType* const type : stream_types()) streams.emplace_back(type->info->name);
  const bool is_streamed = std::ranges::any_of(stream_types(), [&](const MessageType* type) {
    return is_telemetry_name(message, *type->info);
  });
  if (is_streamed) {
    source.stream_ = StreamType::find(message);
    source.stream_->configure(contents);
    if (source.stream_->lacks_flags()) {
      throw CommandError(fmt::format("say what {} contains, after its rate: {}", source.info().name,
                                     fmt::join(source.stream_->flags(), "|")));
    }
    return source;
  }
  std::vector<std::string> known = streams;
  for (const MessageType* const type : message_types()) {
    if (!is_plain_request(*type)) continue;
    const MessageType* const answer = find_message(type->info->answers.front());
    if (answer == nullptr) continue;
    if (is_telemetry_name(message, *answer->info)) {
      if (!contents.empty()) {
        throw CommandError(fmt::format("the contents of {} cannot be chosen", answer->info->name));
      }
      source.answer_ = answer;
      source.request_ = type->make();
      return source;
    }
    const std::string name = answer->info->name;
    if (std::ranges::find(known, name) == known.end()) known.push_back(name);
  }
  throw CommandError(fmt::format(
      "no board sends '{}' by itself or when it is asked{}", clipped(message),
      detail::did_you_mean(detail::nearest(message, known),
                           "there are streams of " + detail::alternatives(streams, false, "and"))));
}

}  // namespace sbgc::tools
