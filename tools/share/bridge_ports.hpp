/// Shares one board between several hosts, without I/O.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/error.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/roles.hpp>

#include "hosts/endpoint.hpp"
#include "hosts/fewer_reports.hpp"
#include "share/bridge_hosts.hpp"

namespace sbgc::tools {

/// The board's side of a bridge.
class BridgeLine {
 public:
  BridgeLine() = default;
  BridgeLine(const BridgeLine&) = delete;
  BridgeLine& operator=(const BridgeLine&) = delete;
  virtual ~BridgeLine() = default;

  /// Sends a request. Its frames and its end are reported with the same tag, but not from inside
  /// this call.
  virtual void send(std::uint64_t tag, RawRequest request) = 0;

  /// Takes the line for raw bytes. From now on, only the bytes of write_raw() are sent, and
  /// received bytes are reported unchanged.
  virtual void take_line() = 0;
  virtual void write_raw(std::vector<std::uint8_t> bytes) = 0;
  /// Returns how many of these bytes have not been sent yet.
  virtual std::size_t raw_waiting() const = 0;
  /// Ends raw mode when the bytes have been sent: reconnects to the board.
  virtual void give_line_back() = 0;
  /// Ends raw mode at once; the connection continues. Precondition: no bytes are waiting.
  virtual void release_line() = 0;

  /// Checks that the board is alive; if not, reconnects.
  virtual void check() = 0;

  /// Continues a stop until it is done.
  virtual void take_over(OwedStop stop) = 0;
  /// A host moves the camera: stops that were taken over are obsolete.
  virtual void drop_stops() = 0;
};

/// Passes to each host the responses to its own requests, the samples of the data streams that it
/// has requested, and all unsolicited messages.
///
/// - A response that arrives after its request has ended still goes to the host that sent it; see
/// RequestOwners.
/// - The bodies of requests and responses pass unchanged; a response is rewritten in the framing of
///   its request, other messages in that of the last request of the host.
/// - The board gets the shortest interval that a host wants for a data stream; each host gets every
///   sample that is due at its own interval. The share of a host ends when it leaves.
/// - The messages of a stream do not identify their configuration. Therefore a stream has one
/// configuration at a time: while it runs, a request for another one gets an error instead of a
/// confirmation. So does one for which the line has no bandwidth.
/// - A single answer goes only to the host that requested it, even while others stream the same
/// message; the session distinguishes it from the samples. If a stream leaves no time for that, the
/// request gets an error.
/// - If a host sends faster than the board executes, the bridge reads it more slowly. A host that
/// does not read loses samples and unsolicited messages, and does not affect others.
/// - A stop drops the queued motion of all hosts; they get an error (WRONG_STATE). If its host
/// leaves before it is done, the bridge continues it.
/// - Other failed requests get no response, as on a line to the board.
/// - If all places are taken, silent hosts are replaced; see HostPlaces. A host that gets a stream,
/// awaits an answer or has exclusive use of the line is not silent.
/// - After a request that restarts the board, its host has exclusive use of the line, with all
/// bytes unchanged, because a bootloader uses another protocol. The others wait until the host has
/// left, the board introduces itself again, or none of this happens in time. The board does not
/// wait: an exclusive host that does not read must leave.
/// - After a plain restart, until the host sends bytes other than requests, the bridge checks
/// whether the board is alive: the others wait only while it does not answer, also after the host
/// has left, and the connection continues. A request that arrives before the board goes down gets
/// an error.
class BridgePorts final : public hosts::HostPorts {
 public:
  static constexpr std::size_t max_ports = HostPlaces::max_ports;
  /// The maximum number of open requests of one host.
  static constexpr std::size_t max_requests = 16;
  /// The maximum number of waiting bytes for one host.
  static constexpr std::size_t max_output = 65536;
  /// The silence of a host that ends an incomplete frame.
  static constexpr Duration idle = sbgc::milliseconds(100);
  /// The time for which a host that restarts the board has exclusive use of the line without
  /// sending raw bytes; the additional time for which a board may be silent after a plain restart.
  static constexpr Duration restart_time = sbgc::seconds(5);
  /// A board that does not answer for this long is down.
  static constexpr Duration longest_answer = sbgc::milliseconds(200);
  /// A board that has announced its restart still responds for this long.
  static constexpr Duration restart_delay = sbgc::milliseconds(roles::reset_delay_ms + 500);
  /// Samples may still arrive for this long after a stream was ended.
  static constexpr Duration end_of_stream_time = sbgc::seconds(1);
  /// The silence of a data stream after which it is restarted, at least three intervals: a board
  /// that has lost its power for a moment has lost its streams.
  static constexpr Duration silence_of_stream = sbgc::seconds(3);
  static constexpr Duration longest_silence = sbgc::seconds(60);
  /// After this many requests without any response, the bridge checks that the board is alive.
  static constexpr int most_unanswered = 3;
  /// The maximum number of waiting bytes from a host with exclusive use of the line.
  static constexpr std::size_t max_raw = 4096;
  /// The maximum number of bytes waiting for it: over a minute of a board at 115200 baud.
  static constexpr std::size_t max_raw_output = std::size_t{1} << 20;

  struct HostCounters {
    std::size_t port{};
    std::uint64_t requests{};
    std::uint64_t messages{};  ///< sent to it
    std::uint64_t dropped{};   ///< because it does not read
  };

  /// `log` receives sentences for the user. A password unlocks the port of the board for all hosts,
  /// so a request with one is rejected unless `allows_passwords`.
  explicit BridgePorts(BridgeLine& line, std::function<Instant()> clock = io::now,
                       std::function<void(const std::string&)> log = {},
                       bool allows_passwords = false)
      : line_(line),
        clock_(std::move(clock)),
        log_(std::move(log)),
        allows_passwords_(allows_passwords) {}

  // The hosts' side.

  std::optional<std::size_t> connect(bool is_usb, std::function<void()> wake) override;
  void keep_place(std::size_t port) override { places_.keep(port); }
  void disconnect(std::size_t port) override;
  void end_input(std::size_t port) override;
  void set_host_rate(std::size_t, std::uint32_t) override {}
  std::size_t queued_bytes(std::size_t port) const override;
  std::size_t room(std::size_t port) const override;
  bool is_quiet(std::size_t port) const override;
  bool must_leave(std::size_t port) const override { return hosts_[port]->must_leave; }
  void receive(std::size_t port, std::span<const std::uint8_t> bytes) override;
  std::span<const std::uint8_t> output(std::size_t port) const override;
  void take(std::size_t port, std::size_t size) override;
  Instant now() const override { return clock_(); }

  // The board's side.

  /// Passes on a frame that belongs to the request with this tag.
  void answered(std::uint64_t tag, const Frame& frame);
  /// Reports that the request has ended, with this error if it has failed.
  void ended(std::uint64_t tag, std::optional<ErrorCode> failure = {});
  /// Must be called with every frame of the board, including those of answered().
  void arrived(const BoardFrame& message);
  /// The board has reconnected and has no data streams: starts those that hosts want.
  void restart_streams();
  /// Processes bytes that arrive while the line is taken.
  void raw_arrived(std::span<const std::uint8_t> bytes);
  /// Reports that bytes of write_raw() have been sent.
  void raw_sent();
  /// The line is lost. Returns false if it is only reopened after a host had exclusive use of it.
  bool line_lost();
  /// Returns the host with exclusive use of the line.
  std::optional<std::size_t> exclusive_host() const;
  /// Performs due actions: ends incomplete frames of silent hosts, restarts silent data streams,
  /// and gives the line back. Must be called regularly.
  void tick();

  std::vector<HostCounters> counters() const;

 private:
  struct Host {
    std::uint16_t id{};  // of no earlier host
    std::function<void()> wake{};
    ParserOfAll parser{};
    Framing framing = basic_framing;
    Instant heard{};
    Instant told{};  // when it has taken bytes
    std::vector<std::uint8_t> output{};
    std::size_t pending = 0;
    bool must_leave = false;
    HostCounters counters{};
  };
  /// Identifies a data stream by the id of its messages and its configuration.
  using StreamKey = std::pair<std::uint8_t, std::array<std::uint8_t, max_stream_config>>;
  struct Call {
    RequestOwner asker{};
    std::uint8_t id{};
    bool is_due_soon{};                 // the answer to it
    std::optional<StreamKey> stream{};  // that it starts, changes or ends
  };
  /// The part of one host in the stream.
  struct Share {
    std::int64_t interval{};  // in counts of the request
    std::int64_t before{};    // the previous one, restored if a change is refused; or 0
    std::int64_t credit{};    // the time since its last sample, in microseconds
    std::uint64_t end{};      // the request that ends it; or 0
  };
  struct Stream {
    std::uint8_t size{};  // of the bodies of its messages
    RawRequest request{};
    std::map<std::size_t, Share> shares{};  // by port
    Instant heard{};                        // the last sample, or its last start
    bool is_started_again = false;          // since its last sample
    std::uint64_t starting{};               // the request that must end before samples arrive; or 0
    bool is_wanted() const;                 // by a host that has not asked for its end
    std::int64_t interval() const;          // 0 if nobody wants it
    std::int64_t pace() const;              // interval until the board has made all changes
  };
  using Streams = std::map<StreamKey, Stream>;

  /// A host with exclusive use of the line, or waiting for it until the others have their answers.
  struct Exclusive {
    std::size_t port{};  // max_ports after it has left
    bool is_active = false;
    bool is_plain = false;              // the board uses the same protocol afterwards
    bool is_raw = false;                // it has sent bytes that are not requests
    bool is_back = false;               // the board has introduced itself
    std::vector<std::uint8_t> first{};  // bytes received before it has the line
    Instant begin{};
    Instant last{};  // when bytes passed
    ParserOfAll from_board{};
    // The command that restarts the board.
    std::uint8_t command{};
    std::deque<bool> introductions{};           // requested introductions; true: by the bridge
    Instant unanswered_since = Instant::never;  // the first request for a sign of life
    bool is_alive = false;
    bool was_down = false;

    bool is_watched() const { return is_active && is_plain && !is_raw; }
  };

  void take_request(std::size_t port, const Frame& frame);
  void take_stream_request(std::size_t port, const RawRequest& request);
  void start_silent_streams();
  void note_exclusive(const RawRequest& request);
  void receive_raw(std::span<const std::uint8_t> bytes);
  void watch_restart();
  void take_sign_of_life(std::span<const std::uint8_t> bytes);
  bool must_wait(std::size_t port) const;
  void log(const std::string& text) const;
  void begin_exclusive();
  void end_exclusive();
  void forget_exclusive();
  Instant silent_since(std::size_t port) const;
  void expel(std::size_t port, const char* reason);
  void expel_exclusive();
  void wake_all();
  /// Records the host's wish; returns the request that the board gets instead.
  RawRequest merged(std::size_t port, const RawRequest& request);
  void refused(std::uint64_t tag, const Call& call);
  void refused_by_line(std::uint64_t tag, const Call& call);
  void refuse_stream(const RequestOwner& asker, const StreamKey& key, const char* reason);
  bool may_pass(std::size_t port, const Frame& request);
  void give_error(const RequestOwner& asker, msg::CommandToBoard command,
                  roles::ErrorReason reason);
  Streams::iterator end_if_unused(Streams::iterator place);
  bool has_other_configuration(const StreamKey& key) const;
  std::uint64_t send(std::optional<std::size_t> port, RawRequest request);
  void give(std::size_t port, const Frame& frame, bool may_be_dropped);
  void give(const RequestOwner& to, const Frame& frame, bool may_be_dropped);
  void give_all(const Frame& frame);
  void give_sample(const Frame& frame);
  void wake(std::size_t port);
  bool is_streamed(std::uint8_t id) const;
  void give_unclaimed(const Frame& frame);

  BridgeLine& line_;
  std::function<Instant()> clock_;
  std::function<void(const std::string&)> log_;
  bool allows_passwords_;
  std::array<std::unique_ptr<Host>, max_ports> hosts_{};
  HostPlaces places_{};
  std::function<void(const std::string&)> log_expelled_ =
      hosts::with_fewer_reports([this](const std::string& text) { log(text); });
  std::uint64_t last_tag_ = 0;
  std::unordered_map<std::uint64_t, Call> calls_;
  std::uint16_t last_host_ = 0;
  RequestOwners owners_;
  HostStops stops_;
  Streams streams_;
  std::map<std::uint8_t, Instant> ended_streams_{};  // when the last host left, by message
  Instant heard_{};                                  // the last frame of the board
  int unanswered_ = 0;                               // requests since then
  std::optional<Exclusive> exclusive_{};
  bool is_reopening_ = false;  // after a host had the line for itself
};

}  // namespace sbgc::tools
