// The program of a user who needs one message as JSON.

#include <sbgc/json.hpp>
#include <sbgc/meta/realtime.hpp>

std::string write(const sbgc::msg::RealtimeData4& message) { return sbgc::to_json(message); }

bool read(std::string_view text, sbgc::msg::RealtimeData4& message) {
  return static_cast<bool>(sbgc::from_json(text, message));
}
