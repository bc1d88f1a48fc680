// Fuzzes the core of the bridge with any bytes of several hosts, and any frames of the board. The
// input is a sequence of steps, each an opcode byte and its operands; see Player::step().
//
// Invariants: the board gets only the complete requests of each host, in order; each host gets
// complete frames, and only the responses to its own requests; the queues are limited; and when the
// other hosts have left, a host is served. Hosts that must leave are not busy.

#include <deque>
#include <map>

#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

#include "input.hpp"
#include "share/bridge_ports.hpp"

namespace {

using sbgc::Frame;
using sbgc::Instant;
using sbgc::RawRequest;
using sbgc::fuzz::Input;
using sbgc::fuzz::require;
using sbgc::tools::BridgePorts;
using sbgc::tools::HostPlaces;

namespace msg = sbgc::msg;
namespace roles = sbgc::roles;

using Bytes = std::vector<std::uint8_t>;

struct Packet {
  std::uint8_t id{};
  Bytes body{};

  bool operator==(const Packet&) const = default;
};

Packet packet_of(const Frame& frame) { return {frame.id, {frame.body.begin(), frame.body.end()}}; }

Packet packet_of(const RawRequest& request) {
  return {request.id, {request.body.data(), request.body.data() + request.body.size()}};
}

/// The bridge merges the data streams of its hosts, so these requests are its own.
bool is_stream_request(const Packet& request) {
  return request.id == static_cast<std::uint8_t>(roles::StreamRequest::command);
}

/// The board's side of the bridge.
class Board final : public sbgc::tools::BridgeLine {
 public:
  struct Sent {
    std::uint64_t tag{};
    Packet request{};
  };

  void send(std::uint64_t tag, RawRequest request) override {
    open.push_back({tag, packet_of(request)});
    news.push_back(open.back());
  }
  void take_line() override {
    require(!is_taken);
    is_taken = true;
  }
  void write_raw(Bytes bytes) override {
    require(is_taken);
    waiting += bytes.size();
  }
  std::size_t raw_waiting() const override { return waiting; }
  void release_line() override { give_line_back(); }
  void give_line_back() override {
    require(is_taken);
    is_taken = false;
    waiting = 0;
  }
  void check() override {}
  void take_over(sbgc::tools::OwedStop) override {}
  void drop_stops() override {}

  std::deque<Sent> open;   // requests that have not ended
  std::vector<Sent> news;  // requests since the last step
  bool is_taken = false;
  std::size_t waiting = 0;
};

class Player {
 public:
  explicit Player(std::span<const std::uint8_t> input) : input_(input) {}

  void play() {
    while (!input_.empty()) {
      step();
      check();
      close_leaving();
    }
    serve_a_new_host();
  }

 private:
  struct Host {
    sbgc::ParserOfAll parser{};  // of what it has sent
    sbgc::ParserOfAll reader{};  // of what it has got
    std::deque<Packet> expected{};
    Instant heard{};
    bool had_line = false;  // raw bytes are no frames
  };

  void step() {
    const std::uint8_t code = input_.byte();
    const std::size_t port = code / 16U % 4;
    switch (code % 16) {
      case 0:
        for (std::size_t i = 0; i < (port == 0 ? 1 : HostPlaces::max_hosts / 2); ++i) connect();
        break;
      case 1: disconnect(port); break;
      case 2:
      case 3: receive(port, input_.bytes(input_.byte())); break;
      case 4:
      case 5:
      case 6: {  // any frame
        const std::uint8_t id = input_.byte();
        receive_frame(port, id, input_.bytes(input_.byte() % 64));
        break;
      }
      case 7: {  // a data stream
        msg::DataStreamInterval request;
        request.cmd_id = static_cast<msg::CommandFromBoard>(code < 128 ? 23 : input_.byte());
        request.interval_ms = msg::Milliseconds(input_.byte());
        std::array<std::uint8_t, sbgc::max_body_size> body{};
        const std::size_t size = sbgc::encode(request, std::span(body)).size;
        receive_frame(port, 85, std::span(body).first(size));
        break;
      }
      case 8:
      case 9: answer(input_.byte()); break;
      case 10: end(false); break;
      case 11: end(true); break;
      case 12: {  // the board sends by itself
        const std::uint8_t id = input_.byte();
        const auto body = input_.bytes(input_.byte());
        const std::uint8_t how = input_.byte();
        if (id != 0) {
          ports_.arrived({.frame = {.id = id, .body = body},
                          .is_late = (how & 1) != 0,
                          .sample = static_cast<sbgc::Sample>((how >> 1U) & 3U)});
        }
        break;
      }
      case 13: pass(sbgc::milliseconds(10) * input_.byte()); break;
      case 14: take(port, input_.byte() * std::size_t{16}); break;
      default: interrupt(code / 16U); break;
    }
  }

  void interrupt(unsigned what) {
    switch (what) {
      case 0: {  // the line is lost and found
        for (const Board::Sent& one : std::exchange(board_.open, {})) {
          owners_.erase(one.tag);
          ports_.ended(one.tag);
        }
        board_.is_taken = false;
        static_cast<void>(ports_.line_lost());
        ports_.restart_streams();
        break;
      }
      case 1: ports_.raw_arrived(input_.bytes(input_.byte())); break;
      case 2:
        board_.waiting = 0;
        ports_.raw_sent();
        break;
      case 3: {
        const Bytes much(4096, 0x55);
        ports_.raw_arrived(much);
        break;
      }
      case 4: pass(sbgc::seconds(input_.byte())); break;
      default: {
        const std::size_t port = what % 4;
        if (!hosts_.contains(port)) break;
        flush(port);
        ports_.end_input(port);
        break;
      }
    }
  }

  /// Lets time pass; silence ends incomplete frames.
  void pass(sbgc::Duration time) {
    now_ = now_ + time;
    for (const auto& [port, host] : hosts_) {
      if (now_ - host.heard > BridgePorts::idle) flush(port);
    }
    ports_.tick();
  }

  void flush(std::size_t port) {
    hosts_[port].parser.flush([&](const Frame& frame) { expect(port, frame); });
  }

  void connect() {
    const auto port = ports_.connect(false, [] {});
    require(port.has_value() || hosts_.size() >= 2 * HostPlaces::max_hosts);
    if (port) require(hosts_.try_emplace(*port).second);
    close_leaving();
    require(hosts_.size() <= 2 * HostPlaces::max_hosts);
  }

  void disconnect(std::size_t port) {
    if (hosts_.erase(port) == 0) return;
    for (Board::Sent& one : board_.open) {
      if (owner(one.tag) == port) owners_.erase(one.tag);
    }
    ports_.disconnect(port);
  }

  /// Closes hosts as their endpoints do.
  void close_leaving() {
    std::vector<std::size_t> leaving;
    for (const auto& [port, host] : hosts_) {
      if (ports_.must_leave(port)) leaving.push_back(port);
    }
    for (const std::size_t port : leaving) disconnect(port);
  }

  bool may_send(std::size_t port) const { return ports_.room(port) != 0; }

  /// A host sends no more than there is room for; its endpoint ensures that.
  void receive(std::size_t port, std::span<const std::uint8_t> bytes) {
    if (!hosts_.contains(port)) return;
    while (!bytes.empty() && may_send(port)) {
      const auto part = bytes.first(std::min(bytes.size(), ports_.room(port)));
      bytes = bytes.subspan(part.size());
      Host& host = hosts_[port];
      host.had_line = host.had_line || ports_.exclusive_host() == port;
      host.heard = now_;
      host.parser.feed(part, [&](const Frame& frame) { expect(port, frame); });
      ports_.receive(port, part);
      check();
    }
  }

  void receive_frame(std::size_t port, std::uint8_t id, std::span<const std::uint8_t> body) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    const auto written = sbgc::write_frame(sbgc::basic_framing, id, body, frame);
    if (written) receive(port, std::span(frame).first(written.size));
  }

  void expect(std::size_t port, const Frame& frame) {
    hosts_[port].expected.push_back(packet_of(frame));
  }

  /// Each new request at the board is the next one of a host.
  void check() {
    for (const Board::Sent& one : std::exchange(board_.news, {})) {
      if (is_stream_request(one.request)) continue;
      const auto owner = std::ranges::find_if(hosts_, [&](const auto& host) {
        const auto& expected = host.second.expected;
        return std::ranges::find(expected, one.request) != expected.end();
      });
      require(owner != hosts_.end());
      owners_[one.tag] = owner->first;
      auto& expected = owner->second.expected;
      const auto place = std::ranges::find(expected, one.request);
      expected.erase(expected.begin(), place + 1);
    }
    if (const auto exclusive = ports_.exclusive_host()) hosts_.at(*exclusive).had_line = true;
    for (const auto& [port, host] : hosts_) {
      const std::size_t most =
          host.had_line ? BridgePorts::max_raw_output : BridgePorts::max_output;
      require(ports_.output(port).size() <=
              most + BridgePorts::max_requests * sbgc::max_frame_size);
    }
    require(board_.open.size() <= hosts_.size() * (BridgePorts::max_requests + 1) + unowned());
  }

  /// Requests of hosts that have left, and those of the bridge itself.
  std::size_t unowned() const { return board_.open.size() - owners_.size(); }

  std::optional<std::size_t> owner(std::uint64_t tag) const {
    const auto place = owners_.find(tag);
    return place == owners_.end() ? std::nullopt : std::optional(place->second);
  }

  /// The board answers its oldest request, with a body that nothing else has.
  void answer(std::uint8_t size) {
    if (board_.open.empty()) return;
    const Board::Sent& asked = board_.open.front();
    Bytes body(8 + size % 64);
    const std::uint64_t mark = ++answers_;
    for (std::size_t i = 0; i < 8; ++i) {
      body[i] = static_cast<std::uint8_t>(mark >> (8 * i));
    }
    const std::uint8_t id = asked.request.id;
    const Frame frame{.id = id, .body = body};
    const auto port = owner(asked.tag);
    std::map<std::size_t, std::size_t> before;
    for (const auto& [each, host] : hosts_) before[each] = ports_.output(each).size();
    ports_.answered(asked.tag, frame);
    ports_.arrived({.frame = frame, .belongs_to_call = true});
    for (const auto& [each, host] : hosts_) {
      if (is_stream_request(asked.request)) continue;
      require((ports_.output(each).size() != before[each]) == (port == each));
    }
    end(false);
  }

  void end(bool timed_out) {
    if (board_.open.empty()) return;
    const std::uint64_t tag = board_.open.front().tag;
    board_.open.pop_front();
    owners_.erase(tag);
    ports_.ended(tag, timed_out ? std::optional(sbgc::ErrorCode::timeout) : std::nullopt);
  }

  /// A host reads, whole frames unless it had the line for itself.
  void take(std::size_t port, std::size_t most) {
    if (!hosts_.contains(port)) return;
    Host& host = hosts_[port];
    const auto waiting = ports_.output(port);
    const auto part = waiting.first(std::min(most, waiting.size()));
    host.had_line = host.had_line || ports_.exclusive_host() == port;
    host.reader.feed(part, [](const Frame&) {});
    require(host.had_line || host.reader.counters().skipped_bytes == 0);
    ports_.take(port, part.size());
  }

  void serve_a_new_host() {
    while (!hosts_.empty()) disconnect(hosts_.begin()->first);
    while (!board_.open.empty()) end(false);
    // The bridge continues a restart whose host has left.
    pass(BridgePorts::restart_time * 3);
    require(!board_.is_taken && !ports_.exclusive_host());
    connect();
    const std::size_t port = hosts_.begin()->first;
    receive_frame(port, static_cast<std::uint8_t>(msg::GetAnglesRequest::command), {});
    check();
    require(board_.open.size() == 1);
    answer(0);
    require(!ports_.output(port).empty());
  }

  Input input_;
  Board board_;
  Instant now_{1'000'000};
  BridgePorts ports_{board_, [this] { return now_; }};
  std::map<std::size_t, Host> hosts_{};
  std::map<std::uint64_t, std::size_t> owners_{};  // of the open requests, by tag
  std::uint64_t answers_ = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player({data, size}).play();
  return 0;
}
