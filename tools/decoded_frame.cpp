#include "decoded_frame.hpp"

#include <sbgc/meta/all.hpp>

#include "rows.hpp"

namespace sbgc::tools {

namespace {

bool travels(const MessageInfo& info, Direction direction) {
  return info.direction == direction || info.direction == Direction::both;
}

Direction guess(const Frame& frame) {
  const int host = fit(Direction::to_board, frame.id, frame.body.size());
  const int board = fit(Direction::from_board, frame.id, frame.body.size());
  if (host != board) return host > board ? Direction::to_board : Direction::from_board;
  // Neither fits: whoever has such a command at all, and the board if both or none has.
  const bool host_only =
      has_command(Direction::to_board, frame.id) && !has_command(Direction::from_board, frame.id);
  return host_only ? Direction::to_board : Direction::from_board;
}

/// Looks for the fixed-size member that a byte of the body belongs to.
struct FieldFinder {
  std::size_t wanted{};
  std::size_t& at;
  const char*& found;

  template <class T>
  void operator()(const FieldInfo& field, const T&) const {
    step(wire_size<T>, field.name);
  }
  void step(std::size_t size, const char* name) const {
    at += size;
    if (*found == '\0' && at > wanted) found = name;
  }
};

/// The path of the fixed-size member that byte `offset` of the body belongs to.
template <class M>
std::string field_at(std::size_t offset) {
  std::size_t at = 0;
  const char* result = "";
  const M message{};
  Meta<M>::visit(message, FieldFinder{offset, at, result});
  return result;
}

}  // namespace

int fit(Direction direction, std::uint8_t id, std::size_t size) {
  int result = 0;
  select(direction, id, size, [&]<class M>(Type<M>) {
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

bool has_command(Direction direction, std::uint8_t id) {
  return select(direction, id, 0, [](auto) {}) != Code::unknown_command;
}

std::string command_name(std::uint8_t id, Direction direction) {
  std::string result;
  AllMessages::for_each([&]<class M>(Type<M>) {
    const MessageInfo& info = Meta<M>::info;
    if (info.id == id && travels(info, direction)) result = info.command;
  });
  // Else what has the id in the other direction.
  const auto look_in = [&](std::span<const ValueInfo> commands) {
    for (const ValueInfo& command : commands) {
      if (result.empty() && command.value == id) result = command.name;
    }
  };
  look_in(EnumMeta<msg::CommandFromBoard>::values);
  look_in(EnumMeta<msg::CommandToBoard>::values);
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
