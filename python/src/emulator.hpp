/// An emulated board in this process.
#pragma once

#include <future>
#include <memory>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/io/internal/virtual_time.hpp>
#include <sbgc/io/memory.hpp>

#include "hosts/host.hpp"
#include "operation.hpp"
#include "serving/live_board.hpp"

namespace sbgc::python {

/// The board and its thread, which never runs Python. In virtual time it has no thread: whoever
/// waits for something runs it.
class Emulation : public std::enable_shared_from_this<Emulation> {
 public:
  Emulation(const emulator::EmulatorOptions& options, bool has_virtual_time)
      : time_(has_virtual_time ? &asio::use_service<io::detail::VirtualTime>(context_) : nullptr),
        board_(context_.get_executor(), options, {}) {
    if (time_ == nullptr) thread_ = std::thread([this] { context_.run(); });
  }
  Emulation(const Emulation&) = delete;
  Emulation& operator=(const Emulation&) = delete;
  ~Emulation() {
    context_.stop();
    if (thread_.joinable()) thread_.join();
    for (const auto& host : hosts_) host->close();
  }
  /// In a forked child, which does not have its thread, its memory is leaked.
  static std::shared_ptr<Emulation> make(const emulator::EmulatorOptions& options,
                                         bool has_virtual_time) {
    return {new Emulation(options, has_virtual_time), [](const Emulation* one) {
              if (!one->process_.is_forked()) delete one;
            }};
  }
  void require_this_process() const { process_.require("the emulated board"); }

  bool has_virtual_time() const noexcept { return time_ != nullptr; }
  /// Returns its virtual time, which keeps the board; null in real time.
  std::shared_ptr<io::detail::VirtualTime> time() {
    if (time_ == nullptr) return nullptr;
    return {shared_from_this(), time_};
  }

  /// Runs `action()` on the board's thread, and returns its result.
  template <class Action>
  auto on_thread(Action action) {
    if (time_ != nullptr) return time_->between_handlers(action);
    std::packaged_task<std::invoke_result_t<Action>()> task(std::move(action));
    auto done = task.get_future();
    asio::post(context_, [task = std::move(task)]() mutable { task(); });
    return done.get();
  }

  TransportFactory line() {
    return [board = shared_from_this()](const asio::any_io_executor& executor) {
      auto pair = io::make_memory_pair(executor, board->context_.get_executor());
      board->on_thread([&] {
        auto host = hosts::Host::connect(board->board_, std::move(pair.second));
        if (host == nullptr) return;  // no port is free: the line stays silent
        host->start();
        board->hosts_.push_back(std::move(host));
      });
      return std::move(pair.first);
    };
  }

  /// Seconds since the board has started.
  double now() {
    return on_thread([this] { return static_cast<double>(board_.now().us) / 1e6; });
  }
  /// Lets virtual time pass.
  void pass(double seconds) {
    time_->run([] { return false; }, time_->now() + duration_of(seconds));
  }

  emulator::Sample sample() {
    return on_thread([this] { return board_.emulator().board().gimbal().sample(board_.now()); });
  }
  void restart() {
    on_thread([this] { board_.emulator().restart(board_.now()); });
  }
  void unplug() {
    on_thread([this] {
      for (const auto& host : hosts_) host->close();
      hosts_.clear();
    });
  }

 private:
  Process process_{};
  asio::io_context context_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{context_.get_executor()};
  io::detail::VirtualTime* time_;  // of the context
  serving::LiveBoard board_;
  std::vector<std::shared_ptr<hosts::Host>> hosts_{};
  std::thread thread_{};
};

}  // namespace sbgc::python
