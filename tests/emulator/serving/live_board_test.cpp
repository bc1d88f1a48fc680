// Tests of the board in real time: each host is notified of its output, also at a pseudo-terminal
// that fails.

#include "serving/live_board.hpp"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <gtest/gtest.h>

#include <sbgc/io/transport.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/system.hpp>

#include "hosts/endpoint.hpp"

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

TEST(LiveBoard, AnAnswerIsDueWhenAHostConnectsOrSetsItsLine) {
  for (const bool connects : {true, false}) {
    LiveBoardRig rig;
    rig.poll_again();
    rig.ask(rig.first);
    if (connects) {
      ASSERT_TRUE(rig.board.connect(false, [] {}));
      EXPECT_FALSE(rig.board.output(rig.first).empty());
    } else {
      rig.board.set_host_rate(rig.first, 9600);
    }
    EXPECT_EQ(rig.told, 0U) << "not from within the call";
    rig.context.poll();
    EXPECT_GT(rig.told, 0U);
  }
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

/// A transport that fails to read.
class Broken final : public io::Transport {
 public:
  explicit Broken(std::unique_ptr<io::Transport> inner) : inner_(std::move(inner)) {}

  void async_read(std::span<std::uint8_t> /*into*/, Handler handler) override {
    asio::post(executor(), [handler = std::move(handler)] { handler(io::Errc::device_lost, 0); });
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    inner_->async_write(bytes, std::move(handler));
  }
  void close() override { inner_->close(); }
  asio::any_io_executor executor() override { return inner_->executor(); }
  std::string description() const override { return "broken"; }

 private:
  std::unique_ptr<io::Transport> inner_;
};

void run(asio::io_context& context, int milliseconds) {
  context.restart();
  context.run_for(std::chrono::milliseconds(milliseconds));
}

TEST(Terminal, ThatFailsLeavesItsPortAlone) {
  emulator::EmulatorOptions options;
  options.line.board.baud_rate = 9600;
  asio::io_context context(1);
  LiveBoard board(context.get_executor(), options, {});
  board.between = [](std::unique_ptr<io::Transport> transport) {
    return std::make_unique<Broken>(std::move(transport));
  };
  std::vector<std::string> warnings;
  const hosts::EndpointLogs logs{[](const std::string&) {},
                                 [&](const std::string& text) { warnings.push_back(text); }};
  const auto terminal = hosts::open_terminal(context.get_executor(), board, "", true, logs);
  context.poll();
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find(terminal->address()), std::string::npos);

  // The port's new host has its own settings, which remain wrong.
  std::size_t got = 0;
  std::size_t port = 0;
  port = *board.connect(false, [&] { got += board.output(port).size(); });
  EXPECT_EQ(port, 0U);
  board.set_host_rate(port, 57600);
  run(context, 100);
  board.receive(port, request());
  run(context, 200);
  EXPECT_EQ(got, 0U);
}

}  // namespace
}  // namespace sbgc::serving
