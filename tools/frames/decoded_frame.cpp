#include "frames/decoded_frame.hpp"

#include <algorithm>
#include <array>
#include <concepts>

#include <sbgc/detail/compiler.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text.hpp>
#include <sbgc/to_json.hpp>

#include "frames/command_lookup.hpp"
#include "frames/json_string.hpp"

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

/// True if the body is rather a request with surplus than too short a message from the board: fewer
/// bytes are wrong.
bool is_likely_request(const Frame& frame) {
  const std::size_t size = frame.body.size();
  const std::size_t surplus = size - std::min(size, largest_request(frame.id, newest));
  std::size_t missing = max_body_size + 1;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (M::direction == Direction::to_board || Meta<M>::info.id != frame.id) return;
    missing = std::min(missing, M::min_size - std::min(M::min_size, size));
  });
  return surplus < missing;
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

/// Writes objections by path; that to the whole message has the path "".
void put_objections(TextOutput& out, const DecodedFrame& decoded) {
  char separator = '{';
  const auto add = [&](std::string_view path, std::string_view objection) {
    out.put(separator);
    separator = ',';
    put_json_string(out, path);
    out.put(':');
    put_json_string(out, objection);
  };
  if (!decoded.objection.empty()) add("", decoded.objection);
  for (const Row& row : decoded.rows) {
    if (!row.objection.empty()) add(row.path.text(), row.objection);
  }
  out.put(separator == '{' ? "{}" : "}");
}

/// Writes a name, which needs no escapes, or null.
void put_name(TextOutput& out, const char* name) {
  if (*name == '\0') return out.put("null");
  out.put('"');
  out.put(name);
  out.put('"');
}

/// Writes the other messages that the body may be.
void put_others(TextOutput& out, const DecodedFrame& decoded) {
  for (const OtherReading& other : decoded.others) {
    out.put(&other == decoded.others.data() ? ",\"others\":[{\"message\":" : ",{\"message\":");
    put_name(out, other.message->name);
    out.put(",\"after\":");
    put_name(out, other.request);
    out.put(",\"fields\":");
    out.put(other.fields);
    out.put('}');
  }
  if (!decoded.others.empty()) out.put(']');
}

}  // namespace

DecodedFrame FrameDecoder::decode(const Frame& frame, std::optional<Direction> direction) {
  if (direction) return decode_from(frame, *direction);
  const Direction likely = guess(frame);
  DecodedFrame result = decode_from(frame, likely);
  if (result.status) return result;
  const bool is_likely_from_host = likely == Direction::to_board;
  if (is_likely_from_host || is_likely_request(frame)) {
    result = decode_from(frame, is_likely_from_host ? Direction::from_board : Direction::to_board);
    if (result.status) return result;
  }
  // Again, because each decoding overwrites the values of the one before.
  return decode_from(frame, likely);
}

/// Puts a decoded message into the wanted forms.
struct FrameDecoder::Taker {
  FrameDecoder& decoder;
  DecodedFrame& result;

  template <class M>
  static std::string_view json(const M& message, std::string& to, Secrets secrets) {
    to.clear();
    StringOutput out(to);
    write_json(message, static_cast<TextOutput&>(out), secrets);
    out.finish();
    return to;
  }

  template <class M>
  void operator()(const M& message) const {
    decoder.contexts_.learn(without_surplus(message));
    if constexpr (requires { versions_of(message); }) decoder.seen_ = versions_of(message);
    if (decoder.wanted_.json) {
      result.fields = json(message, decoder.json_, decoder.wanted_.secrets);
      result.values = result.fields;
      if constexpr (Meta<M>::info.has_secret()) {
        result.values = json(message, decoder.with_secrets_, Secrets::shown);
      }
    }
    if (decoder.wanted_.rows || decoder.versions_) {
      decoder.rows_.assign(message, decoder.versions_.value_or(newest),
                           decoder.versions_.value_or(decoder.seen_), decoder.wanted_.secrets);
      result.rows = decoder.rows_.rows();
    }
  }
};

DecodedFrame FrameDecoder::decode_from(const Frame& frame, Direction direction) {
  DecodedFrame result{.frame = frame, .direction = direction, .secrets = wanted_.secrets};
  result.command = command_name(frame.id, result.direction);
  result.status = decode_body(frame.body, contexts_, result);
  result.error_field = result.status.field;
  others_.clear();
  const auto use = [&]<class M>(Type<M>) {
    result.message = &Meta<M>::info;
    result.is_for_firmware = versions_.has_value();
    if (versions_) result.objection = objection_to(Meta<M>::info, *versions_);
    if (result.status.code == Code::too_short && result.error_field.empty()) {
      result.error_field = field_at<M>(result.status.offset);
    }
    if constexpr (detail::IsAsked<M>) {
      if (!result.status || contexts_.*OtherForms<M>::asked != Form::only) return;
      OtherForms<M>::Types::for_each([&]<class Other>(Type<Other>) { add_other<Other>(result); });
    }
  };
  select_received(result.direction, frame.id, frame.body.size(), use, contexts_);
  if (!result.status) describe_error(result);
  return result;
}

template <class M>
void FrameDecoder::add_other(DecodedFrame& result) {
  OtherReading other{.message = &Meta<M>::info};
  AllMessages::for_each([&]<class Request>(Type<Request>) {
    if constexpr (requires { requires std::same_as<typename Request::Response, M>; }) {
      other.request = Meta<Request>::info.name;
    }
  });
  Values& values = others_.emplace_back();
  const auto take = [&](const M& message) {
    if (wanted_.json) other.fields = Taker::json(message, values.json, wanted_.secrets);
    if (wanted_.rows) {
      values.rows.assign(message, versions_.value_or(newest), versions_.value_or(seen_),
                         wanted_.secrets);
      other.rows = values.rows.rows();
    }
  };
  const std::span<const std::uint8_t> body = result.frame.body;
  if (detail::decode_and_call<M>(body.data(), body.size(), take, contexts_)) {
    result.others.push_back(other);
  }
}

void FrameDecoder::describe_error(DecodedFrame& result) {
  const auto& [id, body, offset, framing] = result.frame;
  const detail::NeededSize needed = detail::needed_size(result.direction, id, body, contexts_);
  result.explanation = detail::size_text(result.status, body.size(), needed);
  if (result.explanation.empty()) result.explanation = text(result.status.code);
  // It is not certain which of the members that flags announce is missing.
  const std::size_t fixed = needed.depends_on_flags ? result.message->min_size : max_body_size;
  result.certain = std::min(body.size(), fixed);
  const Code code = result.status.code;
  if (code == Code::too_short || code == Code::unknown_form) decode_arrived(result);
}

// Not inlined: it contains the decoders of all messages.
SBGC_NOINLINE Status FrameDecoder::decode_body(std::span<const std::uint8_t> body,
                                               const Contexts& contexts, DecodedFrame& result) {
  return visit_received(result.frame.id, body, result.direction, Taker{*this, result}, contexts);
}

void FrameDecoder::decode_arrived(DecodedFrame& result) {
  const std::size_t arrived = result.frame.body.size();
  const Contexts contexts = contexts_;  // which must not learn from missing bytes
  std::array<std::uint8_t, max_body_size> padded{};
  std::copy(result.frame.body.begin(), result.frame.body.end(), padded.begin());
  // The rest is taken as zeros, as many as the message needs, or the next longer form of it.
  Status status{Code::too_short};
  for (std::size_t size = arrived + 1; !status && size <= padded.size(); ++size) {
    status = decode_body(std::span(padded).first(size), contexts, result);
  }
  contexts_ = contexts;
  const auto is_missing = [&](const Row& row) { return row.offset + row.size > result.certain; };
  const auto end = std::find_if(result.rows.begin(), result.rows.end(), is_missing);
  result.rows = result.rows.first(static_cast<std::size_t>(end - result.rows.begin()));
}

bool DecodedFrame::hides_body() const {
  if (status || secrets == Secrets::shown || message == nullptr) return false;
  if (frame.body.size() <= message->secret_from) return false;
  const auto text = frame.body.subspan(message->secret_from + 1);  // after its length
  return detail::is_evident_text(text.data(), text.size());
}

void put_body(TextOutput& out, const DecodedFrame& decoded) {
  if (decoded.hides_body()) return out.put(hidden_text);
  out.put_hex(decoded.frame.body);
}

void put_json(TextOutput& out, const DecodedFrame& decoded, const CapturePlace* place,
              std::string_view more) {
  const Frame& frame = decoded.frame;
  out.put("{\"offset\":");
  out.put(frame.offset);
  out.put(",\"command\":");
  put_name(out, decoded.command);
  out.put(",\"id\":");
  out.put(frame.id);
  out.put(",\"message\":");
  put_name(out, decoded.message == nullptr ? "" : decoded.message->name);
  out.put(",\"direction\":");
  put_name(out, decoded.direction == Direction::from_board ? "from_board" : "to_board");
  out.put(",\"framing\":");
  put_name(out, to_string(frame.framing));
  if (decoded.status) {
    out.put(",\"fields\":");
    out.put(decoded.fields);
    put_others(out, decoded);
    if (decoded.is_for_firmware) {
      out.put(",\"objections\":");
      put_objections(out, decoded);
    }
  } else {
    out.put(R"(,"error":{"code":)");
    put_name(out, name(decoded.status.code));
    out.put(",\"field\":");
    put_json_string(out, decoded.error_field);
    out.put(",\"offset\":");
    out.put(decoded.status.offset);
    out.put(R"(},"body":")");
    put_body(out, decoded);
    out.put('"');
  }
  if (place != nullptr) {
    out.put(",\"time\":");
    detail::put_real(out, place->time);
    out.put(",\"session\":");
    out.put(place->session);
  }
  out.put(more);
  out.put('}');
}

}  // namespace sbgc::tools
