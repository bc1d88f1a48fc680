#include "values/message_type.hpp"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include <sbgc/dispatch.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text.hpp>

namespace sbgc::tools {

namespace {

template <class M>
M read_fields(const Json& fields) {
  M message{};
  from_dom(fields, message);
  return message;
}

using Report = std::function<void(const Violation&)>;
using UseLeaf = std::function<void(const Leaf&)>;

/// One type for all messages: each would be compiled for each of them.
struct LeafCaller {
  const UseLeaf& use;

  void operator()(const Leaf& leaf) { use(leaf); }
};

template <class M>
MessageType type_of_message() {
  using Fields = Received<M>;
  return {
      .info = &Meta<M>::info,
      .fields = []() -> const std::vector<FieldType>& {
        static const std::vector<FieldType> fields = field_types<Fields>();
        return fields;
      },
      .validate =
          [](const Json& fields, const Availability& versions, const Report& report) {
            validate(read_fields<Fields>(fields), versions, report);
          },
      .for_each_value =
          [](const Json& fields, const UseLeaf& use) {
            LeafCaller call{use};
            for_each_leaf(read_fields<Fields>(fields), call);
          },
      .encode =
          [](const Json& fields, Framing framing, std::span<std::uint8_t> out) {
            return encode_frame(framing, read_fields<Fields>(fields), out);
          },
  };
}

}  // namespace

const std::vector<MessageType>& message_types() {
  static const std::vector<MessageType> types = [] {
    std::vector<MessageType> result;
    AllMessages::for_each([&]<class M>(Type<M>) { result.push_back(type_of_message<M>()); });
    return result;
  }();
  return types;
}

const MessageType* find_message(std::string_view name) {
  const auto& all = message_types();
  const auto found = std::ranges::find(
      all, name, [](const MessageType& type) { return std::string_view(type.info->name); });
  return found != all.end() ? &*found : nullptr;
}

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
    case FieldShape::real: return Json(0.0);
    case FieldShape::bytes: return Json(std::string(type.has_count ? 2 * type.count : 0, '0'));
    case FieldShape::text: return Json("");
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

std::vector<std::uint8_t> encoded(const MessageType& message, const Json& fields, Framing framing) {
  std::vector<std::uint8_t> frame(max_frame_size);
  const WriteResult written = message.encode(fields, framing, frame);
  if (!written) {
    throw std::runtime_error(
        fmt::format("{} ({})", to_string(written.status), to_string(written.status.code)));
  }
  frame.resize(written.size);
  return frame;
}

std::string violations_of(const MessageType& message, const Json& fields,
                          const Availability& versions) {
  std::string problems;
  message.validate(fields, versions, [&](const Violation& violation) {
    problems += (problems.empty() ? "" : "; ") + to_string(violation);
  });
  return problems;
}

}  // namespace sbgc::tools
