#include "task_test.hpp"

namespace sbgc::test {

TaskTest::TaskTest() {
  clock.on_move([this](Ms by) { board.skip(by); });
}

TaskTest::~TaskTest() = default;

void TaskTest::connect(unsigned retries) {
  client_.reset();
  ConnectOptions options = quick();
  options.retries = retries;
  client_.emplace(*checked(connect_over(board.line(), options)));
  // Returns after everything that connecting has sent, which may be repeated after a stall.
  require(client_->call(msg::BoardInfoRequest{}, {.timeout = options.timeout, .retries = 0}));
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
