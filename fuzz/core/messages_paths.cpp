// Checks the bodies of messages. The input is a direction byte (lowest bit; 1: from the board), a
// command id and the body. A decoded body is validated and must encode to the same bytes, which
// must decode again. The other bits of the first byte count the bytes at the end that are a request
// instead, which may provide the context for decoding. The results are the status, the values and
// their texts, the violations and the frames. At run time, a message has a type that is known only
// then: these are the functions that the library has compiled for each message.

#ifndef SBGC_AS_CONSTANT
#include <sbgc/any.hpp>
#endif
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/text/status.hpp>
#include <sbgc/validate.hpp>

#include "core/both_paths.hpp"
#include "input.hpp"

namespace {

using sbgc::fuzz::require;

using Body = std::span<const std::uint8_t>;
using Results = std::vector<std::uint8_t>;

void add(Results& results, std::string_view text) {
  results.insert(results.end(), text.begin(), text.end());
  results.push_back('\n');
}

#ifdef SBGC_AS_CONSTANT

/// Does the same as AnyMessage.
template <class M>
struct Typed {
  M message{};

  sbgc::Status decode(Body body, const sbgc::Contexts& contexts) {
    if constexpr (requires { contexts.of(message); }) {
      return sbgc::decode(body, message, contexts.of(message));
    } else {
      return sbgc::decode(body, message);
    }
  }
  sbgc::WriteResult encode(std::span<std::uint8_t> out) const { return sbgc::encode(message, out); }
  sbgc::WriteResult encode_frame(sbgc::Framing framing, std::span<std::uint8_t> out) const {
    return sbgc::encode_frame(framing, message, out);
  }
  template <class Use>
  void for_each_leaf(Use& use) const {
    sbgc::for_each_leaf(message, use);
  }
  template <class Report>
  bool validate(const sbgc::Availability& versions, const Report& report) const {
    return sbgc::validate(message, versions, report);
  }
  bool operator==(const Typed&) const = default;
};

template <class M>
Typed<M> make_another(const Typed<M>& /*message*/) {
  return {};
}

/// Calls `use` with the form for later firmware, if there is one.
template <class M, class Use>
void with_later_form(const Typed<M>& message, const Use& use) {
  if constexpr (requires { later_form(message.message); }) use(later_form(message.message));
}

/// Calls `use` with the message, if it decodes.
template <class Use>
sbgc::Status visit(std::uint8_t id, Body body, sbgc::Direction direction,
                   const sbgc::Contexts& contexts, const Use& use) {
  return sbgc::visit_received(
      id, body, direction, [&]<class M>(const M& message) { use(Typed<M>{message}); }, contexts);
}

void learn(sbgc::Contexts& contexts, Body request) {
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    Typed<sbgc::Received<M>> message;
    if (message.decode(request, {})) contexts.learn(sbgc::without_surplus(message.message));
  });
}

#else

sbgc::AnyMessage make_another(const sbgc::AnyMessage& message) { return message.type().make(); }

template <class Use>
void with_later_form(const sbgc::AnyMessage& message, const Use& use) {
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    if constexpr (requires(const M& typed) { later_form(typed); }) {
      if (const M* const typed = message.get_if<M>()) use(later_form(*typed));
    }
  });
}

template <class Use>
sbgc::Status visit(std::uint8_t id, Body body, sbgc::Direction direction,
                   const sbgc::Contexts& contexts, const Use& use) {
  const sbgc::MessageType* const type = sbgc::find_message(direction, id, body.size());
  if (type == nullptr) return {sbgc::select_received(direction, id, body.size(), [](auto) {})};
  sbgc::AnyMessage message = type->make();
  const sbgc::Status status = message.decode(body, contexts);
  if (status) use(message);
  return status;
}

void learn(sbgc::Contexts& contexts, Body request) {
  for (const sbgc::MessageType* const type : sbgc::message_types()) {
    sbgc::AnyMessage message = type->make();
    if (message.decode(request)) message.teach(contexts);
  }
}

#endif

/// A single type for all messages: otherwise, each would be compiled for each of them.
struct LeafText {
  Results& results;

  void operator()(const sbgc::Leaf& leaf) const {
    add(results, sbgc::raw_text(leaf));
    add(results, sbgc::meaning_text(leaf));
  }
};

template <class M>
void check(const M& message, Body body, const sbgc::Contexts& contexts, Results& results) {
  LeafText add_leaf{results};
  message.for_each_leaf(add_leaf);
  // Every path is formatted, as a program that reports violations does.
  message.validate(sbgc::newest, [&](const sbgc::Violation& violation) {
    std::array<char, 32> path{};
    const std::size_t size = violation.path.write(path.data(), path.size());
    require(size < path.size());
    add(results, {path.data(), size});
  });

  // For an old board, most of whose values do not exist yet.
  message.validate({1, 1},
                   [&](const sbgc::Violation& violation) { add(results, name(violation.rule)); });
  const M copy = message;
  static_cast<void>(copy == message);  // not so with a NaN

  std::array<std::uint8_t, sbgc::max_body_size> out{};
  const sbgc::WriteResult written = message.encode(out);
  require(static_cast<bool>(written));
  require(std::ranges::equal(std::span(out).first(written.size), body));
  if (!body.empty()) require(!message.encode(std::span(out).first(body.size() - 1)));

  with_later_form(message, [&](const auto& form) {
    const sbgc::WriteResult later = sbgc::encode(form, out);
    results.insert(results.end(), out.begin(), out.begin() + later.size);
  });

  M again = make_another(message);
  require(static_cast<bool>(again.decode(body, contexts)));
  for (const sbgc::Framing framing : sbgc::framings) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    const sbgc::WriteResult framed = again.encode_frame(framing, frame);
    require(framed.size == sbgc::frame_size(framing, body.size()));
    const auto bytes = std::span(frame).first(framed.size);
    require(std::ranges::equal(bytes.subspan(sbgc::frame_header_size, body.size()), body));
    results.insert(results.end(), bytes.begin(), bytes.end());
    require(!again.encode_frame(framing, bytes.first(bytes.size() - 1)));
  }
}

void check_body(std::uint8_t id, Body body, sbgc::Direction direction,
                const sbgc::Contexts& contexts, Results& results) {
  const sbgc::Status status = visit(id, body, direction, contexts, [&](const auto& message) {
    check(message, body, contexts, results);
  });
  require(status.field != nullptr);
  require(status.offset <= body.size());
  add(results, to_string(status));
  add(results, name(status.code));
  add(results, text(status.code));
}

/// Returns the contexts learned from `request`, decoded as every message type in turn.
sbgc::Contexts learn_from(Body request) {
  sbgc::Contexts contexts;
  learn(contexts, request);
  return contexts;
}

}  // namespace

Results SBGC_FUZZ_RESULTS(std::span<const std::uint8_t> input) {
  Results results;
  if (input.size() < 2 || input.size() > 2 + 2 * sbgc::max_body_size) return results;
  const bool from_board = input[0] % 2 != 0;
  const auto direction = from_board ? sbgc::Direction::from_board : sbgc::Direction::to_board;
  const std::uint8_t id = input[1];
  const Body body = input.subspan(2, std::min(input.size() - 2, sbgc::max_body_size));
  check_body(id, body, direction, {}, results);

  const std::size_t request_size = std::min<std::size_t>(input[0] / 2, body.size());
  if (request_size == 0) return results;
  check_body(id, body.first(body.size() - request_size), direction,
             learn_from(body.last(request_size)), results);
  return results;
}
