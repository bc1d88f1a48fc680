/// The emulated board for tests of clients: on a line of the chosen kind, with direct access.
#pragma once

#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/io/memory.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/type_list.hpp>

#include "hosts/endpoint.hpp"
#include "hosts/host.hpp"
#include "line.hpp"
#include "serving/live_board.hpp"

namespace sbgc::test {

template <class List>
struct FirstOf;
template <class M, class... More>
struct FirstOf<TypeList<M, More...>> {
  using Type = M;
};
template <class List>
using First = typename FirstOf<List>::Type;

/// The messages of all settings.
using BackedUp = TypeList<msg::ReadParams3, msg::ReadParamsExt, msg::ReadParamsExt2,
                          msg::ReadProfileNames, msg::ReadAdjVarsCfg, msg::ReadExternalData>;

/// A board without noise, on a line without a rate.
emulator::EmulatorOptions quick_board();

/// The emulated board as `sbgc emulate` serves it, on its own thread, with one host.
///
/// All functions may be called from any thread; their effect on the board's thread is complete when
/// they return. Hooks run on the board's thread and may call them.
class EmulatedBoard {
 public:
  /// With `is_tapped`, hooks work; without, bytes pass unchanged.
  explicit EmulatedBoard(emulator::EmulatorOptions options = quick_board(),
                         emulator::Memory memory = {}, bool is_tapped = true);
  EmulatedBoard(const EmulatedBoard&) = delete;
  EmulatedBoard& operator=(const EmulatedBoard&) = delete;
  ~EmulatedBoard();

  /// Returns the factory of transports to the board.
  TransportFactory line();
  /// Returns the factory of a line in memory with these settings at the board's end.
  TransportFactory line_with(const LineSettings& settings);
  /// Serves a serial port from now on and returns its path, or "" if there can be none.
  std::string serve_terminal();
  /// Serves a TCP port from now on and returns its address.
  std::string serve_tcp();

  /// Replaces the board by another one with this memory. Hooks remain; hosts are disconnected.
  void become(const emulator::BoardOptions& options, emulator::Memory memory);
  void become(const emulator::BoardOptions& options) { become(options, memory()); }
  emulator::BoardOptions options() const;
  emulator::Memory memory();

  // Hooks, see TapHooks; they must not refer to objects that the board outlives.

  void on_lost(std::function<bool(const Packet&)> is_lost);
  void on_answer_lost(std::function<bool(const Packet&)> is_answer_lost);
  void tamper(std::function<void(Packets&)> change);
  void after(std::function<void(const Packet&)> action);
  Packets log();
  void clear_log();
  /// Returns the requests M in the log.
  template <class M>
  std::vector<M> requests() {
    std::vector<M> result;
    for (const Packet& one : log()) {
      if (is<M>(one)) result.push_back(message<M>(one));
    }
    return result;
  }
  template <class M>
  std::size_t count() {
    return requests<M>().size();
  }
  void unplug();

  // The back door: another host, over USB

  /// Sends a request; returns the messages sent within a millisecond of the board's time.
  Packets ask(const Packet& request);
  /// Returns the board's response. Throws std::runtime_error if there is none.
  template <Message Answer, Message Request>
  Answer read(const Request& request) {
    std::string others;
    for (const Packet& one : ask(packet(request))) {
      if (is<Answer>(one)) return message<Answer>(one);
      others += " " + std::to_string(one.id);
    }
    throw std::runtime_error("command " + std::to_string(packet(request).id) +
                             " at the back door has no such answer, but these:" + others);
  }
  /// Sends a request. Throws std::runtime_error if the board does not confirm it.
  template <Message Request>
  void write(const Request& request) {
    const auto done = read<msg::Confirm>(request);
    if (done.cmd != Request::command) throw std::runtime_error("another command is confirmed");
  }
  /// Returns the board's settings, of one profile or of all.
  template <class M>
  M settings(std::uint8_t copy = 0) {
    First<typename ParametersOf<M>::Readers> request{};
    if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(request) = copy;
    return read<M>(request);
  }
  template <class M>
  std::vector<M> all_settings() {
    std::vector<M> result;
    for (std::uint8_t copy = 0; copy < ParametersOf<M>::copies; ++copy) {
      result.push_back(settings<M>(copy));
    }
    return result;
  }
  template <class M>
  void store(const M& settings) {
    First<typename ParametersOf<M>::Writers> request{};
    static_cast<M&>(request) = settings;
    write(request);
  }
  /// Modifies settings with `change(settings)`.
  template <class M, class Change>
  void edit(std::uint8_t copy, Change&& change) {
    M changed = settings<M>(copy);
    change(changed);
    store(changed);
  }

  /// Calls `use(gimbal, now)` with the simulated gimbal and the board's time.
  template <class Use>
  auto gimbal(Use use) {
    return on_thread([&] { return use(live().emulator().board().gimbal(), live().now()); });
  }
  /// Returns the board's time.
  Instant now() {
    return on_thread([this] { return live().now(); });
  }
  emulator::BoardCounters counters() {
    return on_thread([this] { return live().emulator().board().counters(); });
  }
  /// Restarts the board, as by a power cycle.
  void restart() {
    on_thread([this] { live().emulator().restart(live().now()); });
  }
  /// Advances the board's time.
  void skip(std::chrono::milliseconds time);

  /// Runs `action()` on the board's thread and returns its result.
  template <class Action>
  std::invoke_result_t<Action&> on_thread(Action action) {
    if (running_->thread.get_id() == std::this_thread::get_id()) return action();
    std::packaged_task<std::invoke_result_t<Action&>()> task(std::move(action));
    auto done = task.get_future();
    // In a lambda, because asio::post() treats a packaged_task differently in files that include
    // <asio/use_future.hpp>.
    asio::post(running_->context, [task = std::move(task)]() mutable { task(); });
    return done.get();
  }

 private:
  /// Everything that ends with the thread.
  struct Running {
    asio::io_context context{1};
    asio::executor_work_guard<asio::io_context::executor_type> work{context.get_executor()};
    std::unique_ptr<serving::LiveBoard> board{};
    std::unique_ptr<hosts::Endpoint> endpoint{};
    std::shared_ptr<hosts::Host> host{};  // of a line in memory
    std::size_t back_door{};
    std::thread thread{};

    Running() = default;
    Running(const Running&) = delete;
    Running& operator=(const Running&) = delete;
    ~Running();
  };

  void start(emulator::Memory memory);
  void stop();
  /// Replaces the previous transport.
  void serve(std::unique_ptr<io::Transport> transport);
  static std::unique_ptr<hosts::Endpoint> listen(Running& running);
  serving::LiveBoard& live() { return *running_->board; }

  emulator::EmulatorOptions options_;
  bool is_tapped_;
  TapHooks hooks_{};
  std::unique_ptr<Running> running_{};
};

}  // namespace sbgc::test
