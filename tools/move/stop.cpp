// sbgc stop: stops the camera. Never asks.

#include "move/stop.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <poll.h>

#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "move/moving_gimbal.hpp"

namespace sbgc::tools {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds usual_time{10'000};
/// The minimum time for a connection attempt.
constexpr std::chrono::milliseconds least_time{1'000};
constexpr std::chrono::milliseconds pause{100};

/// Reports the present action each second, on its own thread, which also ends the process when a
/// signal requests it: the attempts block.
class Reporter {
 public:
  Reporter() : thread_([this](const std::stop_token& end) { run(end); }) {
    std::signal(SIGHUP, SIG_IGN);  // a closing terminal must not keep the camera turning
  }
  Reporter(const Reporter&) = delete;
  Reporter& operator=(const Reporter&) = delete;
  ~Reporter() = default;

  void now(std::string what) {
    const std::lock_guard lock(mutex_);
    what_ = std::move(what);
  }

 private:
  void run(const std::stop_token& end) {
    constexpr std::chrono::milliseconds interval{1'000};
    constexpr std::chrono::milliseconds look{50};
    auto next = Clock::now() + interval;
    pollfd signal{.fd = interruption_descriptor(), .events = POLLIN, .revents = 0};
    while (!end.stop_requested()) {
      if (::poll(&signal, 1, static_cast<int>(look.count())) > 0) leave();
      if (Clock::now() < next) continue;
      next += interval;
      const std::lock_guard lock(mutex_);
      remark_failure("not stopped yet: " + what_);
    }
  }
  [[noreturn]] static void leave() {
    remark_failure("interrupted: the camera may still turn");
    background_stderr().finish();
    std::_Exit(interrupted);
  }

  const Interruption interruption_;
  std::mutex mutex_;
  std::string what_ = "connecting";
  std::jthread thread_;
};

/// True if retrying is pointless. `detail` is the error number of the system. A device that was
/// there comes back when it is plugged in again, at first without permissions.
bool is_hopeless(const ClientError& error, bool was_there) {
  constexpr std::array causes{EACCES, EPERM, ENOENT, ENODEV, ENXIO, ENOTTY};
  return error.code == ErrorCode::invalid || error.code == ErrorCode::unsupported ||
         (!was_there && std::ranges::count(causes, error.detail) != 0);
}

}  // namespace

void add_insistence(CLI::App& command, std::optional<std::chrono::milliseconds>& time) {
  const auto read = [](const std::string& text) {
    return text == "0" ? std::chrono::milliseconds(0) : parse_duration(text);
  };
  command
      .add_option(
          "--for",
          [&time, read](const CLI::results_t& texts) {
            time = read(texts.front());
            return time.has_value();
          },
          "How long to retry while the board does not answer; 10s by default, 0 for once")
      ->check([read](const std::string& text) {
        return read(text) ? std::string()
                          : fmt::format("'{}' is not a duration; write 0, 1.5s or 2m", text);
      })
      ->type_name("TIME");
}

Client insist(const LineChoice& line, OwedStop owed,
              std::optional<std::chrono::milliseconds> time) {
  const bool is_once = time && time->count() == 0;
  const auto end = Clock::now() + time.value_or(usual_time);
  Reporter reporter;
  std::optional<Client> client;
  ClientError last;
  bool was_there = false;  // the device of the line
  do {
    if (!client) {
      ConnectOptions options = line.options;
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now());
      if (!is_once) options.timeout = std::min(options.timeout, std::max(left, least_time));
      Result<Client> connected = Client::connect(line.address, options);
      if (!connected) {
        last = connected.error();
        if (is_hopeless(last, was_there)) fail(last);
        was_there = true;
        reporter.now(last.message);
        std::this_thread::sleep_for(pause);
        continue;
      }
      client.emplace(*std::move(connected));
      was_there = true;
      reporter.now("waiting for the board");
    }
    const auto began = Clock::now();
    const Result<void> ended = client->run(owed.attempt());
    const OwedStop::State state = owed.take(ended, began);
    if (state == OwedStop::State::done) return *std::move(client);
    last = ended.error();
    if (state == OwedStop::State::failed) fail(last);
    reporter.now(last.message);
    if (last.code == ErrorCode::link_lost || last.code == ErrorCode::not_connected) client.reset();
  } while (!is_once && Clock::now() < end);
  fail(last);
}

namespace {

struct StopCommand {
  std::optional<std::chrono::milliseconds> time{};
};

int stop_camera(const StopCommand& command, const CommandContext& context) {
  remark_in_background();
  Client client = insist(choose_line(context.gimbal), OwedStop(), command.time);
  const Result<bool> has_power = are_motors_on(client);
  remark("The camera has stopped{}.\n", !has_power   ? ""
                                        : *has_power ? "; its motors hold it"
                                                     : "; its motors are off");
  return success;
}

}  // namespace

void add_stop(CLI::App& app, CommandContext& context) {
  const Subcommand<StopCommand> command(app, context, "stop", "Stop the camera, without asking");
  add_insistence(*command, command.options().time);
  command->footer(
      "Commands speed 0 on all axes until the board has reported for half a second that no axis "
      "turns. While the board does not answer, the command retries. The motors keep their power. "
      "If the camera shakes or does not stop, use `sbgc motors off` or the battery switch: the "
      "camera then drops to its heavy side.\n"
      "\n"
      "The exit status is 0 if the camera has stopped, 1 if not or if something else turns it, 2 "
      "for wrong usage, 130 after Ctrl-C.");
  command.examples({"sbgc stop", "sbgc stop --for 1m"});
  command.runs(stop_camera);
}

}  // namespace sbgc::tools
