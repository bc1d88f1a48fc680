/// Tests of tasks: a client that is connected to a board in memory.
#pragma once

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/io/pseudo_terminal.hpp>

#include "manual_clock.hpp"
#include "model_board.hpp"
#include "scripted_board.hpp"

namespace sbgc::test {

class TaskTest : public ::testing::Test {
 protected:
  TaskTest() {
    AllMessages::for_each([this]<class M>(Type<M>) {
      if constexpr (M::direction != Direction::from_board) {
        line_.on<M>([this](const M& request) { answer(packet(request)); });
      }
    });
  }

  /// The client; connected when it is first asked for.
  Client& client() {
    if (!client_) connect();
    return *client_;
  }
  /// Connects once more, to what the board is now.
  void connect() {
    client_.reset();
    ConnectOptions options = quick();
    options.retries = 0;
    Result<Client> connected = connect_over(over_memory(line_), options);
    if (!connected) throw std::runtime_error(connected.error().message);
    client_.emplace(*std::move(connected));
    board.log.clear();
  }
  /// Looks at the board, or changes it, while it works.
  template <class Use>
  auto with_board(Use use) {
    const std::scoped_lock lock(mutex_);
    return use(board);
  }
  std::mutex& board_mutex() { return mutex_; }
  /// Makes the line break.
  void unplug() { line_.unplug(); }
  /// Lets the board play a serial port; returns its path, "" if there can be none.
  std::string serve_pty() {
    auto opened = io::open_pseudo_terminal(line_.executor(), {.stays_open = true});
    if (!opened) return {};
    std::string path = opened.transport->path();
    line_.serve(std::move(opened.transport));
    return path;
  }
  /// Sends something unasked.
  template <class M>
  void send(const M& message) {
    line_.send(message);
  }

  /// Not while a call is under way; see with_board().
  ModelBoard board;
  ManualClock clock;

 private:
  void answer(const Packet& request) {
    Packets answers;
    {
      const std::scoped_lock lock(mutex_);
      answers = board.answer(request);
    }
    for (const Packet& one : answers) {
      std::array<std::uint8_t, max_frame_size> frame{};
      std::ranges::copy(one.body, frame_body(frame.data()));
      line_.send_bytes(std::span(frame).first(finish_frame(frame.data(), one.id, one.body.size())));
    }
  }

  std::mutex mutex_;
  ScriptedBoard line_;
  std::optional<Client> client_;
};

}  // namespace sbgc::test
