// Tests of a pseudo-terminal that fails.

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
  std::array<std::uint8_t, max_frame_size> frame{};
  const std::size_t size = encode_frame(msg::BoardInfoRequest{}, frame).size;
  board.receive(port, std::span(frame).first(size));
  run(context, 200);
  EXPECT_EQ(got, 0U);
}

}  // namespace
}  // namespace sbgc::serving
