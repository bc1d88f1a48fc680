#include "command/background_output.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <string_view>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include "command/command_error.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

/// Text that may wait for the reader.
constexpr std::size_t max_waiting = std::size_t{64} << 10;
/// A pipe has room for it as soon as its reader has read something.
constexpr std::size_t block_size = 4096;
/// The time that the end of the command waits for a reader that reads nothing.
constexpr std::chrono::seconds patience{1};

/// Returns 0, or the error that prevents it.
int write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t size = ::write(descriptor, text.data(), text.size());
    if (size >= 0) {
      text.remove_prefix(static_cast<std::size_t>(size));
    } else if (errno == EAGAIN) {  // another process has made the file nonblocking
      pollfd room{descriptor, POLLOUT, 0};
      ::poll(&room, 1, -1);
    } else if (errno != EINTR) {
      return errno;
    }
  }
  return 0;
}

}  // namespace

struct BackgroundOutput::State {
  std::mutex mutex{};
  std::condition_variable changed{};
  std::string waiting{};
  std::size_t dropped = 0;  // lines after `waiting`
  bool is_writing = false;
  std::size_t blocks = 0;  // that are written
  bool is_closed = false;  // a write has failed
  bool has_failed = false;
  bool has_given_up = false;

  bool is_done() const { return waiting.empty() && !is_writing; }

  /// Runs on the thread.
  [[noreturn]] void run(int descriptor) {
    std::unique_lock lock(mutex);
    while (true) {
      changed.wait(lock, [this] { return !waiting.empty(); });
      std::string text = std::exchange(waiting, {});
      if (dropped != 0) text += fmt::format("... {} lines dropped: no reader\n", dropped);
      dropped = 0;
      is_writing = true;
      lock.unlock();
      int error = 0;
      for (std::size_t at = 0; at < text.size() && error == 0; at += block_size) {
        error = write_all(descriptor, std::string_view(text).substr(at, block_size));
        const std::lock_guard counting(mutex);
        ++blocks;
        changed.notify_all();
      }
      lock.lock();
      is_writing = false;
      if (error != 0) is_closed = true;
      if (error != 0 && error != EPIPE) has_failed = true;
      changed.notify_all();
    }
  }
};

BackgroundOutput::BackgroundOutput(int descriptor) : state_(std::make_shared<State>()) {
  const WithoutSignals without_signals;
  std::thread([state = state_, descriptor] { state->run(descriptor); }).detach();
}

BackgroundOutput::~BackgroundOutput() { finish(); }

void BackgroundOutput::write(const std::string& text) {
  const std::lock_guard lock(state_->mutex);
  // Text that follows dropped text is dropped, too, so that the lines are in order.
  std::string& waiting = state_->waiting;
  const bool is_full = !waiting.empty() && waiting.size() + text.size() > max_waiting;
  if (state_->dropped != 0 || is_full) {
    state_->dropped += static_cast<std::size_t>(std::ranges::count(text, '\n'));
    return;
  }
  waiting += text;
  state_->changed.notify_all();
}

void BackgroundOutput::wait() {
  std::unique_lock lock(state_->mutex);
  state_->changed.wait(lock, [this] { return state_->is_done(); });
}

bool BackgroundOutput::wait_until(std::chrono::steady_clock::time_point end) {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_until(lock, end, [this] { return state_->is_done(); });
}

bool BackgroundOutput::is_closed() const {
  const std::lock_guard lock(state_->mutex);
  return state_->is_closed;
}

bool BackgroundOutput::is_complete() const {
  const std::lock_guard lock(state_->mutex);
  return !state_->has_given_up;
}

bool BackgroundOutput::finish() {
  std::unique_lock lock(state_->mutex);
  while (!state_->is_done() && !state_->has_given_up) {
    const auto goes_on = [this, before = state_->blocks] {
      return state_->is_done() || state_->blocks != before;
    };
    if (!state_->changed.wait_for(lock, patience, goes_on)) state_->has_given_up = true;
  }
  return !state_->has_failed;
}

BackgroundOutput& background_stdout() {
  static BackgroundOutput output(STDOUT_FILENO);
  return output;
}

BackgroundOutput& background_stderr() {
  static BackgroundOutput output(STDERR_FILENO);
  return output;
}

void finish_stdout() {
  if (!background_stdout().finish()) throw CommandError("cannot write to the standard output");
}

void remark_in_background() {
  remark_writer = [](const std::string& text) { background_stderr().write(text); };
}

}  // namespace sbgc::tools
