#include "values/message_json.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include <sbgc/message.hpp>
#include <sbgc/text.hpp>

namespace sbgc::tools {

Json initial_value(const FieldType& type) {
  switch (type.shape) {
    case FieldShape::group: return initial_fields(type.members);
    case FieldShape::axes: {
      Json result = Json::object();
      for (const char* const axis : type.axes) result[axis] = initial_value(type.members.front());
      return result;
    }
    case FieldShape::list: {
      Json result = Json::array();
      const std::size_t least = type.info == nullptr ? 0 : type.info->min_count;
      const std::size_t size = type.has_count ? type.count : least;
      for (std::size_t i = 0; i < size; ++i) {
        result.push_back(initial_value(type.members.front()));
      }
      return result;
    }
    case FieldShape::integer:
      // 64 bits are text.
      return type.size == sizeof(std::uint64_t) ? Json(std::to_string(type.initial))
                                                : Json(type.initial);
    case FieldShape::real: return 0.0;
    case FieldShape::bytes: return std::string(type.has_count ? 2 * type.count : 0, '0');
    case FieldShape::text: return "";
    case FieldShape::announced: return Json{{name(NumberType::u8), 0}};
  }
  return {};
}

Json initial_fields(const std::vector<FieldType>& members) {
  Json result = Json::object();
  for (const FieldType& member : members) {
    if (member.is_optional || member.is_counter || member.is_tail()) continue;
    result[member.name] = initial_value(member);
  }
  return result;
}

AnyMessage message_of(const MessageType& type, const Json& fields) {
  AnyMessage message = type.make();
  const JsonResult read =
      message.from_json(fields.dump(-1, ' ', false, Json::error_handler_t::replace));
  if (!read) throw JsonError(read.problem->field, read.problem->reason);
  return message;
}

Json fields_of(const AnyMessage& message) { return Json::parse(message.to_json()); }

std::vector<std::uint8_t> encoded(const AnyMessage& message, Framing framing) {
  std::vector<std::uint8_t> frame(max_frame_size);
  const WriteResult written = message.encode_frame(framing, frame);
  if (!written) {
    throw std::runtime_error(
        fmt::format("{} ({})", to_string(written.status), to_string(written.status.code)));
  }
  frame.resize(written.size);
  return frame;
}

std::string violations_of(const AnyMessage& message, const Availability& versions) {
  std::string problems;
  message.validate(versions, [&](const Violation& violation) {
    problems += (problems.empty() ? "" : "; ") + to_string(violation);
  });
  return problems;
}

}  // namespace sbgc::tools
