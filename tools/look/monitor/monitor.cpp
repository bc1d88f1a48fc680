// sbgc monitor: a live view of a gimbal, on the whole terminal.

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <sbgc/client/client.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/io/observer.hpp>

#include "board/connection.hpp"
#include "board/listed_ports.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "command/terminal_restorer.hpp"
#include "command/terminal_text.hpp"
#include "look/monitor/gimbal_state.hpp"
#include "look/monitor/pages.hpp"
#include "look/monitor/screen.hpp"

namespace sbgc::tools {

namespace {

/// Records the line while it is on. Thread-safe. The functions for the user return a message.
class Recording final : public io::Observer {
 public:
  /// Also false if the file can no longer be written; begin_or_end() reports that.
  bool is_on() const;
  /// Begins a file in this folder that is named by the time, or ends it. `line` describes the line.
  std::string begin_or_end(const std::string& line);
  /// Writes a note with a number into the file.
  std::string mark();

  void on_read(std::span<const std::uint8_t> bytes) override;
  void on_written(std::span<const std::uint8_t> bytes) override;
  void on_line_set(const LineSettings& settings) override;

 private:
  using Clock = io::CaptureWriter::Clock;

  void add(io::CaptureKind kind, std::span<const std::uint8_t> bytes);

  mutable std::mutex mutex_;
  std::optional<io::CaptureWriter> file_{};
  std::string name_{};
  std::size_t marks_ = 0;
};

bool Recording::is_on() const {
  const std::lock_guard lock(mutex_);
  return file_ && !file_->error();
}

std::string Recording::begin_or_end(const std::string& line) {
  const std::lock_guard lock(mutex_);
  if (file_) {
    const io::Error problem = file_->error();
    file_.reset();
    return problem ? problem.message : "recorded in " + name_;
  }
  const auto now =
      std::chrono::time_point_cast<std::chrono::seconds>(std::chrono::system_clock::now());
  name_ = fmt::format("monitor-{:%Y%m%dT%H%M%S}Z.capture", now);
  io::CaptureWriter file;
  if (const io::Error problem = file.open(name_)) return problem.message;
  file.write_note(line, Clock::now());
  file_ = std::move(file);
  marks_ = 0;
  return "recording to " + name_;
}

std::string Recording::mark() {
  const std::lock_guard lock(mutex_);
  if (!file_) return "nothing is recorded: r begins";
  const std::string text = fmt::format("mark {}", ++marks_);
  const io::Error& problem = file_->write_note(text, Clock::now());
  return problem ? problem.message : text;
}

void Recording::on_read(std::span<const std::uint8_t> bytes) {
  add(io::CaptureKind::from_board, bytes);
}

void Recording::on_written(std::span<const std::uint8_t> bytes) {
  add(io::CaptureKind::to_board, bytes);
}

void Recording::on_line_set(const LineSettings& settings) {
  const std::lock_guard lock(mutex_);
  if (file_) file_->write_note("line: " + io::to_string(settings), Clock::now());
}

void Recording::add(io::CaptureKind kind, std::span<const std::uint8_t> bytes) {
  const std::lock_guard lock(mutex_);
  if (file_) file_->write(kind, bytes, Clock::now());
}

using Clock = std::chrono::steady_clock;

struct MonitorOptions {
  double rate = 20;
};

/// Starts the stream of the newest live data that the board has.
Result<Subscription> start_stream(Client& client, std::chrono::milliseconds interval,
                                  GimbalState& state) {
  const auto take = [&state](const auto& message) { state.add(LiveMessage(message)); };
  if (is_supported<msg::RealtimeData4Request>(client.identity().versions())) {
    return client.stream<msg::RealtimeData4>(interval, take);
  }
  return client.stream<msg::RealtimeData3>(interval, take);
}

/// Changes the view. Returns false to quit.
bool press(int pressed, View& view, const GimbalSnapshot& gimbal, Recording& recording,
           const std::string& line) {
  constexpr std::size_t page_lines = 10;
  const auto go_to = [&](std::size_t page) {
    view.page = static_cast<Page>(page % page_count);
    view.shows_keys = false;
    view.scroll = 0;
  };
  const auto tell = [&](const std::string& text) {
    view.message = text;
    view.message_end = Clock::now() + std::chrono::seconds(4);
  };
  const auto page = static_cast<std::size_t>(view.page);
  switch (pressed) {
    case 'q':
    case 'Q': return false;
    case '1':
    case '2':
    case '3':
    case '4': go_to(static_cast<std::size_t>(pressed - '1')); break;
    case '\t':
    case key::right: go_to(page + 1); break;
    case key::left: go_to(page + page_count - 1); break;
    case 'p':
    case ' ': view.is_paused = !view.is_paused; break;
    case 'z': view.zero = view.zero ? std::nullopt : std::optional(gimbal.values.angle); break;
    case 'r': tell(recording.begin_or_end(line)); break;
    case 'm': tell(recording.mark()); break;
    case '?':
    case 'h':
      view.shows_keys = !view.shows_keys;
      view.scroll = 0;
      break;
    case key::up: view.scroll -= view.scroll == 0 ? 0 : 1; break;
    case key::down: ++view.scroll; break;
    case key::page_up: view.scroll -= std::min(view.scroll, page_lines); break;
    case key::page_down: view.scroll += page_lines; break;
    case key::home: view.scroll = 0; break;
    default: break;
  }
  return true;
}

class Monitor {
 public:
  Monitor(Client& client, const GimbalState& state, Recording& recording)
      : client_(client), state_(state), recording_(recording) {}

  /// Returns when the user quits, or when a signal requests it.
  void run() {
    constexpr std::chrono::milliseconds refresh{50};
    Screen screen;
    View view;
    GimbalSnapshot gimbal;
    while (!was_interrupted()) {
      if (!view.is_paused) gimbal = state_.snapshot();
      gimbal.is_connected = client_.is_connected();
      view.is_recording = recording_.is_on();
      if (Clock::now() > view.message_end) view.message.clear();
      draw(screen, view, gimbal, line());
      const std::optional<int> pressed = screen.wait_for_key(refresh);
      if (pressed &&
          !press(*pressed, view, gimbal, recording_, line_to_gimbal(client_.description())))
        return;
    }
  }

 private:
  LineInfo line() {
    const std::uint64_t connections = client_.connections();
    const bool is_connected = client_.is_connected();
    if (connections != connections_ || is_connected != was_connected_) since_ = Clock::now();
    connections_ = connections;
    was_connected_ = is_connected;
    const BoardIdentity board = client_.identity();
    return {fmt::format("{}, firmware {}", board.board_version(), board.firmware_version()),
            line_to_gimbal(client_.description()), client_.statistics(), connections,
            std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - since_)};
  }

  Client& client_;
  const GimbalState& state_;
  Recording& recording_;
  std::uint64_t connections_ = 0;
  bool was_connected_ = true;
  Clock::time_point since_{};
};

int monitor(const MonitorOptions& options, const CommandContext& context) {
  if (!is_terminal(stdin) || !is_terminal(stdout)) {
    throw CommandError("monitor needs a terminal; `sbgc stream` prints live data anywhere");
  }
  if (is_dumb_terminal()) {
    throw CommandError(
        "monitor cannot draw on this terminal (TERM=dumb); `sbgc stream` prints live data "
        "anywhere");
  }
  if (context.gimbal.verbose && is_terminal(stderr)) {
    throw CommandError(
        "monitor has the whole terminal: with --verbose, send standard error to a file",
        wrong_usage);
  }
  const TerminalRestorer restorer(TerminalRestorer::Screen::full);
  const LineChoice line = choose_line(context.gimbal);
  ReconnectOptions reconnect{.connection = line.options};
  reconnect.list_ports = listed_ports;
  GimbalState state;
  const auto recording = std::make_shared<Recording>();
  reconnect.connection.wrap =
      [recording, inner = line.options.wrap](std::unique_ptr<io::Transport> transport) {
        return io::observe(inner ? inner(std::move(transport)) : std::move(transport), recording);
      };
  // A remark would appear in the middle of the screen.
  reconnect.connection.on_capture_error =
      [&state, is_incomplete = context.gimbal.is_incomplete](const ClientError& error) {
        *is_incomplete = true;
        state.add(error);
      };
  Client client = value_of(Client::connect(line.address, reconnect));
  const Interruption interruption;  // not earlier: the first Ctrl-C ends the connection attempt
  const Subscription notices = client.on_notice([&](const Notice& notice) { state.add(notice); });
  const Subscription changes =
      client.on_change([&](const LinkChange& change) { state.add(change); });
  const std::chrono::milliseconds interval(static_cast<std::int64_t>(1000 / options.rate));
  const Subscription stream = value_of(start_stream(client, interval, state));
  Monitor(client, state, *recording).run();
  if (recording->is_on()) remark("sbgc: {}\n", recording->begin_or_end(""));
  if (*context.gimbal.is_incomplete) throw CommandError("the capture is incomplete");
  return success;
}

}  // namespace

void add_monitor(CLI::App& app, CommandContext& context) {
  const Subcommand<MonitorOptions> command(app, context, "monitor",
                                           "Watch a gimbal live on the whole terminal");
  auto& options = command.options();
  command->add_option("--rate", options.rate, "Messages per second")
      ->type_name("HZ")
      ->check(number_range(1.0, 200.0))
      ->capture_default_str();
  command->footer(
      "Keys: 1 to 4, Tab and left and right choose the page, p or space pauses the display, z "
      "shows angles relative to the present ones, r begins and ends a capture in this folder, m "
      "adds a mark to it (`sbgc decode` shows the mark), up and down scroll, ? lists the keys, q "
      "quits. The terminal needs at least 40 columns and 8 rows.\n"
      "It only reads. If the line is lost, it reconnects. The exit status is 0 after q or "
      "Ctrl-C, 1 if no board was found, 2 for wrong usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc monitor\n"
      "  sbgc monitor --rate 5 -p tcp:10.0.0.7:5000");
  command.runs(monitor);
}

}  // namespace sbgc::tools
