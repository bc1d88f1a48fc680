// Checks the bodies of messages. The input is a direction byte (lowest bit; 1: from the board), a
// command id and the body. A decoded body is validated and must encode to the same bytes, which
// must decode again. The other bits of the first byte count the bytes at the end that are a request
// instead, which may provide the context for decoding. The results are the status, the values and
// their texts, the violations and the frames.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/text/status.hpp>
#include <sbgc/validate.hpp>

#include "core/both_paths.hpp"
#include "require.hpp"

namespace {

using sbgc::fuzz::require;

using Body = std::span<const std::uint8_t>;
using Results = std::vector<std::uint8_t>;

void add(Results& results, std::string_view text) {
  results.insert(results.end(), text.begin(), text.end());
  results.push_back('\n');
}

/// One type for all messages: each would be compiled for each of them.
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
  sbgc::for_each_leaf(message, add_leaf);
  // Every path is formatted, as a program that reports violations does.
  sbgc::validate(message, [&](const sbgc::Violation& violation) {
    std::array<char, 32> path{};
    const std::size_t size = violation.path.write(path.data(), path.size());
    require(size < path.size());
    add(results, {path.data(), size});
  });

  // For an old board, most of whose values do not exist yet.
  sbgc::validate(message, {1, 1},
                 [&](const sbgc::Violation& violation) { add(results, name(violation.rule)); });
  const M copy = message;
  static_cast<void>(copy == message);  // not so with a NaN

  std::array<std::uint8_t, sbgc::max_body_size> out{};
  const sbgc::WriteResult written = sbgc::encode(message, out);
  require(static_cast<bool>(written));
  require(std::ranges::equal(std::span(out).first(written.size), body));
  if (!body.empty()) require(!sbgc::encode(message, std::span(out).first(body.size() - 1)));

  if constexpr (requires { later_form(message); }) {
    const sbgc::WriteResult later = sbgc::encode(later_form(message), out);
    results.insert(results.end(), out.begin(), out.begin() + later.size);
  }

  M again{};
  if constexpr (requires { contexts.of(again); }) {
    require(static_cast<bool>(sbgc::decode(body, again, contexts.of(again))));
  } else {
    require(static_cast<bool>(sbgc::decode(body, again)));
  }
  for (const sbgc::Framing framing : sbgc::framings) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    const sbgc::WriteResult framed = sbgc::encode_frame(framing, again, frame);
    require(framed.size == sbgc::frame_size(framing, body.size()));
    const auto bytes = std::span(frame).first(framed.size);
    require(std::ranges::equal(bytes.subspan(sbgc::frame_header_size, body.size()), body));
    results.insert(results.end(), bytes.begin(), bytes.end());
    require(!sbgc::encode_frame(framing, again, bytes.first(bytes.size() - 1)));
  }
}

void check_body(std::uint8_t id, Body body, sbgc::Direction direction,
                const sbgc::Contexts& contexts, Results& results) {
  const auto visitor = [&](const auto& message) { check(message, body, contexts, results); };
  const sbgc::Status status = sbgc::visit_received(id, body, direction, visitor, contexts);
  require(status.field != nullptr);
  require(status.offset <= body.size());
  add(results, to_string(status));
  add(results, name(status.code));
  add(results, text(status.code));
}

/// Returns the contexts learned from `request`, decoded as every message type in turn.
sbgc::Contexts learn_from(Body request) {
  sbgc::Contexts contexts;
  sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
    M message{};
    if (sbgc::decode(request, message)) contexts.learn(message);
  });
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
