#include "shell/shell_line.hpp"

#include <chrono>
#include <future>
#include <utility>

#include <asio/post.hpp>
#include <fcntl.h>
#include <fmt/format.h>

#include <sbgc/io/transport.hpp>

#include "command/interruption.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

constexpr std::chrono::milliseconds shell_tick_time{100};
/// A restarting board is back within this time.
constexpr std::chrono::seconds longest_outage{5};

}  // namespace

ShellLine::ShellLine(const GimbalOptions& gimbal) : line_(context_, gimbal, settings()) {
  tick();
  set_running(false);
  // The handlers of libedit crash on another thread than that of the prompt.
  const WithoutSignals without_signals;
  thread_ = std::thread([this] { context_.run(); });
}

ShellLine::~ShellLine() {
  context_.stop();
  thread_.join();
  line_.client().close();
  place_.reset();
  left_places_.clear();
}

SharedLine::Settings ShellLine::settings() {
  // The password unlocks the gimbal for this user only.
  return {.allows_passwords = true,
          .wrap =
              [this](std::unique_ptr<io::Transport> transport) {
                const std::lock_guard lock(mutex_);
                descriptor_ =
                    io::detail::Descriptor(::fcntl(transport->native_handle(), F_DUPFD_CLOEXEC, 0));
                return transport;
              },
          .on_change =
              [this](const LinkChange& change) {
                if (change.state == LinkState::searching) return;
                if (change.state == LinkState::lost) {
                  const std::lock_guard lock(mutex_);
                  descriptor_ = {};
                }
                tell(change.state == LinkState::connected ? "connected again: " + change.message
                                                          : change.message);
              }};
}

std::string ShellLine::description() {
  const BoardIdentity board = line_.client().identity();
  return fmt::format("{}: board {}, firmware {}", line(), board.board_version(),
                     board.firmware_version());
}

bool ShellLine::wait_until_connected() {
  const auto end = std::chrono::steady_clock::now() + longest_outage;
  while (!is_connected() && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(shell_tick_time);
  }
  return is_connected();
}

std::string ShellLine::open_place() {
  std::string address;
  on_thread([&] {
    place_ = hosts::open_terminal(
        context_.get_executor(), line_.ports(), "", false,
        {.event = {}, .warning = [this](const std::string& text) { tell(text); }});
    // A pseudo-terminal accepts any rate; giving one avoids the detection.
    address = fmt::format("serial:{}?baud=115200", place_->address());
  });
  return address;
}

void ShellLine::close_place(bool is_left_to_guard) {
  on_thread([&] {
    if (is_left_to_guard) left_places_.push_back(std::move(place_));
    place_.reset();
  });
}

bool ShellLine::hand_line_to(const Guard& guard) {
  const std::lock_guard lock(mutex_);
  if (!descriptor_) return false;
  guard.take(descriptor_.get(), AfterStop::all);  // every command of the shell may need it
  return true;
}

void ShellLine::report_changes() {
  const std::lock_guard lock(mutex_);
  for (const std::string& text : std::exchange(untold_, {})) remark("sbgc: {}\n", text);
}

void ShellLine::set_running(bool is_running) {
  const std::lock_guard lock(mutex_);
  is_running_ = is_running;
}

void ShellLine::tell(const std::string& text) {
  const std::lock_guard lock(mutex_);
  if (is_running_) return remark("sbgc: {}\n", text);
  untold_.push_back(text);
}

void ShellLine::tick() {
  line_.tick();
  timer_.expires_after(shell_tick_time);
  timer_.async_wait([this](std::error_code error) {
    if (!error) tick();
  });
}

template <class Function>
void ShellLine::on_thread(Function function) {
  std::packaged_task<void()> task(std::move(function));
  std::future<void> done = task.get_future();
  asio::post(context_, [&task] { task(); });
  done.get();
}

}  // namespace sbgc::tools
