#include "decoded_frame.hpp"

#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

#include "command_lookup.hpp"

namespace sbgc::tools {

namespace {

Direction guess(const Frame& frame) {
  const int host = body_fit(Direction::to_board, frame.id, frame.body.size());
  const int board = body_fit(Direction::from_board, frame.id, frame.body.size());
  if (host != board) return host > board ? Direction::to_board : Direction::from_board;
  // Neither fits better: use the only direction that has such a command, or else the board.
  const bool host_only =
      has_command(Direction::to_board, frame.id) && !has_command(Direction::from_board, frame.id);
  return host_only ? Direction::to_board : Direction::from_board;
}

/// Finds the fixed-size member that contains a byte of the body.
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

/// Returns the path of the fixed-size member that contains the byte at `offset` of the body.
template <class M>
std::string field_at(std::size_t offset) {
  std::size_t at = 0;
  const char* result = "";
  const M message{};
  Meta<M>::visit(message, FieldFinder{offset, at, result});
  return result;
}

/// Creates a row for each value, and adds violations of the specification to the rows.
struct RowCollector {
  std::vector<Row>& rows;

  void operator()(const Leaf& leaf) const {
    if (is_unused(leaf)) return;
    rows.push_back({.path = to_string(leaf.path),
                    .raw = raw_text(leaf),
                    .meaning = meaning_text(leaf),
                    .objection = {},
                    .offset = leaf.offset,
                    .size = leaf.size});
  }
  void operator()(const Violation& violation) const {
    const std::string path = to_string(violation.path);
    for (Row& row : rows) {
      if (row.path != path) continue;
      if (!row.objection.empty()) row.objection += ", ";
      if (violation.named != nullptr) row.objection += violation.named->name + std::string(" ");
      row.objection += violation_text(violation);
    }
  }
};

/// Returns why a board with these versions does not know the message, or "".
std::string objection_to(const MessageInfo& info, const Availability& versions) {
  const auto firmware = [](std::uint16_t version) {
    return to_string(msg::FirmwareVersion(version));
  };
  if (info.until.firmware != 0 && info.until.firmware <= versions.firmware) {
    return "needs firmware before " + firmware(info.until.firmware);
  }
  return info.since.firmware > versions.firmware ? "needs firmware " + firmware(info.since.firmware)
                                                 : std::string();
}

/// Returns objections by path; that to the whole message has the path "".
Json objections_of(const DecodedFrame& decoded) {
  Json result = Json::object();
  if (!decoded.objection.empty()) result[""] = decoded.objection;
  for (const Row& row : decoded.rows) {
    if (!row.objection.empty()) result[row.path] = row.objection;
  }
  return result;
}

}  // namespace

DecodedFrame FrameDecoder::decode(const Frame& frame, std::optional<Direction> direction) {
  if (direction) return decode_from(frame, *direction);
  const Direction likely = guess(frame);
  DecodedFrame result = decode_from(frame, likely);
  if (result.status) return result;
  DecodedFrame other = decode_from(
      frame, likely == Direction::to_board ? Direction::from_board : Direction::to_board);
  return other.status ? other : result;
}

DecodedFrame FrameDecoder::decode_from(const Frame& frame, Direction direction) {
  DecodedFrame result{.frame = frame, .direction = direction};
  result.command = command_name(frame.id, result.direction);
  const auto take = [&]<class M>(const M& message) {
    contexts_.learn(message);
    result.fields = sbgc::to_json(message);
    for_each_leaf(message, RowCollector{result.rows});
    validate(message, versions_.value_or(newest), RowCollector{result.rows});
  };
  result.status = visit(frame, result.direction, take, contexts_);
  // The context may belong to another stream, so retry without context: no data is better than
  // wrong data.
  if (!result.status) {
    const Status plain = visit(frame, result.direction, take);
    if (plain) result.status = plain;
  }
  result.error_field = result.status.field;
  select(result.direction, frame.id, frame.body.size(), [&]<class M>(Type<M>) {
    result.message = &Meta<M>::info;
    result.is_for_firmware = versions_.has_value();
    if (versions_) result.objection = objection_to(Meta<M>::info, *versions_);
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
  result["framing"] = to_string(frame.framing);
  if (status) {
    result["fields"] = fields;
    if (is_for_firmware) result["objections"] = objections_of(*this);
  } else {
    result["error"] = {
        {"code", name(status.code)}, {"field", error_field}, {"offset", status.offset}};
    result["body"] = detail::to_hex(frame.body);
  }
  return result;
}

}  // namespace sbgc::tools
