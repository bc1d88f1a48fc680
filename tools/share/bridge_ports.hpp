/// Several hosts at one board, without I/O.
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

  /// Takes the line for raw bytes. From now on, nothing is sent but the bytes of write_raw(), and
  /// what arrives is reported as it is.
  virtual void take_line() = 0;
  virtual void write_raw(std::vector<std::uint8_t> bytes) = 0;
  /// How many of these bytes have not been sent yet.
  virtual std::size_t raw_waiting() const = 0;
  /// Ends this when they have been sent: connects to the board again.
  virtual void give_line_back() = 0;
  /// Ends this at once; the connection goes on. Precondition: no bytes wait.
  virtual void release_line() = 0;

  /// Asks the board for a sign of life; without one, connects again.
  virtual void check() = 0;

  /// Goes on with a stop until it is done.
  virtual void take_over(OwedStop stop) = 0;
  /// A host moves the camera: what was taken over is owed no longer.
  virtual void drop_stops() = 0;
};

/// Gives each host the responses to its own requests, the samples of the data streams that it has
/// asked for, and all unsolicited messages.
///
/// - A response that comes when its request has ended still goes to the host that asked; see
///   RequestOwners.
/// - The bodies of requests and responses pass unchanged; a response is rewritten in the framing of
///   its request, other messages in that of the last request of the host.
/// - The board gets the shortest interval that a host wants for a data stream; each host gets every
///   sample that is due at its own interval. The share of a host ends when it leaves.
/// - The messages of a stream do not say with which configuration they were requested. Therefore a
///   stream has one configuration at a time: while it runs, a request for another one gets an error
///   in place of a confirmation. So does one for which the line has no room.
/// - A single answer goes only to the host that asked, also while others stream the same message;
///   the session tells it from the samples. If a stream leaves no time for that, the request gets
///   an error.
/// - A host that sends faster than the board executes is read more slowly. A host that does not
///   read loses samples and unsolicited messages, and disturbs no other.
/// - A stop drops the motion of all hosts that waits to be sent; they get an error (WRONG_STATE).
/// If
///   its host leaves before it is done, the bridge goes on with it.
/// - Another request that fails has no response, as on a line to the board.
/// - If all places are taken, silent hosts are replaced; see HostPlaces. A host that gets a stream,
///   awaits an answer or has the line for itself is not silent.
/// - After a request that restarts the board, its host has the line for itself, with all bytes as
///   they are, because a bootloader speaks another protocol. The others wait until the host has
///   left, the board introduces itself again, or nothing of that kind happens. The board does not
///   wait: a host that has the line for itself and does not read must leave.
/// - After a plain restart, until the host sends other bytes than requests, the bridge asks the
/// board
///   for a sign of life: the others wait only while it does not answer, also after the host has
///   left, and the connection goes on. A request that comes before the board goes down gets an
///   error.
class BridgePorts final : public hosts::HostPorts {
 public:
  static constexpr std::size_t max_ports = HostPlaces::max_ports;
  /// Requests of one host that have not ended.
  static constexpr std::size_t max_requests = 16;
  /// Bytes that wait for one host.
  static constexpr std::size_t max_output = 65536;
  /// Silence of a host that ends an incomplete frame.
  static constexpr Duration idle = sbgc::milliseconds(100);
  /// How long a host that restarts the board has the line for itself without using it for raw
  /// bytes; for how much longer a board may be silent after a plain restart.
  static constexpr Duration restart_time = sbgc::seconds(5);
  /// A board that does not answer for this long is down.
  static constexpr Duration longest_answer = sbgc::milliseconds(200);
  /// A board that has announced its restart still responds for this long.
  static constexpr Duration restart_delay = sbgc::milliseconds(roles::reset_delay_ms + 500);
  /// Samples may still arrive for this long after a stream was ended.
  static constexpr Duration end_of_stream_time = sbgc::seconds(1);
  /// The silence of a data stream after which it is started again, at least three intervals: a
  /// board that has lost its power for a moment has lost its streams.
  static constexpr Duration silence_of_stream = sbgc::seconds(3);
  static constexpr Duration longest_silence = sbgc::seconds(60);
  /// The board is asked for a sign of life after so many requests without any response.
  static constexpr int most_unanswered = 3;
  /// Bytes of a host that has the line for itself that wait to be sent.
  static constexpr std::size_t max_raw = 4096;
  /// Bytes of the board that wait for it: what a board sends in over a minute at 115200 baud.
  static constexpr std::size_t max_raw_output = std::size_t{1} << 20;

  struct HostCounters {
    std::size_t port{};
    std::uint64_t requests{};
    std::uint64_t messages{};  ///< sent to it
    std::uint64_t dropped{};   ///< because it does not read
  };

  /// `log` receives sentences for the user. A password opens the port of the board for all hosts,
  /// so a request with one is refused unless `allows_passwords`.
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

  /// A frame that belongs to the request with this tag.
  void answered(std::uint64_t tag, const Frame& frame);
  /// The request has ended, with this error if it has failed.
  void ended(std::uint64_t tag, std::optional<ErrorCode> failure = {});
  /// Every frame of the board, including those of answered().
  void arrived(const BoardFrame& message);
  /// The board is connected again and has no data streams: starts those that hosts want.
  void restart_streams();
  /// Bytes that arrive while the line is taken.
  void raw_arrived(std::span<const std::uint8_t> bytes);
  /// Bytes of write_raw() have been sent.
  void raw_sent();
  /// The line is lost. Returns false if it is only opened again after a host had it for itself.
  bool line_lost();
  /// The host that has the line for itself.
  std::optional<std::size_t> exclusive_host() const;
  /// Does what is due: ends incomplete frames of silent hosts, starts silent data streams again,
  /// and gives the line back. To be called from time to time.
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
  /// The wishes of one host for it.
  struct Share {
    std::int64_t interval{};  // in counts of the request
    std::int64_t before{};    // the last one, which a refused change leaves; or 0
    std::int64_t credit{};    // what has passed since its last sample, in microseconds
    std::uint64_t end{};      // the request that ends it; or 0
  };
  struct Stream {
    std::uint8_t size{};  // of the bodies of its messages
    RawRequest request{};
    std::map<std::size_t, Share> shares{};  // by port
    Instant heard{};                        // the last sample, or its last start
    bool is_started_again = false;          // since its last sample
    std::uint64_t starting{};               // the request that must end before it has samples; or 0
    bool is_wanted() const;                 // by a host that has not asked for its end
    std::int64_t interval() const;          // 0 if nobody wants it
    std::int64_t pace() const;              // interval until the board has made all changes
  };
  using Streams = std::map<StreamKey, Stream>;

  /// A host that has the line for itself, or waits until the others have their answers.
  struct Exclusive {
    std::size_t port{};  // max_ports after it has left
    bool is_active = false;
    bool is_plain = false;              // the board speaks the same protocol afterwards
    bool is_raw = false;                // it has sent bytes that are no requests
    bool is_back = false;               // the board has introduced itself
    std::vector<std::uint8_t> first{};  // what it sends before it has the line
    Instant begin{};
    Instant last{};  // when bytes passed
    ParserOfAll from_board{};
    // The command that restarts the board.
    std::uint8_t command{};
    std::deque<bool> introductions{};           // that were asked for; true: by the bridge
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
  /// Notes what the host wants; returns the request that the board gets instead.
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
