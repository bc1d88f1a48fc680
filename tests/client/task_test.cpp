#include "task_test.hpp"

#include <stdexcept>
#include <utility>

#include "scripted_board.hpp"

namespace sbgc::test {

TaskTest::TaskTest() {
  clock.on_move([this](std::chrono::milliseconds by) { board.skip(by); });
}

TaskTest::~TaskTest() = default;

void TaskTest::connect(unsigned retries) {
  client_.reset();
  ConnectOptions options = quick();
  options.retries = retries;
  Result<Client> connected = connect_over(board.line(), options);
  if (!connected) throw std::runtime_error(connected.error().message);
  client_.emplace(*std::move(connected));
  // Returns after everything that connecting has sent, which may be repeated after a stall.
  const auto settled =
      client_->call(msg::BoardInfoRequest{}, {.timeout = options.timeout, .retries = 0});
  if (!settled) throw std::runtime_error(settled.error().message);
  board.clear_log();
}

void TaskTest::become(msg::BoardVersion version, msg::FirmwareVersion firmware) {
  client_.reset();
  emulator::BoardOptions options = board.options();
  options.board = version;
  options.firmware = firmware;
  board.become(options);
}

}  // namespace sbgc::test
