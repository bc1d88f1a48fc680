#include "values/complete_message.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace sbgc::tools {

AnyMessage new_message(const MessageType& type) {
  AnyMessage message = type.make();
  for (const FieldType& field : type.fields()) {
    if (field.has_count || field.is_optional || field.info->min_count == 0) continue;
    const std::size_t least = field.info->min_count;
    const std::string name = field.name;
    if (field.shape == FieldShape::list) message.add(name + '[' + std::to_string(least - 1) + ']');
    if (field.shape == FieldShape::bytes) {
      message.assign(name, std::string(2 * least, '0'), false);
    }
  }
  return message;
}

void add_demanded(AnyMessage& message) {
  std::array<std::uint8_t, max_body_size> body{};
  for (;;) {
    const WriteResult written = message.encode(body);
    if (written.status.code != Code::presence_mismatch) return;
    // If the field is present, it should not be.
    if (message.has(written.status.field) || !message.add(written.status.field)) return;
  }
}

}  // namespace sbgc::tools
