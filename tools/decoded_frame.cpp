#include "decoded_frame.hpp"

#include <sbgc/meta/all.hpp>

#include "rows.hpp"

namespace sbgc::tools {

namespace {

/// How well a body of this size fits what a command says in this direction; 0 is not at all.
int fit(Direction direction, const Frame& frame) {
  int result = 0;
  const std::size_t size = frame.body.size();
  select(direction, frame.id, size, [&]<class M>(Type<M>) {
    const bool documented = size >= M::min_size && size <= M::max_size;
    if (documented && M::min_size == M::max_size) {
      result = 4;  // the only size there is
    } else if (documented && M::max_size < max_body_size) {
      result = 3;
    } else if (size > M::max_size && requires(const M& message) { message.tail; }) {
      result = 2;  // grown by later firmware
    } else if (documented) {
      result = 1;  // almost any size would do
    }
  });
  return result;
}

bool travels(const MessageInfo& info, Direction direction) {
  return info.direction == direction || info.direction == Direction::both;
}

Direction guess(const Frame& frame) {
  const int host = fit(Direction::to_board, frame);
  const int board = fit(Direction::from_board, frame);
  if (host != board) return host > board ? Direction::to_board : Direction::from_board;
  // Neither fits: whoever has such a command at all, and the board if both or none has.
  const auto knows = [&](Direction direction) {
    return select(direction, frame.id, frame.body.size(), [](auto) {}) != Code::unknown_command;
  };
  const bool host_only = knows(Direction::to_board) && !knows(Direction::from_board);
  return host_only ? Direction::to_board : Direction::from_board;
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

DecodedFrame FrameDecoder::decode(const Frame& frame, std::optional<Direction> direction) {
  DecodedFrame result{.frame = frame, .direction = direction ? *direction : guess(frame)};
  result.command = command_name(frame.id, result.direction);
  const auto take = [&]<class M>(const M& message) {
    contexts_.learn(message);
    result.fields = sbgc::to_json(message);
    result.rows = rows(message);
  };
  result.status = visit(frame, result.direction, take, contexts_);
  // What an earlier message has told may be about another stream: then better nothing than that.
  if (!result.status) {
    const Status plain = visit(frame, result.direction, take);
    if (plain) result.status = plain;
  }
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
