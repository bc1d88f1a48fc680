#include "bytes/replay_ports.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

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

}  // namespace sbgc::tools
