// Fuzzes the bodies of messages. The input is a direction byte (lowest bit; 1: from the board), a
// command id and the body. A decoded body is validated and must encode to the same bytes, which
// must decode again. The other bits of the first byte count the bytes at the end that are a request
// instead, which may provide the context for decoding.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

namespace {

using Body = std::span<const std::uint8_t>;

void require(bool condition) {
  if (!condition) std::abort();
}

template <class M>
void check(const M& message, Body body, const sbgc::Contexts& contexts) {
  // Every path is formatted, as a program that reports violations does.
  sbgc::validate(message, [](const sbgc::Violation& violation) {
    std::array<char, 32> path{};
    require(violation.path.write(path.data(), path.size()) < path.size());
  });

  std::array<std::uint8_t, sbgc::max_body_size> out{};
  const sbgc::WriteResult written = sbgc::encode(message, out);
  require(static_cast<bool>(written));
  require(std::ranges::equal(std::span(out).first(written.size), body));
  if (!body.empty()) require(!sbgc::encode(message, std::span(out).first(body.size() - 1)));

  M again{};
  if constexpr (requires { contexts.of(again); }) {
    require(static_cast<bool>(sbgc::decode(body, again, contexts.of(again))));
  } else {
    require(static_cast<bool>(sbgc::decode(body, again)));
  }
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  const sbgc::WriteResult framed = sbgc::encode_frame(again, frame);
  require(framed.size == sbgc::frame_size(body.size()));
  require(std::ranges::equal(std::span(frame).subspan(sbgc::frame_header_size, body.size()), body));
}

void check_body(std::uint8_t id, Body body, sbgc::Direction direction,
                const sbgc::Contexts& contexts) {
  const auto visitor = [&](const auto& message) { check(message, body, contexts); };
  const sbgc::Status status = sbgc::visit(id, body, direction, visitor, contexts);
  require(status.field != nullptr);
  require(status.offset <= body.size());
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

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 2 || size > 2 + 2 * sbgc::max_body_size) return 0;
  const bool from_board = data[0] % 2 != 0;
  const auto direction = from_board ? sbgc::Direction::from_board : sbgc::Direction::to_board;
  const std::uint8_t id = data[1];
  const Body body(data + 2, std::min(size - 2, sbgc::max_body_size));
  check_body(id, body, direction, {});

  const std::size_t request_size = std::min<std::size_t>(data[0] / 2, body.size());
  if (request_size == 0) return 0;
  check_body(id, body.first(body.size() - request_size), direction,
             learn_from(body.last(request_size)));
  return 0;
}
