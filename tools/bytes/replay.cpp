// sbgc replay: serves a capture in place of a board.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/replay.hpp>
#include <sbgc/io/transport.hpp>

#include "board/capture_check.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "hosts/endpoint.hpp"
#include "share/places.hpp"

namespace sbgc::tools {

namespace {

/// Sends all hosts the recorded bytes of a board, starting when the first one connects, and ignores
/// their requests. The capture waits for slow hosts; one that does not read is disconnected.
class ReplayPorts final : public hosts::HostPorts {
 public:
  /// `on_end` is called once all bytes have been sent and all hosts have received them or left.
  /// `log` receives sentences for the user.
  ReplayPorts(std::unique_ptr<io::Transport> capture, std::function<void()> on_end,
              std::function<void(const std::string&)> log)
      : capture_(std::move(capture)),
        patience_(capture_->executor()),
        on_end_(std::move(on_end)),
        log_(std::move(log)) {}

  std::optional<std::size_t> connect(bool, std::function<void()> wake) override;
  void disconnect(std::size_t port) override;
  void end_input(std::size_t) override {}
  void set_host_rate(std::size_t, std::uint32_t) override {}
  std::size_t queued_bytes(std::size_t) const override { return 0; }
  std::size_t room(std::size_t) const override { return room_of_host; }
  bool is_quiet(std::size_t port) const override {
    return (has_ended_ || must_leave(port)) && output(port).empty();
  }
  bool must_leave(std::size_t port) const override { return hosts_.at(port).must_leave; }
  void receive(std::size_t, std::span<const std::uint8_t>) override {}
  std::span<const std::uint8_t> output(std::size_t port) const override;
  void take(std::size_t port, std::size_t size) override;
  Instant now() const override { return io::now(); }

 private:
  static constexpr std::size_t max_hosts = 32;
  static constexpr std::size_t max_output = std::size_t{1} << 20;
  static constexpr std::chrono::seconds longest_wait{5};
  static constexpr std::size_t room_of_host = 2048;

  struct Host {
    std::function<void()> wake{};
    std::vector<std::uint8_t> output{};
    bool must_leave = false;
  };

  void read();
  void read_on();
  /// True if the capture must wait for a host.
  bool is_full() const;
  void expel_full();
  void end_if_done();

  std::unique_ptr<io::Transport> capture_;
  asio::steady_timer patience_;
  std::function<void()> on_end_;
  std::function<void(const std::string&)> log_;
  std::array<std::uint8_t, 4096> buffer_{};
  std::map<std::size_t, Host> hosts_{};
  bool is_playing_ = false;
  bool is_waiting_ = false;
  bool has_ended_ = false;
};

std::optional<std::size_t> ReplayPorts::connect(bool, std::function<void()> wake) {
  std::size_t port = 0;
  while (hosts_.contains(port)) ++port;
  if (port >= max_hosts) return std::nullopt;
  hosts_[port].wake = std::move(wake);
  if (!std::exchange(is_playing_, true)) read();
  return port;
}

void ReplayPorts::disconnect(std::size_t port) {
  hosts_.erase(port);
  read_on();
  end_if_done();
}

std::span<const std::uint8_t> ReplayPorts::output(std::size_t port) const {
  return hosts_.at(port).output;
}

void ReplayPorts::take(std::size_t port, std::size_t size) {
  std::vector<std::uint8_t>& output = hosts_.at(port).output;
  output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(size));
  read_on();
  end_if_done();
}

void ReplayPorts::read() {
  capture_->async_read(buffer_, [this](std::error_code error, std::size_t size) {
    if (error) {
      has_ended_ = true;
      return end_if_done();
    }
    for (auto& [port, host] : hosts_) {
      if (host.must_leave) continue;
      host.output.insert(host.output.end(), buffer_.begin(),
                         buffer_.begin() + static_cast<std::ptrdiff_t>(size));
    }
    is_waiting_ = true;
    for (std::size_t port = 0; port < max_hosts; ++port) {
      const auto host = hosts_.find(port);
      if (host != hosts_.end() && host->second.wake) host->second.wake();
    }
    read_on();
    if (!is_waiting_) return;
    patience_.expires_after(longest_wait);
    patience_.async_wait([this](std::error_code cancelled) {
      if (!cancelled) expel_full();
    });
  });
}

void ReplayPorts::read_on() {
  if (!is_waiting_ || is_full()) return;
  is_waiting_ = false;
  patience_.cancel();
  read();
}

bool ReplayPorts::is_full() const {
  return std::ranges::any_of(hosts_, [](const auto& one) {
    return !one.second.must_leave && one.second.output.size() >= max_output;
  });
}

void ReplayPorts::expel_full() {
  for (auto& [port, host] : hosts_) {
    if (host.must_leave || host.output.size() < max_output) continue;
    host.must_leave = true;
    log_(fmt::format("host {} must leave: it does not read", port));
    host.wake();
  }
  read_on();
}

void ReplayPorts::end_if_done() {
  const bool is_taken =
      std::ranges::all_of(hosts_, [](const auto& one) { return one.second.output.empty(); });
  if (!has_ended_ || !is_taken) return;
  if (const auto on_end = std::exchange(on_end_, nullptr)) on_end();
}

/// The maximum number of hosts, for TCP and UDP each.
constexpr std::size_t places_of_each = 16;

struct ReplayOptions {
  std::string file;
  double speed = 1;
  Places places{};
};

int run_replay(const ReplayOptions& options) {
  asio::io_context loop(1);
  io::OpenResult capture =
      io::open_replay(loop.get_executor(), options.file, io::ReplayTiming::original, options.speed);
  if (!capture) throw CommandError(without_period(capture.error.message));
  const std::string damage = check_capture(options.file);
  remark_in_background();
  if (!damage.empty()) remark_warning(damage);
  const auto log = [](const std::string& text) { remark("sbgc: {}\n", text); };
  asio::signal_set signals(loop);
  for (const int signal : asking_signals()) signals.add(signal);
  signals.async_wait([&](std::error_code error, int) {
    if (!error) loop.stop();
  });
  ReplayPorts ports(
      std::move(capture.transport),
      [&] {
        // The hosts receive their last bytes first.
        asio::post(loop, [&] { loop.stop(); });
      },
      log);
  const auto endpoints =
      open_places(loop.get_executor(), ports, options.places, places_of_each, "replay", {log, log});
  loop.run();
  finish_stdout();
  return damage.empty() ? success : failure;
}

}  // namespace

void add_replay(CLI::App& app, CommandContext& context) {
  const Subcommand<ReplayOptions> command(app, context, "replay",
                                          "Serve a capture in place of a board");
  auto& options = command.options();
  command->add_option("file", options.file, "A capture, or the raw bytes of a board")
      ->type_name("FILE")
      ->required();
  command->add_option("--speed", options.speed, "Speed relative to the recording")
      ->check(number_range(0.001, 1000.0))
      ->capture_default_str();
  add_places(*command, options.places);
  command->footer(
      "Programs that connect get the bytes of the board at the recorded times, counted from the "
      "first connection; their own bytes are ignored. By default it opens a pseudo-terminal. For "
      "sbgc itself, the address capture:FILE does the same. The exit status is 0 after the end "
      "of the capture or Ctrl-C, 1 if the file is damaged, or has nothing to replay, or a place "
      "cannot be opened, 2 for wrong usage.");
  command.examples({"sbgc replay capture --tcp 5000"});
  command.runs([](ReplayOptions& chosen) {
    if (chosen.places.empty()) chosen.places.terminal = true;
    return run_replay(chosen);
  });
}

}  // namespace sbgc::tools
