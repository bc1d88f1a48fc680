/// An emulated board on a pseudo-terminal that stops behaving like one.
#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/io/pseudo_terminal.hpp>

namespace sbgc::bench {

/// How the board treats its answers.
enum class Manner : std::uint8_t {
  well,      ///< sends them
  silent,    ///< sends nothing
  partly,    ///< sends a few, then the first half of each
  babbling,  ///< sends noise and other messages instead, without a pause
};

class BadBoard {
 public:
  BadBoard();
  BadBoard(const BadBoard&) = delete;
  BadBoard& operator=(const BadBoard&) = delete;
  ~BadBoard();

  /// The serial port of the board.
  const std::string& address() const noexcept { return address_; }
  /// Behaves like this from now on. `whole` is how many chunks of answers are sent by a board that
  /// answers partly before it cuts them.
  void behave(Manner manner, unsigned whole = 0);

 private:
  void read();
  /// Runs the emulated board until now.
  void advance();
  void answer(std::span<const std::uint8_t> bytes);
  void babble();
  void write();

  asio::io_context context_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{context_.get_executor()};
  asio::steady_timer board_timer_{context_};
  asio::steady_timer babble_timer_{context_};
  std::unique_ptr<io::PseudoTerminal> terminal_{};
  std::string address_{};
  emulator::Emulator emulator_;
  std::size_t port_;
  Manner manner_ = Manner::well;
  unsigned whole_ = 0;
  std::array<std::uint8_t, 4096> in_{};
  std::vector<std::uint8_t> waiting_{};
  std::vector<std::uint8_t> out_{};
  bool is_writing_ = false;
  std::thread thread_{};  // the last member: it uses the others
};

}  // namespace sbgc::bench
