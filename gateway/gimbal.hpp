/// One gimbal of a gateway.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/strand.hpp>

#include <sbgc/any.hpp>
#include <sbgc/client/async_client.hpp>
#include <sbgc/error.hpp>

#include "gateway/fleet.hpp"

namespace sbgc::tools {

/// The threads that all gimbals share.
class Io {
 public:
  explicit Io(unsigned threads);
  Io(const Io&) = delete;
  Io& operator=(const Io&) = delete;
  ~Io() { finish(); }

  /// Waits until no work is left, and ends the threads: everything that uses the executor must be
  /// closed before.
  void finish();

  asio::any_io_executor executor() { return context_.get_executor(); }

 private:
  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  std::vector<std::thread> threads_;
};

/// `connecting` only applies before the first attempt has ended.
enum class GimbalLink : std::uint8_t { offline, connecting, online };

/// The name of a state, such as "online".
constexpr const char* name(GimbalLink link) noexcept {
  switch (link) {
    case GimbalLink::offline: return "offline";
    case GimbalLink::connecting: return "connecting";
    case GimbalLink::online: return "online";
  }
  return "unknown";
}

struct GimbalStatus {
  GimbalLink link = GimbalLink::connecting;
  std::string reason{};    ///< why it is not online: a sentence without a final period
  std::string firmware{};  ///< of the last connection, such as "2.59"
  std::string board{};
  std::string serial_number{};
  std::uint64_t connections{};  ///< made since the start
  bool is_stopping{};           ///< a stop has been failing for seconds: all motion is refused

  bool operator==(const GimbalStatus&) const = default;
};

/// Counters of a gimbal since the start, over all connections.
struct GimbalCounters {
  ClientStatistics line{};                              ///< without StreamUsage
  std::map<std::string, std::uint64_t> telemetry{};     ///< messages by name
  std::map<std::string, std::uint64_t> board_errors{};  ///< those outside of calls, by name
};

/// The kind of an event: the board has restarted.
inline constexpr const char* board_reset_event = "board_reset";

/// An event of a gimbal outside of telemetry and commands.
struct GimbalEvent {
  std::string kind{};                  ///< such as "board_error", "board_reset", "event"
  std::string message{};               ///< for people
  const AnyMessage* report = nullptr;  ///< what the board has sent, if anything; valid in the call
};

/// Maintains the connection to one gimbal and its telemetry, forever. It runs on its own strand, so
/// that it delays no other gimbal: handlers must not block.
class Gimbal {
 public:
  using Time = std::chrono::system_clock::time_point;
  using OnStatus = std::function<void(const GimbalStatus&)>;
  using OnTelemetry = std::function<void(const AnyMessage&, Time)>;
  using OnEvent = std::function<void(const GimbalEvent&, Time)>;

  Gimbal(Io& io, const FleetGimbal& settings);
  Gimbal(const Gimbal&) = delete;
  Gimbal& operator=(const Gimbal&) = delete;
  ~Gimbal();

  const std::string& name() const noexcept;
  const FleetGimbal& settings() const noexcept;
  /// The strand on which handlers run, and completions of client().
  asio::any_io_executor executor() const;

  // Before start(). Several handlers are called in order.
  void on_status(OnStatus handler);
  void on_telemetry(OnTelemetry handler);
  void on_event(OnEvent handler);

  void start();
  /// Closes the line; handlers do not run afterwards, but operations begun with client() complete
  /// until Io::finish() returns. May be called from any thread except those of Io, like the
  /// destructor, which also waits for a line that is being opened.
  void close();

  /// On the strand.
  void set_stopping(bool is_stopping);

  // On any thread.

  GimbalStatus status() const;
  GimbalCounters counters() const;
  /// For tasks and calls: async_run(), async_call(), SpeedControl. An operation fails at once while
  /// the gimbal is not online: nothing waits for a connection.
  AsyncClient& client() noexcept;

 private:
  class Impl;

  std::shared_ptr<Impl> impl_;
};

}  // namespace sbgc::tools
