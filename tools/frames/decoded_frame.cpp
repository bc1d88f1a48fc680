#include "frames/decoded_frame.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/explain.hpp>
#include <sbgc/json/text_sink.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>

#include "frames/command_lookup.hpp"
#include "frames/json_string.hpp"

namespace sbgc::tools {

namespace {

/// True if body_fit() says that the specification has a body of this size, not counting sizes that
/// only later firmware can have extended.
bool is_documented(int fit) { return fit == 1 || fit > 2; }

/// The direction that fits a body best.
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
    // An answer of variable size can have the size of a request.
    return {host > board ? Direction::to_board : Direction::from_board, host < board || board != 1};
  }
  // Later firmware appends fewer bytes than it takes to resemble the other direction.
  const std::size_t from_host = misfit(Direction::to_board, frame.id, size);
  const std::size_t from_board = misfit(Direction::from_board, frame.id, size);
  return {from_host < from_board ? Direction::to_board : Direction::from_board, false};
}

/// True if the body is more likely a request with surplus than a truncated message from the board:
/// fewer bytes are wrong.
bool is_likely_request(const Frame& frame) {
  const std::size_t size = frame.body.size();
  const std::size_t surplus = size - std::min(size, largest_request(frame.id, newest));
  std::size_t missing = max_body_size + 1;
  for (const MessageType* const form : forms(Direction::from_board, frame.id)) {
    const std::size_t least = form->info->min_size;
    missing = std::min(missing, least - std::min(least, size));
  }
  return surplus < missing;
}

/// Returns the member that contains the byte at `offset` of the body.
std::string field_at(const MessageType& type, std::size_t offset) {
  std::string result;
  type.make().for_each_leaf([&](const Leaf& leaf) {
    if (offset < leaf.offset || offset >= leaf.offset + leaf.size) return;
    const FieldPath* member = &leaf.path;
    while (member->parent != nullptr) member = member->parent;
    result = member->name;
  });
  return result;
}

/// The values of a message as a C compiler aligns them in an unpacked struct.
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

/// The form of a command whose size is nearest to that of a body.
struct NearestForm {
  const MessageInfo* form = nullptr;
  PaddedLayout layout{};  ///< of a form that has this size with padding; empty otherwise
  bool has_field{};       ///< a value of the form has the size of the missing bytes
};

NearestForm nearest_form(const Frame& frame, Direction direction) {
  NearestForm result;
  const std::size_t size = frame.body.size();
  std::size_t least = max_body_size + 1;
  for (const MessageType* const form : forms(direction, frame.id)) {
    const MessageInfo& info = *form->info;
    PaddedLayout layout;
    form->make().for_each_leaf(layout);
    const std::size_t missing = info.min_size - std::min(info.min_size, size);
    const std::size_t surplus = size - std::min(info.max_size, size);
    // Without ranges, which the library of the WebAssembly build lacks.
    const bool has_field =
        std::any_of(layout.parts.begin(), layout.parts.end(),
                    [missing](const PaddedLayout::Part& part) { return part.size == missing; });
    layout.pad(layout.alignment);
    const bool is_padded = info.min_size == info.max_size && surplus != 0 && layout.size == size;
    const bool is_nearer = missing + surplus < least;
    const bool has_padded = !result.layout.parts.empty();
    if (is_padded == has_padded ? !is_nearer : has_padded) continue;
    least = missing + surplus;
    result = {&info, is_padded ? std::move(layout) : PaddedLayout(), has_field};
  }
  return result;
}

/// Finds the flags that, alone or in pairs, announce blocks of a certain size.
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

template <class M>
std::string blocks_note(const M& message, std::span<const std::uint8_t> body,
                        const Contexts& contexts) {
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

/// Returns a note if the content of a body depends on an unknown request; "" otherwise.
std::string blocks_note(const AnyMessage& message, std::span<const std::uint8_t> body,
                        const Contexts& contexts) {
  std::string note;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (requires(const M& typed) {
                    contexts.of(typed);
                    typed.tail.empty();
                  }) {
      if (const M* const typed = message.get_if<M>()) note = blocks_note(*typed, body, contexts);
    }
  });
  return note;
}

/// Writes objections by path; the one about the whole message has the path "".
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

std::string_view json(const AnyMessage& message, std::string& to, Secrets secrets) {
  to.clear();
  StringOutput out(to);
  message.write_json(out, secrets);
  out.finish();
  return to;
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
  // Again, because each decoding overwrites the previous values.
  result = decode_from(frame, likely);
  result.is_guess = !is_certain;
  return result;
}

void FrameDecoder::take(const AnyMessage& message, DecodedFrame& result) {
  if (wanted_.rows) result.note = blocks_note(message, result.frame.body, contexts_);
  message.teach(contexts_);
  if (const auto* const info = message.get_if<roles::Introduction>()) seen_ = versions_of(*info);
  if (wanted_.json) {
    result.fields = json(message, json_, wanted_.secrets);
    result.values = result.fields;
    if (message.type().info->has_secret()) {
      result.values = json(message, with_secrets_, Secrets::shown);
    }
  }
  if (wanted_.rows || versions_) {
    rows_.assign(message, versions_.value_or(newest), versions_.value_or(seen_), wanted_.secrets);
    result.rows = rows_.rows();
  }
}

DecodedFrame FrameDecoder::decode_from(const Frame& frame, Direction direction) {
  DecodedFrame result{.frame = frame, .direction = direction, .secrets = wanted_.secrets};
  result.command = command_name(frame.id, direction);
  const MessageType* const type = find_message(direction, frame.id, frame.body.size(), contexts_);
  result.status = decode_body(frame.body, contexts_, result);
  result.error_field = result.status.field;
  others_.clear();
  if (type != nullptr) {
    result.message = type->info;
    result.is_for_firmware = versions_.has_value();
    if (versions_) result.objection = objection_to(*type->info, *versions_);
    if (result.status.code == Code::too_short && result.error_field.empty()) {
      result.error_field = field_at(*type, result.status.offset);
    }
    if (result.status) add_others(result);
  }
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

void FrameDecoder::add_others(DecodedFrame& result) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (detail::IsAsked<M>) {
      if (&Meta<M>::info != result.message) return;
      if (contexts_.*OtherForms<M>::asked != Form::only) return;
      OtherForms<M>::Types::for_each(
          [&]<class Other>(Type<Other>) { add_other(detail::message_type<Other>(), result); });
    }
  });
}

void FrameDecoder::add_other(const MessageType& type, DecodedFrame& result) {
  AnyMessage message = type.make();
  if (!message.decode(result.frame.body, contexts_)) return;
  OtherReading& other = result.others.emplace_back(OtherReading{.message = type.info});
  for (const MessageType* const request : message_types()) {
    for (const std::string_view answer : request->info->answers) {
      if (answer == type.info->name) other.request = request->info->name;
    }
  }
  ValueRows& rows = others_.emplace_back();
  if (!wanted_.rows) return;
  rows.assign(message, versions_.value_or(newest), versions_.value_or(seen_), wanted_.secrets);
  other.rows = rows.rows();
}

void FrameDecoder::describe_error(DecodedFrame& result) {
  const auto& [id, body, offset, framing] = result.frame;
  const detail::NeededSize needed = detail::needed_size(result.direction, id, body, contexts_);
  result.explanation = detail::size_text(result.status, body.size(), needed);
  if (result.explanation.empty()) result.explanation = text(result.status.code);
  // It is uncertain which of the announced members is missing.
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

Status FrameDecoder::decode_body(std::span<const std::uint8_t> body, const Contexts& contexts,
                                 DecodedFrame& result) {
  const std::uint8_t id = result.frame.id;
  const MessageType* const type = find_message(result.direction, id, body.size(), contexts);
  if (type == nullptr) {
    return {has_command(result.direction, id) ? Code::unknown_form : Code::unknown_command};
  }
  AnyMessage message = type->make();
  const Status status = message.decode(body, contexts);
  if (status) take(message, result);
  return status;
}

void FrameDecoder::decode_arrived(DecodedFrame& result) {
  const std::size_t arrived = result.frame.body.size();
  const Contexts contexts = contexts_;  // which must not learn from missing bytes
  std::array<std::uint8_t, max_body_size> padded{};
  std::copy(result.frame.body.begin(), result.frame.body.end(), padded.begin());
  // The rest is filled with as many zeros as the message needs, or the next longer form of it.
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
