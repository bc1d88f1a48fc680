/// The client of a page: a PassiveClient that collects reports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <sbgc/client/passive_client.hpp>

#include "look/monitor/live_values.hpp"
#include "modules/json_writer.hpp"

namespace sbgc::web {

/// The state of the gimbal as numbers, in the order of `View` in src/worker_messages.ts.
struct View {
  double seconds = 0;
  Axes<double> camera{}, targets{}, frame{}, joints{}, speeds{}, power{};
  double volts = 0, amperes = 0, motors_on = 0, profile = 0;
  double count = 0;  ///< of the messages that it has been taken from
};

class Client {
 public:
  Client();

  PassiveClient& passive() { return client_; }
  const View& view() const { return view_; }

  /// Identifies the board, reports its versions, and then watches it. With `searches`, finds the
  /// settings of the line first, and reports each that it tries.
  void connect(double id, bool searches);
  /// Makes moves and turns end by themselves when no more commands reach the board, and yield when
  /// somebody else has stopped the camera.
  void bound_moves() { bounds_moves_ = true; }
  bool bounds_moves() const { return bounds_moves_; }
  /// Begins an action, which is described in actions.hpp. Returns what is wrong with its text.
  std::string act(double id, std::string_view action, Instant now);
  /// Sends the request in a frame. Returns what is wrong with it.
  std::string send(double id, std::span<const std::uint8_t> bytes);
  /// Measures the gimbal for five seconds.
  void diagnose(double id);
  /// Takes the reports since the last time: a line of JSON for each.
  std::string take_reports() { return std::exchange(reports_, {}); }

  // For actions.

  /// Starts a task whose result is reported under this id.
  template <class R>
  void start(double id, Task<R> task) {
    client_.start(std::move(task), [this, id](const auto& result) {
      report_end(id, result ? "" : result.error().message);
    });
  }
  /// Turns with these speeds for some time, unless another motion begins. If no more commands reach
  /// the board, it brakes within half a second.
  void turn(double id, const Axes<msg::ControlSpeed>& speed, Instant now, Duration time);
  /// Writes members of an object.
  using Members = std::function<void(JsonWriter&)>;
  /// Writes a report.
  void report(const Members& members);
  void report(const char* name, std::string_view text);
  /// Reports the end of a task; `more` writes further members.
  void report_end(double id, std::string_view error, const Members& more = {});

 private:
  void take(const tools::LiveValues& values);
  void identify(double id);
  Task<Result<void>> watch();

  struct Held;

  std::shared_ptr<Held> held_{};  // outlives the task that turns with it
  PassiveClient client_{};
  Subscription notices_{};
  View view_{};
  std::string errors_{"\n"};  // the last reported errors; at first something else
  std::string reports_{};
  bool bounds_moves_ = false;
};

/// The client of the module, once there is one.
std::optional<Client>& client();

}  // namespace sbgc::web
