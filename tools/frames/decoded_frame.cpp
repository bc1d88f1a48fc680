#include "frames/decoded_frame.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <utility>
#include <vector>

#include <sbgc/explain.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text.hpp>
#include <sbgc/to_json.hpp>

#include "frames/command_lookup.hpp"
#include "frames/json_string.hpp"

namespace sbgc::tools {

namespace {

/// True if the specification has a body of this size, by the result of body_fit(); not if only
/// later firmware can have grown it.
bool is_documented(int fit) { return fit == 1 || fit > 2; }

/// The direction that a body fits best.
struct Guess {
  Direction direction{};
  bool is_certain{};
};

Guess guess(const Frame& frame) {
  const std::size_t size = frame.body.size();
  const int host = body_fit(Direction::to_board, frame.id, size);
  const int board = body_fit(Direction::from_board, frame.id, size);
  const bool host_only = !has_command(Direction::from_board, frame.id);
  const bool board_only = !has_command(Direction::to_board, frame.id);
  if (host_only || board_only) {
    return {board_only ? Direction::from_board : Direction::to_board, host_only != board_only};
  }
  if (is_documented(host) != is_documented(board)) {
    return {is_documented(host) ? Direction::to_board : Direction::from_board, true};
  }
  if (is_documented(host) && host != board) {
    // An answer of any size can have that of a request.
    return {host > board ? Direction::to_board : Direction::from_board, host < board || board != 1};
  }
  // Later firmware appends fewer bytes than make a body resemble the other direction.
  const std::size_t from_host = misfit(Direction::to_board, frame.id, size);
  const std::size_t from_board = misfit(Direction::from_board, frame.id, size);
  return {from_host < from_board ? Direction::to_board : Direction::from_board, false};
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

/// The values of a message as a C compiler aligns them in a struct that is not packed.
struct PaddedLayout {
  struct Part {
    std::size_t at{};
    std::size_t size{};
  };
  std::vector<Part> parts{};
  std::size_t size{};
  std::size_t alignment = 1;
  std::string behind{};  ///< the value before the first padding
  std::string last{};

  void operator()(const Leaf& leaf) {
    const bool is_number = leaf.kind == LeafKind::integer || leaf.kind == LeafKind::real;
    const std::size_t aligned = is_number && std::has_single_bit(leaf.size) ? leaf.size : 1;
    alignment = std::max(alignment, aligned);
    pad(aligned);
    parts.push_back({size, leaf.size});
    size += leaf.size;
    last = to_string(leaf.path);
  }
  void pad(std::size_t to) {
    const std::size_t rest = size % to;
    if (rest == 0) return;
    size += to - rest;
    if (behind.empty()) behind = last;
  }
};

/// The form of a command that is nearest to a body whose size is wrong.
struct NearestForm {
  const MessageInfo* form = nullptr;
  PaddedLayout layout{};  ///< of a form that has this size with padding; empty otherwise
  bool has_field{};       ///< a value of the form has the size of what is missing
};

NearestForm nearest_form(const Frame& frame, Direction direction) {
  NearestForm result;
  const std::size_t size = frame.body.size();
  std::size_t least = max_body_size + 1;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (Meta<M>::info.id != frame.id || !Meta<M>::info.travels(direction)) return;
    PaddedLayout layout;
    for_each_leaf(M{}, layout);
    const std::size_t missing = M::min_size - std::min(M::min_size, size);
    const std::size_t surplus = size - std::min(M::max_size, size);
    // Without ranges, which the library of the WebAssembly build lacks.
    const bool has_field =
        std::any_of(layout.parts.begin(), layout.parts.end(),
                    [missing](const PaddedLayout::Part& part) { return part.size == missing; });
    layout.pad(layout.alignment);
    const bool is_padded = M::min_size == M::max_size && surplus != 0 && layout.size == size;
    const bool is_nearer = missing + surplus < least;
    const bool has_padded = !result.layout.parts.empty();
    if (is_padded == has_padded ? !is_nearer : has_padded) return;
    least = missing + surplus;
    result = {&Meta<M>::info, is_padded ? std::move(layout) : PaddedLayout(), has_field};
  });
  return result;
}

/// Finds the flags each of which, or in pairs, announces blocks of a certain size.
template <class M>
struct BlockSearch {
  std::span<const std::uint8_t> body;
  typename M::Context context{};
  bool has_flags = false;
  bool is_known = false;  ///< the flags are
  std::vector<std::string> found{};

  void search() {
    M::Context::visit(context, [&]<class Member>(Member& member) {
      if constexpr (requires { typename Member::flag_type; }) this->search_in(member);
    });
  }

  template <class Flags>
  void search_in(Flags& flags) {
    using Flag = typename Flags::flag_type;
    has_flags = true;
    is_known = flags.raw() != 0;
    if (is_known) return;
    std::vector<std::pair<const char*, std::size_t>> blocks;
    const std::size_t base = detail::needed_size<detail::CodedAs<M>>(body, context).size;
    for (const ValueInfo& value : EnumMeta<Flag>::info.values) {
      if constexpr (detail::RepeatsContext<M>) {
        if (static_cast<Flag>(value.value) == M::Context::repeats) continue;
      }
      flags.set(static_cast<Flag>(value.value), true);
      const std::size_t size = detail::needed_size<detail::CodedAs<M>>(body, context).size - base;
      flags = {};
      if (size != 0) blocks.emplace_back(value.name, size);
    }
    for (const auto& [name, size] : blocks) {
      if (base + size == body.size()) found.emplace_back(name);
    }
    if (!found.empty()) return;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      for (std::size_t j = i + 1; j < blocks.size(); ++j) {
        if (base + blocks[i].second + blocks[j].second != body.size()) continue;
        found.push_back(std::string(blocks[i].first) + " with " + blocks[j].first);
      }
    }
  }
};

/// Says that the request, which is not known, decides what a body holds; "" if it does not.
template <class M>
std::string blocks_note(const M& message, std::span<const std::uint8_t> body,
                        const Contexts& contexts) {
  if constexpr (requires {
                  contexts.of(message);
                  message.tail.empty();
                }) {
    if (message.tail.empty()) return "";
    BlockSearch<M> search{.body = body, .context = contexts.of(message)};
    search.search();
    if (search.is_known || !search.has_flags) return "";
    std::string text = "the flags of the request decide what the tail holds";
    constexpr std::size_t most = 8;
    const std::size_t count = search.found.size();
    for (std::size_t i = 0; i < std::min(count, most); ++i) {
      text += (i == 0 ? "; its size is that of " : i + 1 == count ? " or " : ", ");
      text += search.found[i];
    }
    if (count > most) text += " or " + std::to_string(count - most) + " others";
    return text;
  }
  return "";
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

}  // namespace

DecodedFrame FrameDecoder::decode(const Frame& frame, std::optional<Direction> direction) {
  if (direction) return decode_from(frame, *direction);
  const auto [likely, is_certain] = guess(frame);
  DecodedFrame result = decode_from(frame, likely);
  result.is_guess = !is_certain;
  if (result.status) return result;
  const bool is_likely_from_host = likely == Direction::to_board;
  const int other_fit = body_fit(Direction::from_board, frame.id, frame.body.size());
  const bool may_be_other =
      is_likely_from_host ? is_documented(other_fit) : is_likely_request(frame);
  if (may_be_other) {
    result = decode_from(frame, is_likely_from_host ? Direction::from_board : Direction::to_board);
    result.is_guess = true;
    if (result.status) return result;
  }
  // Again, because each decoding overwrites the values of the one before.
  result = decode_from(frame, likely);
  result.is_guess = !is_certain;
  return result;
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
    if (decoder.wanted_.rows) {
      result.note = blocks_note(message, result.frame.body, decoder.contexts_);
    }
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
  const bool has_surplus = direction == Direction::to_board && result.message != nullptr &&
                           frame.body.size() > result.message->max_size;
  if (result.status && has_surplus) {
    const NearestForm nearest = nearest_form(frame, direction);
    if (!nearest.layout.parts.empty()) {
      result.note = "this is also the size of a C struct with padding behind " +
                    nearest.layout.behind + ": the protocol has none";
    }
  }
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
  ValueRows& rows = others_.emplace_back();
  const auto take = [&](const M& message) {
    if (wanted_.rows) {
      rows.assign(message, versions_.value_or(newest), versions_.value_or(seen_), wanted_.secrets);
      other.rows = rows.rows();
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
  if (code == Code::too_long || code == Code::unknown_form) explain_size(result);
}

void FrameDecoder::explain_size(DecodedFrame& result) {
  const Frame& frame = result.frame;
  const NearestForm nearest = nearest_form(frame, result.direction);
  if (nearest.form == nullptr) return;
  const std::size_t size = frame.body.size();
  if (result.status.code == Code::unknown_form) {
    const std::size_t wanted = std::clamp(size, nearest.form->min_size, nearest.form->max_size);
    result.explanation = detail::bytes_text(size) + "; the nearest form, " + nearest.form->name +
                         ", has " + std::to_string(wanted);
    if (nearest.layout.parts.empty() && wanted > size) {
      result.explanation += ": " + detail::bytes_text(wanted - size) + " missing";
      if (nearest.has_field) result.explanation += ", perhaps a field that was left out";
    } else if (nearest.layout.parts.empty()) {
      result.explanation += ": " + detail::bytes_text(size - wanted) + " too many";
    }
  }
  if (nearest.layout.parts.empty()) return;
  result.explanation += "; padding behind " + nearest.layout.behind +
                        ", as in a C struct that is not packed, explains the size";
  std::vector<std::uint8_t> packed;
  for (const PaddedLayout::Part& part : nearest.layout.parts) {
    const auto bytes = frame.body.subspan(part.at, part.size);
    packed.insert(packed.end(), bytes.begin(), bytes.end());
  }
  const Contexts contexts = contexts_;  // which must not learn from it
  result.rows = {};
  static_cast<void>(decode_body(packed, contexts, result));
  contexts_ = contexts;
  result.note = "without the padding:";
  result.certain = 0;  // the values are not at these places of the body
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
