// Fuzzes the hosts of the emulator and the bridge: bytes in any pieces from several hosts, as they
// arrive over TCP, and datagrams from any addresses, as over UDP. The input is a sequence of steps,
// each an opcode byte and its operands; see Player::step() and Datagrams::step().
//
// Invariants: a port gets only the bytes of its host, in order; a host gets the bytes of its port;
// HTTP requests have no effect; no host sends more than there is room for; and no place is given to
// two hosts.

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <system_error>

#include <asio/io_context.hpp>

#include <sbgc/io/memory.hpp>

#include "hosts/datagram_hosts.hpp"
#include "hosts/host.hpp"
#include "hosts/without_http.hpp"
#include "input.hpp"

namespace {

using sbgc::Instant;
using sbgc::fuzz::Input;
using sbgc::fuzz::require;
using sbgc::hosts::DatagramHosts;

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t places = 3;

/// Ports that record what they get.
class Ports final : public sbgc::hosts::HostPorts {
 public:
  struct Port {
    std::function<void()> wake{};
    Bytes received{};
    Bytes output{};
    std::size_t room = 100;
    bool has_ended = false;
  };

  std::optional<std::size_t> connect(bool, std::function<void()> wake) override {
    if (ports.size() == places) return std::nullopt;
    const std::size_t number = ++last_;
    ports[number] = {.wake = std::move(wake)};
    return number;
  }
  void disconnect(std::size_t port) override { require(ports.erase(port) == 1); }
  void end_input(std::size_t port) override {
    require(!std::exchange(ports.at(port).has_ended, true));
  }
  void set_host_rate(std::size_t, std::uint32_t) override {}
  std::size_t queued_bytes(std::size_t) const override { return 0; }
  std::size_t room(std::size_t port) const override { return ports.at(port).room; }
  bool is_quiet(std::size_t port) const override { return ports.at(port).output.empty(); }
  void receive(std::size_t port, std::span<const std::uint8_t> bytes) override {
    Port& one = ports.at(port);
    require(!one.has_ended && bytes.size() <= one.room);
    one.room -= bytes.size();
    one.received.insert(one.received.end(), bytes.begin(), bytes.end());
  }
  std::span<const std::uint8_t> output(std::size_t port) const override {
    return ports.at(port).output;
  }
  void take(std::size_t port, std::size_t size) override {
    Bytes& output = ports.at(port).output;
    require(size <= output.size());
    output.erase(output.begin(), output.begin() + static_cast<std::ptrdiff_t>(size));
  }
  Instant now() const override { return {}; }

  std::map<std::size_t, Port> ports{};

 private:
  std::size_t last_ = 0;
};

bool is_request(const Bytes& bytes) {
  constexpr std::array<std::string_view, 9> methods{
      "GET ", "POST ", "PUT ", "HEAD ", "OPTIONS ", "DELETE ", "PATCH ", "CONNECT ", "TRACE "};
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  return std::ranges::any_of(methods, [&](auto method) { return text.starts_with(method); });
}

/// Hosts on lines in memory.
class Player {
 public:
  explicit Player(Input& input) : input_(input) {}
  Player(const Player&) = delete;
  Player& operator=(const Player&) = delete;
  ~Player() {
    for (auto& [number, peer] : peers_) peer.host->close();
    settle();
  }

  void play() {
    while (!input_.empty()) {
      step();
      settle();
      for (auto& [number, peer] : peers_) check(peer);
    }
  }

 private:
  /// A program at the other end of a line.
  struct Peer {
    std::shared_ptr<sbgc::hosts::Host> host{};
    std::unique_ptr<sbgc::io::Transport> line{};
    std::size_t port{};
    Bytes sent{};
    Bytes written{};  // by the port
    Bytes got{};
    std::array<std::uint8_t, 64> input{};
    bool is_writing = false;
    bool is_reading = false;
    bool has_closed = false;
    bool has_ended = false;
    std::error_code end{};
  };

  void step() {
    const std::uint8_t code = input_.byte();
    if (code % 8 == 0) return connect();
    if (peers_.empty()) return;
    auto place = peers_.begin();
    std::advance(place, code / 8U % peers_.size());
    Peer& peer = place->second;
    Ports::Port* const port = peer.has_ended ? nullptr : &ports_.ports.at(peer.port);
    switch (code % 8) {
      case 1:
      case 2: return write(peer, input_.bytes(input_.byte()));
      case 3: {  // like a web page
        constexpr std::array<std::string_view, 4> texts{"GET / HTTP/1.1\r\n", "POST /\r\n\r\n>",
                                                        "OPT", "TRACE"};
        const std::string_view text = texts[input_.byte() % texts.size()];
        return write(peer, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
      }
      case 4:
        if (port == nullptr) return;
        port->room += input_.byte();
        return port->wake();
      case 5: {
        if (port == nullptr) return;
        const auto bytes = input_.bytes(input_.byte());
        port->output.insert(port->output.end(), bytes.begin(), bytes.end());
        peer.written.insert(peer.written.end(), bytes.begin(), bytes.end());
        return port->wake();
      }
      case 6: return read(peer);
      default:
        if (code < 128) {
          peer.has_closed = true;
          peer.line->close();
        } else {
          peer.host->close();
          peer.has_ended = true;
        }
        return;
    }
  }

  void connect() {
    auto pair = sbgc::io::make_memory_pair(context_.get_executor(), {.capacity = 300});
    const std::size_t number = ++last_;
    const auto host =
        sbgc::hosts::Host::connect(ports_, sbgc::hosts::without_http(std::move(pair.second)));
    require((host == nullptr) == (ports_.ports.size() == places && open() == places));
    if (host == nullptr) return;
    Peer& peer = peers_[number];
    peer.host = host;
    peer.line = std::move(pair.first);
    peer.port = host->port();
    host->on_end = [&peer](std::error_code error) {
      require(!std::exchange(peer.has_ended, true));
      peer.end = error;
    };
    host->start();
  }

  std::size_t open() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(peers_, [](const auto& one) { return !one.second.has_ended; }));
  }

  static void write(Peer& peer, std::span<const std::uint8_t> bytes) {
    if (peer.is_writing || peer.has_closed || bytes.empty()) return;
    peer.is_writing = true;
    const std::size_t begin = peer.sent.size();
    peer.sent.insert(peer.sent.end(), bytes.begin(), bytes.end());
    const auto kept = std::make_shared<Bytes>(bytes.begin(), bytes.end());
    peer.line->async_write(*kept, [&peer, kept, begin](std::error_code error, std::size_t size) {
      peer.is_writing = false;
      if (error) peer.sent.resize(begin + size);
    });
  }

  static void read(Peer& peer) {
    if (peer.is_reading || peer.has_closed) return;
    peer.is_reading = true;
    peer.line->async_read(peer.input, [&peer](std::error_code, std::size_t size) {
      peer.is_reading = false;
      peer.got.insert(peer.got.end(), peer.input.begin(),
                      peer.input.begin() + static_cast<std::ptrdiff_t>(size));
    });
  }

  void settle() {
    context_.restart();
    context_.poll();
  }

  void check(const Peer& peer) const {
    const auto begins_with = [](const Bytes& all, const Bytes& part) {
      return part.size() <= all.size() && std::equal(part.begin(), part.end(), all.begin());
    };
    require(begins_with(peer.written, peer.got));
    require(!sbgc::hosts::is_http_request(peer.end) || is_request(peer.sent));
    if (peer.has_ended) return;
    const Ports::Port& port = ports_.ports.at(peer.port);
    require(begins_with(peer.sent, port.received));
    require(!is_request(peer.sent) || port.received.empty());
  }

  Input& input_;
  asio::io_context context_{1};
  Ports ports_{};
  std::map<std::size_t, Peer> peers_{};
  std::size_t last_ = 0;
};

/// Hosts that send datagrams, from many addresses.
class Datagrams {
 public:
  explicit Datagrams(Input& input) : input_(input) {}

  void play() {
    while (!input_.empty()) {
      step();
      check();
    }
  }

 private:
  void step() {
    const std::uint8_t code = input_.byte();
    now_ = now_ + sbgc::milliseconds(100) * (code / 64);
    if (code % 64 == 0) {
      now_ = now_ + sbgc::seconds(input_.byte());
      while (const auto gone = hosts_.forget(now_)) {
        require(now_ - gone->heard >= DatagramHosts::idle_time);
        leave(*gone);
      }
      return;
    }
    const asio::ip::udp::endpoint from(asio::ip::address_v4(0x7F000001), code % 64U);
    if (const auto* const known = hosts_.find(from)) {
      require(known->endpoint == from && ports_.contains(known->port));
      return hosts_.hear(from, now_);
    }
    if (hosts_.is_full()) {
      const auto gone = hosts_.make_room(from, now_);
      if (!gone) {
        strangers_.insert(from);
        return;
      }
      const auto safe = gone->is_known ? DatagramHosts::safe_again : DatagramHosts::safe_once;
      require(now_ - gone->heard >= safe || (!gone->is_known && strangers_.contains(from)));
      strangers_.insert(gone->endpoint);
      leave(*gone);
    }
    std::size_t port = 0;
    while (!ports_.insert(port).second) ++port;
    hosts_.add(from, port, now_);
    if (code % 2 == 0) hosts_.answer(from, now_);
  }

  void leave(const DatagramHosts::Host& host) {
    require(ports_.erase(host.port) == 1);
    require(hosts_.find(host.endpoint) == nullptr);
  }

  void check() const {
    require(hosts_.all().size() <= places && ports_.size() == hosts_.all().size());
  }

  Input& input_;
  DatagramHosts hosts_{places};
  std::set<std::size_t> ports_{};
  std::set<asio::ip::udp::endpoint> strangers_{};  // refused or replaced before
  Instant now_{1'000'000};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input({data, size});
  if (input.byte() % 4 == 0) {
    Datagrams(input).play();
  } else {
    Player(input).play();
  }
  return 0;
}
