/// Tests of tasks: a client that is connected to a board in memory.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>

#include "manual_clock.hpp"
#include "model_board.hpp"

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
  /// Connects once more, to what the board is now.
  void connect();
  /// Looks at the board, or changes it, while it works.
  template <class Use>
  auto with_board(Use use) {
    const std::scoped_lock lock(mutex_);
    return use(board);
  }
  /// How many requests M have come, even if one is under way.
  template <class M>
  std::size_t count() {
    return with_board([](const ModelBoard& model) { return model.count<M>(); });
  }
  /// Ends client, line and the board's thread; for tests with members that the board uses.
  void disconnect();
  std::mutex& board_mutex() { return mutex_; }
  /// Makes the line break.
  void unplug();
  /// Lets the board play a serial port; returns its path, "" if there can be none.
  std::string serve_pty();
  /// Lets the board say that it restarts.
  void send_reset();

  /// Not while a call is under way; see with_board().
  ModelBoard board;
  ManualClock clock;

 private:
  class Line;

  std::mutex mutex_;
  std::unique_ptr<Line> line_;
  std::optional<Client> client_;
};

}  // namespace sbgc::test
