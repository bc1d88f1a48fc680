/// The line to the gimbal, which stays open between the commands of a shell.
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/steady_timer.hpp>

#include <sbgc/io/internal/descriptor.hpp>

#include "hosts/endpoint.hpp"
#include "move/guard.hpp"
#include "share/shared_line.hpp"

namespace sbgc::tools {

/// Shares the gimbal with one command after another, like `sbgc bridge`: a command gets a
/// pseudo-terminal that only this user can open.
class ShellLine {
 public:
  /// Connects. Throws CommandError.
  explicit ShellLine(const GimbalOptions& gimbal);
  ShellLine(const ShellLine&) = delete;
  ShellLine& operator=(const ShellLine&) = delete;
  ~ShellLine();

  /// Returns, for example, "serial port /dev/ttyUSB0, 115200 8N1: board 3.6, firmware 2.70".
  std::string description();
  /// Returns, for example, "serial port /dev/ttyUSB0, 115200 8N1".
  std::string line() { return line_.client().description(); }
  bool is_connected() { return line_.client().is_connected(); }
  /// Waits for a moment until it is reconnected. Returns false if it is not.
  bool wait_until_connected();

  /// Opens a place for a command, and returns its address.
  std::string open_place();
  /// Closes the place, and with it the streams of the command; or leaves it to a guard.
  void close_place(bool is_left_to_guard);

  /// Passes the line to the guard: if this process dies, it stops the gimbal. Returns false on
  /// failure.
  bool hand_line_to(const Guard& guard);

  /// Reports changes of the line. While a command runs, they are reported at once.
  void report_changes();
  void set_running(bool is_running);

 private:
  SharedLine::Settings settings();
  void tell(const std::string& text);
  void tick();
  /// Runs a function on the thread of the line.
  template <class Function>
  void on_thread(Function function);

  asio::io_context context_{1};
  asio::steady_timer timer_{context_};
  std::mutex mutex_{};
  std::vector<std::string> untold_{};    // guarded by the mutex, as the next two
  bool is_running_ = true;               // also while it connects
  io::detail::Descriptor descriptor_{};  // of the line, for a guard
  SharedLine line_;
  std::unique_ptr<hosts::Endpoint> place_{};
  std::vector<std::unique_ptr<hosts::Endpoint>> left_places_{};  // to guards
  std::thread thread_{};
};

}  // namespace sbgc::tools
