/// The serial interfaces of the board: request queues and pending output.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/emulator/board.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>

namespace sbgc::emulator {

/// A request that waits for execution.
struct QueuedRequest {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};
  Framing framing{};
};

/// Buffers of frames, which they do not interpret.
class Ports {
 public:
  /// An invalid port number; sending to it does nothing.
  static constexpr std::size_t none = Board::max_ports;

  explicit Ports(const BoardOptions& options);

  /// Ends a step of the board, with the revision if the step changed the memory. Frames that report
  /// the change, and all later ones, then wait for release() or fail().
  void end_step(std::optional<std::uint32_t> changed);
  /// Releases frames that report changes up to this revision.
  void release(std::uint32_t revision);
  /// Reports that changes up to this revision could not be saved: replaces each frame that reports
  /// one by `refusal(frame)`.
  using Refusal = std::function<std::vector<std::uint8_t>(std::span<const std::uint8_t>)>;
  void fail(std::uint32_t revision, const Refusal& refusal);

  std::optional<std::size_t> open(bool is_usb);
  void close(std::size_t port);
  bool is_open(std::size_t port) const;
  bool is_usb(std::size_t port) const;
  /// Reports that the host sends no more requests: from now on there is no room for stream samples.
  void end_input(std::size_t port);
  /// The number of line errors since the board started.
  std::uint64_t errors(std::size_t port) const;

  /// Sends a message, even if it must wait for room. No effect if the port is closed.
  template <Message M>
  void send(std::size_t port, const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(message, frame);
    if (written) send_frame(port, std::span(frame).first(written.size));
  }
  /// The same for a stream sample, but sends nothing and returns false if there is no room now.
  template <Message M>
  bool offer(std::size_t port, const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(message, frame);
    if (!written) return false;
    const std::size_t body_size = written.size - frame_size(0);
    if (frame_size(framing(port), body_size) > room(port)) return false;
    send_frame(port, std::span(frame).first(written.size));
    return true;
  }
  /// Sends the message of a frame in the framing of the port.
  void send_frame(std::size_t port, std::span<const std::uint8_t> frame);
  /// The framing of the last request, in which the board sends.
  Framing framing(std::size_t port) const {
    return is_open(port) ? ports_[port].framing : basic_framing;
  }
  /// The number of bytes of samples that fit into the output buffer now; 0 for a closed port.
  std::size_t room(std::size_t port) const;

  /// The size of the queued requests in bytes.
  std::size_t queued_bytes(std::size_t port) const { return ports_[port].requests_size; }

  /// Parses bytes from a host and queues the requests; only counts them if the board does not
  /// listen.
  void receive(std::size_t port, std::span<const std::uint8_t> bytes, bool is_listening);
  /// True if a frame has started but is not complete.
  bool is_in_frame(std::size_t port) const;

  /// A port that requires a password is locked until unlock(), and again once it is closed or the
  /// board restarts. Nothing is sent to it.
  bool is_locked(std::size_t port) const { return has_password_ && !ports_[port].is_unlocked; }
  void unlock(std::size_t port) { ports_[port].is_unlocked = true; }
  /// Drops the partial frame, because the line was idle.
  void drop_frame(std::size_t port, bool is_listening);
  /// True if a request is queued and pending output does not block it.
  bool can_take(std::size_t port) const;
  /// Precondition: can_take(port).
  QueuedRequest take(std::size_t port);
  /// Drops all input, because the board restarted; with `output_too`, also pending output.
  void restart(bool output_too);

  /// The bytes that may be sent now.
  std::span<const std::uint8_t> output(std::size_t port) const;
  /// True if any bytes are pending, sendable now or later.
  bool has_output(std::size_t port) const;
  void sent(std::size_t port, std::size_t size);

  /// If silent, the board sends nothing.
  void set_silent(bool is_silent) { is_silent_ = is_silent; }

  Instant now{};  ///< for `on_traffic`
  const std::function<void(const Board::Traffic&)>* on_traffic{};
  std::function<void(std::size_t port, const Frame& frame)> on_sent{};  ///< each frame to a host
  BoardCounters counters{};

  void report(std::size_t port, const Frame& frame, std::optional<Reaction> reaction) const;

 private:
  /// More than a host that waits for responses ever queues; limits the cost of a flooding host.
  /// Assumption.
  static constexpr std::size_t max_input = 1U << 20U;
  /// The limit of unrequested output, such as calibration progress, beyond the output buffer if a
  /// host does not read. Assumption.
  static constexpr std::size_t max_overflow = 4096;

  /// A frame in the output that waits until its change is saved.
  struct Held {
    std::size_t begin{}, size{};              ///< position in Port::output
    std::optional<std::uint32_t> revision{};  ///< empty in the current step
  };

  struct Port {
    bool is_open{}, is_usb{}, has_ended{}, is_unlocked{};
    BasicParser<AnyFrameFormats> parser{};
    Framing framing = basic_framing;
    std::deque<QueuedRequest> requests{};
    std::size_t requests_size{};
    std::vector<std::uint8_t> output{};  ///< starts at `output_begin`
    std::size_t output_begin{};
    std::deque<Held> held{};

    std::size_t output_size() const { return output.size() - output_begin; }
    /// Removes sent bytes from `output`.
    void forget_sent();
  };

  static std::uint64_t parser_errors(const ParserCounters& counters);
  static void forget_input(Port& port);
  void keep(std::size_t port, const Frame& frame, bool is_listening);

  std::array<Port, Board::max_ports> ports_{};
  std::size_t input_limit_{};
  std::size_t output_limit_{};
  Framing newest_framing_{};
  bool holds_{};
  bool is_silent_{};
  bool has_password_{};
};

}  // namespace sbgc::emulator
