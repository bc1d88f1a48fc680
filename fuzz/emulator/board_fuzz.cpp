// Fuzzes an emulated board with any bytes at any times. The input starts with the options, followed
// by steps, each an opcode byte and its operands; see Player::step().
//
// Invariants: the board sends only frames of the protocol, and next() is in the future after
// advance(). Whatever the hosts have sent, the next one is served soon: its request is answered,
// and it gets each sample of its data stream once, if there is room for it.

#include <set>

#include <sbgc/availability.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/emulator/board.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>

#include "input.hpp"

namespace {

using sbgc::Instant;
using sbgc::emulator::Board;
using sbgc::fuzz::require;

template <class M>
constexpr auto id_of = static_cast<std::uint8_t>(M::command);

class Player {
 public:
  explicit Player(std::span<const std::uint8_t> input) : input_(input), board_(options(), {}, {}) {
    open();
    advance(sbgc::milliseconds(600));
  }

  void play() {
    while (!input_.empty()) step();
    advance(sbgc::seconds(2));
    for (std::size_t port = 0; port < ports_.size(); ++port) read(port, SIZE_MAX);
    const sbgc::emulator::BoardCounters& counters = board_.counters();
    require(counters.requests >= counters.refused + counters.unknown + counters.lost);
    recover();
  }

 private:
  struct Port {
    bool is_open{};
    bool is_torn{};  ///< the board restarted while a frame was being sent
    sbgc::ParserOfAll parser{};
  };

  sbgc::emulator::BoardOptions options() {
    sbgc::emulator::BoardOptions result;
    const std::uint8_t choice = input_.byte();
    switch (choice & 3) {
      case 1: result.firmware = sbgc::msg::FirmwareVersion(2439); break;
      case 2:
        result.board = sbgc::msg::BoardVersion(10);
        result.waits_for_saving = true;
        break;
      case 3:
        result.firmware = sbgc::msg::FirmwareVersion(sbgc::newest_firmware);
        result.board = sbgc::msg::BoardVersion(36);
        break;
      default: break;
    }
    if ((choice & 4) != 0) result.input_buffer = 64;
    if ((choice & 8) != 0) result.output_buffer = 64;
    if ((choice & 16) != 0) result.has_frame_imu = false;
    if ((choice & 32) != 0) result.features = {};
    if ((choice & 64) != 0) result.calibration_time = 1;
    if ((choice & 128) != 0) result.gimbal.frame.kind = sbgc::emulator::Disturbance::Kind::drone;
    return result;
  }

  void open() {
    const auto port = board_.open_port((input_.size() & 1) != 0);
    if (!port) return;
    require(!ports_[*port].is_open);
    ports_[*port] = {.is_open = true};
    port_ = *port;
  }

  void step() {
    const std::uint8_t code = input_.byte();
    framing_ = (code & 64) != 0 ? sbgc::framings.back() : sbgc::basic_framing;
    switch (code % 12) {
      case 0: open(); break;
      case 1: port_ = code / 12U % ports_.size(); break;
      case 2: send(input_.bytes(input_.byte())); break;
      case 3:
      case 4:
      case 5: {  // any frame
        const std::uint8_t id = input_.byte();
        send_frame(id, input_.bytes(input_.byte()));
        break;
      }
      case 6: {  // a request of the model with any body
        const std::uint8_t index = input_.byte();
        send_form(index, input_.byte());
        break;
      }
      case 7: advance(sbgc::microseconds(100) * input_.byte()); break;
      case 8: advance(sbgc::milliseconds(4) * input_.byte()); break;
      case 9: read(port_, input_.byte() * std::size_t{8}); break;
      case 10: {
        const Instant next = board_.next();
        if (next != Instant::never) advance(std::min(next - now_, sbgc::seconds(3)));
        break;
      }
      default: interrupt(code); break;
    }
    if (code >= 128) read(port_, SIZE_MAX);
  }

  void interrupt(std::uint8_t code) {
    if (code < 40) {
      board_.set_silent(code < 20);
    } else if (code < 80) {
      board_.restart(now_);
      for (Port& port : ports_) port.is_torn = true;
    } else if (code < 120) {
      board_.gimbal().set_battery(input_.byte() / 10.0, now_);
    } else if (code < 150) {
      board_.memory_saved(board_.memory().revision, now_);
    } else if (code < 170) {
      board_.memory_not_saved(board_.memory().revision, now_);
    } else if (code < 190) {
      board_ = Board(board_.options(), board_.memory(), now_);  // another start with this memory
      for (Port& port : ports_) port = {};
      open();
    } else if (ports_[port_].is_open) {
      if (code < 210) return board_.end_input(port_);
      board_.close_port(port_);
      ports_[port_].is_open = false;
    }
  }

  /// A board that restarts later, and then waits in its bootloader, needs less than 20 seconds.
  void recover() {
    for (std::size_t port = 0; port < ports_.size(); ++port) {
      if (ports_[port].is_open) board_.close_port(port);
      ports_[port] = {};
    }
    board_.set_silent(false);
    board_.memory_saved(board_.memory().revision, now_);
    open();
    std::size_t answers = 0;
    for (int attempts = 0; answers == 0 && attempts < 20; ++attempts) {
      advance(sbgc::seconds(attempts == 0 ? 0 : 1));
      send_message(sbgc::msg::BoardInfoRequest{});
      advance(sbgc::milliseconds(100));
      answers = read(port_, SIZE_MAX).count(id_of<sbgc::msg::BoardInfo>);
    }
    require(answers == 1);

    sbgc::msg::DataStreamInterval stream;
    stream.cmd_id = sbgc::msg::RealtimeData3::command;
    stream.interval_ms = sbgc::msg::Milliseconds(20);
    send_message(stream);
    const sbgc::emulator::BoardCounters before = board_.counters();
    std::size_t samples = 0;
    for (int i = 0; i < 100; ++i) {
      advance(sbgc::milliseconds(10));
      samples += read(port_, SIZE_MAX).count(id_of<sbgc::msg::RealtimeData3>);
    }
    if (board_.counters().restarts != before.restarts) return;  // it had been asked to
    samples += board_.counters().skipped - before.skipped;
    const sbgc::Availability versions{board_.options().firmware.raw(),
                                      board_.options().board.raw()};
    const bool has_streams = sbgc::is_supported<sbgc::msg::DataStreamInterval>(versions);
    require(has_streams ? samples >= 49 && samples <= 51 : samples == 0);
  }

  template <class M>
  void send_message(const M& message) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    send(std::span(frame).first(sbgc::encode_frame(sbgc::basic_framing, message, frame).size));
  }

  void send_form(std::uint8_t index, std::uint8_t extra) {
    std::size_t at = 0;
    sbgc::AllMessages::for_each([&]<class M>(sbgc::Type<M>) {
      if constexpr (M::direction != sbgc::Direction::from_board) {
        if (at++ != index) return;
        send_frame(static_cast<std::uint8_t>(M::command),
                   input_.bytes(std::min<std::size_t>(M::max_size, M::min_size + extra % 64)));
      }
    });
  }

  void send_frame(std::uint8_t id, std::span<const std::uint8_t> body) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    if (const auto written = sbgc::write_frame(framing_, id, body, frame)) {
      send(std::span(frame).first(written.size));
    }
  }

  void send(std::span<const std::uint8_t> from) {
    if (ports_[port_].is_open) board_.receive(port_, from, now_);
  }

  void advance(sbgc::Duration by) {
    now_ = now_ + std::max(by, sbgc::Duration{});
    board_.advance(now_);
    require(board_.next() > now_);
  }

  /// Reads frames that the board sends; returns their commands.
  std::multiset<std::uint8_t> read(std::size_t index, std::size_t most) {
    std::multiset<std::uint8_t> commands;
    Port& port = ports_[index];
    if (!port.is_open) return commands;
    const auto output = board_.output(index);
    require(!board_.is_quiet(index) || (output.empty() && board_.queued_bytes(index) == 0));
    const auto taken = output.first(std::min(output.size(), most));
    port.parser.feed(taken, [&](const sbgc::Frame& frame) {
      const auto code =
          sbgc::select(sbgc::Direction::from_board, frame.id, frame.body.size(), [](auto) {});
      require(code == sbgc::Code::ok || port.is_torn);
      commands.insert(frame.id);
    });
    require(port.is_torn || port.parser.counters().skipped_bytes == 0);
    board_.sent(index, taken.size(), now_);
    return commands;
  }

  sbgc::fuzz::Input input_;
  Board board_;
  Instant now_{};
  std::size_t port_{};
  sbgc::Framing framing_{};  // of the next frames
  std::array<Port, Board::max_ports> ports_{};
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player({data, size}).play();
  return 0;
}
