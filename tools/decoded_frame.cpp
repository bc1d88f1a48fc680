#include "decoded_frame.hpp"

#include <sbgc/meta/all.hpp>

#include "rows.hpp"

namespace sbgc::tools {

namespace {

const MessageInfo* find_message(Direction direction, const Frame& frame) {
  const MessageInfo* info = nullptr;
  select(direction, frame.id, frame.body.size(), [&]<class M>(Type<M>) { info = &Meta<M>::info; });
  return info;
}

bool travels(const MessageInfo& info, Direction direction) {
  return info.direction == direction || info.direction == Direction::both;
}

bool fits(const MessageInfo* info, const Frame& frame) {
  return info != nullptr && frame.body.size() >= info->min_size &&
         frame.body.size() <= info->max_size;
}

bool has_fixed_size(const MessageInfo* info) { return info->min_size == info->max_size; }

// Boards append bytes, hosts do not, and a body that has the only size a message can have says more
// than one that lies in a range.
Direction guess(const Frame& frame) {
  const MessageInfo* const to_board = find_message(Direction::to_board, frame);
  const MessageInfo* const from_board = find_message(Direction::from_board, frame);
  const bool host = fits(to_board, frame);
  const bool board = fits(from_board, frame);
  if (host && board) {
    const bool surely_host = has_fixed_size(to_board) && !has_fixed_size(from_board);
    return surely_host ? Direction::to_board : Direction::from_board;
  }
  if (host || board) return host ? Direction::to_board : Direction::from_board;
  return from_board == nullptr && to_board != nullptr ? Direction::to_board : Direction::from_board;
}

/// The path of the fixed-size member that byte `offset` of the body belongs to.
template <class M>
std::string field_at(std::size_t offset) {
  std::string result;
  std::size_t at = 0;
  const M message{};
  Meta<M>::visit(message, [&](const FieldInfo& field, const auto& member) {
    using T = std::remove_cvref_t<decltype(member)>;
    at += wire_size<T>;
    if (result.empty() && at > offset) result = field.name;
  });
  return result;
}

}  // namespace

std::string command_name(std::uint8_t id, Direction direction) {
  std::string result;
  AllMessages::for_each([&]<class M>(Type<M>) {
    const MessageInfo& info = Meta<M>::info;
    if (info.id == id && travels(info, direction)) result = info.command;
  });
  for (const ValueInfo& value : EnumMeta<CommandId>::values) {
    if (result.empty() && value.value == id) result = value.name;
  }
  return result;
}

DecodedFrame FrameDecoder::decode(const Frame& frame) {
  DecodedFrame result{.frame = frame, .direction = direction_.value_or(guess(frame))};
  result.command = command_name(frame.id, result.direction);
  const auto take = [&]<class M>(const M& message) {
    contexts_.learn(message);
    result.fields = sbgc::to_json(message);
    result.rows = rows(message);
  };
  result.status = visit(frame, result.direction, take, contexts_);
  result.error_field = result.status.field;
  select(result.direction, frame.id, frame.body.size(), [&]<class M>(Type<M>) {
    result.message = &Meta<M>::info;
    if (result.status.code == Code::too_short && result.error_field.empty()) {
      result.error_field = field_at<M>(result.status.offset);
    }
  });
  return result;
}

Json DecodedFrame::to_json() const {
  Json result;
  result["offset"] = frame.offset;
  result["command"] = command.empty() ? Json() : Json(command);
  result["id"] = frame.id;
  result["message"] = message == nullptr ? Json() : Json(message->name);
  result["direction"] = direction == Direction::from_board ? "from_board" : "to_board";
  if (status) {
    result["fields"] = fields;
  } else {
    result["error"] = {
        {"code", name(status.code)}, {"field", error_field}, {"offset", status.offset}};
    result["body"] = detail::to_hex(frame.body);
  }
  return result;
}

}  // namespace sbgc::tools
