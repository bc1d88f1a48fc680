// Tests of the board in real time: each host is notified of its output.

#include "serving/live_board.hpp"

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <gtest/gtest.h>

#include <sbgc/message.hpp>
#include <sbgc/messages/system.hpp>

namespace sbgc::serving {
namespace {

std::vector<std::uint8_t> request() {
  std::array<std::uint8_t, max_frame_size> frame{};
  const std::size_t size = encode_frame(msg::BoardInfoRequest{}, frame).size;
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// Waits longer than the board and its line need for any request in these tests.
void let_time_pass(const LiveBoard& board) {
  const Instant end = board.now() + milliseconds(5);
  while (board.now() < end) {
  }
}

struct LiveBoardRig {
  asio::io_context context{1};
  LiveBoard board{context.get_executor(), {}, {}};
  std::size_t told = 0;  // notifications of output for the first host
  std::size_t first =
      *board.connect(false, [this] { told += board.output(first).empty() ? 0U : 1U; });

  void poll_again() {
    context.poll();
    context.restart();
  }
  /// A host sends a request, and time passes until its answer is due.
  void ask(std::size_t port) {
    board.receive(port, request());
    let_time_pass(board);
  }
};

TEST(LiveBoard, AnotherHostConnectsWhenAnAnswerIsDue) {
  LiveBoardRig rig;
  rig.poll_again();
  rig.ask(rig.first);
  ASSERT_TRUE(rig.board.connect(false, [] {}));
  EXPECT_FALSE(rig.board.output(rig.first).empty());
  EXPECT_EQ(rig.told, 0U);  // not from within connect()
  rig.context.poll();
  EXPECT_GT(rig.told, 0U);
}

TEST(LiveBoard, AHostSetsItsLineWhenAnAnswerIsDue) {
  LiveBoardRig rig;
  rig.poll_again();
  rig.ask(rig.first);
  rig.board.set_host_rate(rig.first, 9600);
  EXPECT_EQ(rig.told, 0U);
  rig.context.poll();
  EXPECT_GT(rig.told, 0U);
}

TEST(LiveBoard, AnAnswerThatComesWhileAnotherHostIsServed) {
  LiveBoardRig rig;
  bool is_slow = true;
  std::size_t second = 0;
  second = *rig.board.connect(false, [&] {
    if (std::exchange(is_slow, false)) let_time_pass(rig.board);
    const std::size_t size = rig.board.output(second).size();
    if (size > 0) rig.board.take(second, size);
  });
  is_slow = false;
  rig.poll_again();
  rig.ask(second);
  is_slow = true;
  rig.board.receive(rig.first, request());  // executed while the second host is being notified
  rig.context.poll();
  EXPECT_TRUE(rig.board.output(second).empty());
  EXPECT_GT(rig.told, 0U);
}

}  // namespace
}  // namespace sbgc::serving
