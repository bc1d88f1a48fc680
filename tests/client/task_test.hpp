/// Tests of tasks: a client that is connected to an emulated board.
#pragma once

#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>

#include "emulated_board.hpp"
#include "manual_clock.hpp"

namespace sbgc::test {

class TaskTest : public ::testing::Test {
 public:
  TaskTest(const TaskTest&) = delete;
  TaskTest& operator=(const TaskTest&) = delete;
  TaskTest(TaskTest&&) = delete;
  TaskTest& operator=(TaskTest&&) = delete;

 protected:
  TaskTest();
  ~TaskTest() override;

  /// The client; connected when it is first asked for.
  Client& client() {
    if (!client_) connect();
    return *client_;
  }
  /// Connects once more, to what the board is now. The log begins then.
  void connect(unsigned retries = 9);
  /// For tests in which much gets lost: it is known sooner, and still not before a stall is over.
  static constexpr unsigned few_retries = 3;
  void disconnect() { client_.reset(); }
  /// Makes it a board of this version with this firmware.
  void become(msg::BoardVersion version, msg::FirmwareVersion firmware);
  void become(msg::BoardVersion version) { become(version, board.options().firmware); }
  void become(msg::FirmwareVersion firmware) { become(board.options().board, firmware); }
  /// How many requests M have come.
  template <class M>
  std::size_t count() {
    return board.count<M>();
  }

  /// While it moves on, so does the board's time, which otherwise is that of this machine.
  ManualClock clock;
  EmulatedBoard board;  // behind the clock, which its hooks may use

 private:
  std::optional<Client> client_;
};

}  // namespace sbgc::test
