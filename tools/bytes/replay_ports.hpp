/// A capture in place of a board, for several hosts.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <asio/steady_timer.hpp>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/transport.hpp>

#include "hosts/endpoint.hpp"

namespace sbgc::tools {

/// Gives all hosts what a board sent, from the moment when the first one connects, and ignores what
/// they send. The capture waits for slow hosts; one that does not read must leave.
class ReplayPorts final : public hosts::HostPorts {
 public:
  /// `on_end` is called once all bytes have been given and all hosts have taken them or left. `log`
  /// receives sentences for the user.
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

}  // namespace sbgc::tools
