/// Tests of tasks with a client that is connected to an emulated board.
#pragma once

#include "testing.hpp"

namespace sbgc::test {

class TaskTest : public ::testing::Test {
 protected:
  TaskTest() {
    clock.on_move([this](Ms by) { board.skip(by); });
  }

  /// Returns the client; connects on first use.
  Client& client() {
    if (!client_) connect();
    return *client_;
  }
  /// Connects again, to the current board. The log starts then.
  void connect(unsigned retries = 9) {
    client_.reset();
    ConnectOptions options = quick();
    options.retries = retries;
    client_.emplace(*checked(connect_over(board.line(), options)));
    // Returns after everything that connecting has sent, which may be repeated after a stall.
    require(client_->call(msg::BoardInfoRequest{}, {.timeout = options.timeout, .retries = 0}));
    board.clear_log();
  }
  /// For tests with many losses: fails sooner, but not before a stall is over.
  static constexpr unsigned few_retries = 3;
  void disconnect() { client_.reset(); }
  /// Replaces the board by one of this version with this firmware.
  void become(msg::BoardVersion version, msg::FirmwareVersion firmware) {
    client_.reset();
    emulator::BoardOptions options = board.options();
    options.board = version;
    options.firmware = firmware;
    board.become(options);
  }
  void become(msg::BoardVersion version) { become(version, board.options().firmware); }
  void become(msg::FirmwareVersion firmware) { become(board.options().board, firmware); }
  /// Returns the number of requests M received.
  template <class M>
  std::size_t count() {
    return board.count<M>();
  }

  /// When this clock is advanced, so is the board's time, which otherwise follows this machine.
  ManualClock clock;
  EmulatedBoard board;  // declared after the clock, which its hooks may use

 private:
  std::optional<Client> client_;
};

}  // namespace sbgc::test
