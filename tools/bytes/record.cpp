// sbgc record: records a line to a capture.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/epoll.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/observer.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/recorder.hpp>

#include "board/capture_check.hpp"
#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/input_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "frames/stream_type.hpp"

namespace sbgc::tools {

namespace {

/// Combines a signal and the duration of a recording in one descriptor: a wait for the reader of a
/// capture must notice both.
class RecordingEnd {
 public:
  /// Also applies to a reader who does not even read the beginning.
  explicit RecordingEnd(std::optional<std::chrono::milliseconds> time)
      : time_(time),
        timer_(::timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC)),
        any_(::epoll_create1(EPOLL_CLOEXEC)) {
    add(timer_.get());
    set_timer();
  }

  /// From now on, signals request the end. The duration starts again.
  void begin() {
    interruption_.emplace();
    add(interruption_descriptor());
    set_timer();
  }

  /// Becomes readable at the end.
  int descriptor() const noexcept { return any_.get(); }
  /// Waits for the end, for a moment at most. Returns true if it has come.
  bool comes_soon() const {
    constexpr int moment = 50;  // ms
    pollfd waiting{any_.get(), POLLIN, 0};
    return ::poll(&waiting, 1, moment) > 0;
  }

 private:
  void set_timer() const {
    using std::chrono::nanoseconds;
    if (!time_) return;
    const nanoseconds left = std::max<nanoseconds>(*time_, nanoseconds(1));  // 0 would stop it
    const auto seconds = std::chrono::floor<std::chrono::seconds>(left);
    itimerspec at{};
    at.it_value.tv_sec = static_cast<std::time_t>(seconds.count());
    at.it_value.tv_nsec = static_cast<long>((left - seconds).count());
    ::timerfd_settime(timer_.get(), 0, &at, nullptr);
  }

  void add(int descriptor) const {
    epoll_event event{};
    event.events = EPOLLIN;
    ::epoll_ctl(any_.get(), EPOLL_CTL_ADD, descriptor, &event);
  }

  std::optional<std::chrono::milliseconds> time_;
  std::optional<Interruption> interruption_{};
  io::detail::Descriptor timer_;
  io::detail::Descriptor any_;
};

struct RecordOptions {
  std::vector<std::string> places;  // [ADDRESS] FILE
  std::string address;
  std::string file;
  std::vector<std::string> streams;
  std::vector<double> rates;
  std::optional<std::chrono::milliseconds> time;
  std::optional<double> seconds;
  bool pcapng = false;

  io::CaptureFormat format() const {
    return pcapng ? io::CaptureFormat::pcapng : io::CaptureFormat::sbgc;
  }
};

/// Reads until the end of the stream or until it is stopped, and discards the bytes.
class Listener {
 public:
  Listener(io::Transport& transport, std::function<void()> at_end)
      : transport_(transport), at_end_(std::move(at_end)) {}

  void read() {
    transport_.async_read(buffer_, [this](std::error_code error, std::size_t size) {
      total_ += size;
      if (!error) return read();
      if (!stopped_ && error != io::Errc::end_of_stream) problem_ = error.message();
      at_end_();
    });
  }

  void stop() {
    stopped_ = true;
    transport_.close();
  }

  std::uint64_t total() const { return total_; }
  const std::string& problem() const { return problem_; }

 private:
  io::Transport& transport_;
  std::function<void()> at_end_;
  std::array<std::uint8_t, 4096> buffer_{};
  std::uint64_t total_ = 0;
  bool stopped_ = false;
  std::string problem_;
};

int record_line(const RecordOptions& options) {
  asio::io_context context;
  RecordingEnd end(options.time);
  io::CaptureWriter writer(options.format(), end.descriptor());
  io::OpenResult opened = io::open(context.get_executor(), options.address);
  if (!opened) throw std::runtime_error(opened.error.message);
  const std::string damage = damage_at(options.address);
  // Standard output then carries only the capture.
  const bool to_stdout = options.file == "-";
  const io::Error error =
      to_stdout ? writer.open(STDOUT_FILENO, "on standard output") : writer.open(options.file);
  if (error) throw std::runtime_error(error.message);

  std::string file_problem;
  std::function<void()> stop;
  const auto on_error = [&](const io::Error& reason) {
    file_problem = reason.message;
    if (stop) stop();  // otherwise it failed before the listener existed
  };
  const std::unique_ptr<io::Transport> transport =
      io::record(std::move(opened.transport), std::move(writer), {.on_error = on_error});
  if (!file_problem.empty()) throw std::runtime_error(file_problem);
  end.begin();
  asio::posix::stream_descriptor ending(context, ::fcntl(end.descriptor(), F_DUPFD_CLOEXEC, 0));
  Listener listener(*transport, [&] { ending.cancel(); });
  stop = [&] { listener.stop(); };
  ending.async_wait(ending.wait_read, [&](std::error_code cancelled) {
    if (!cancelled) stop();
  });
  if (!to_stdout) fmt::print("{}\n", printable(transport->description()));
  std::fflush(stdout);
  listener.read();
  context.run();
  if (!to_stdout) {
    fmt::print("{} recorded in {}\n", counted(listener.total(), "byte"), printable(options.file));
  }
  if (!file_problem.empty()) throw std::runtime_error(file_problem);
  if (!listener.problem().empty()) throw std::runtime_error(listener.problem());
  if (!damage.empty()) throw CommandError(damage);
  if (listener.total() == 0) {
    remark("sbgc: nothing arrived; a board sends little unless it is asked, as by --stream\n");
  }
  return success;
}

/// Starts a requested stream.
using StreamStart = std::function<Result<Subscription>(Client& client)>;

/// Reads "NAME", "NAME:WITH", or for bytes "NUMBER" and "NUMBER:HEX".
StreamStart start_of(std::string_view text, std::chrono::milliseconds interval) {
  const std::size_t colon = std::min(text.find(':'), text.size());
  const std::string_view name = text.substr(0, colon);
  const std::string_view with = text.substr(std::min(colon + 1, text.size()));
  if (const auto id = detail::parse_number<std::uint8_t>(name); id && *id != 0) {
    const roles::StreamRequest request = raw_stream_request(*id, with, interval);
    return [request](Client& client) { return client.stream_raw(request, [](const Frame&) {}); };
  }
  StreamType type = StreamType::find(name);
  type.configure(with);
  return [type = std::move(type), interval](Client& client) {
    return type.start(client, interval, [](const Sample&) {});
  };
}

/// Reads the streams, and the rates: one for each stream, or one for all.
std::vector<StreamStart> wanted_streams(const RecordOptions& options) {
  constexpr double usual_rate = 50;
  const std::size_t rates = options.rates.size();
  if (rates > 1 && rates != options.streams.size()) {
    throw CommandError("use one --rate for each --stream, or one for all", wrong_usage);
  }
  std::vector<StreamStart> result;
  for (std::size_t i = 0; i < options.streams.size(); ++i) {
    const double rate = rates == 0 ? usual_rate : options.rates[rates == 1 ? 0 : i];
    result.push_back(start_of(options.streams[i], interval_of(rate)));
  }
  return result;
}

/// Counts the bytes from the board.
class ByteCounter final : public io::Observer {
 public:
  explicit ByteCounter(std::atomic<std::uint64_t>& total) : total_(total) {}

  void on_read(std::span<const std::uint8_t> bytes) override { total_ += bytes.size(); }
  void on_written(std::span<const std::uint8_t>) override {}

 private:
  std::atomic<std::uint64_t>& total_;
};

/// Records a conversation with the board. Each connection becomes a session of the capture.
int record_board(const RecordOptions& options, const CommandContext& context) {
  const std::vector<StreamStart> streams = wanted_streams(options);
  const bool to_stdout = options.file == "-";
  std::signal(SIGPIPE, SIG_IGN);
  remark_in_background();
  RecordingEnd end(options.time);
  std::atomic<std::uint64_t> total = 0;
  std::mutex mutex;
  std::string problem;  // guarded by the mutex
  const auto fail_with = [&](const io::Error& error) {
    const std::lock_guard lock(mutex);
    if (problem.empty()) problem = without_period(error.message);
  };
  const auto has_failed = [&] {
    const std::lock_guard lock(mutex);
    return !problem.empty();
  };
  const auto record = [&](std::unique_ptr<io::Transport> transport) {
    io::CaptureWriter writer(options.format(), end.descriptor());
    const io::Error error =
        to_stdout ? writer.open(STDOUT_FILENO, "on standard output") : writer.open(options.file);
    if (error) {
      fail_with(error);
      return transport;
    }
    return io::record(io::observe(std::move(transport), std::make_shared<ByteCounter>(total)),
                      std::move(writer), {.on_error = fail_with});
  };
  {
    Client client = connect_for_long(context.gimbal, [&](ConnectOptions& connect) {
      if (connect.password) warn_of_password_in(options.file);
      connect.wrap = [record, wrap = connect.wrap](std::unique_ptr<io::Transport> transport) {
        return record(wrap ? wrap(std::move(transport)) : std::move(transport));
      };
    });
    end.begin();  // not earlier: the first Ctrl-C ends the connection attempt
    const Subscription changes = report_changes(client);
    std::vector<Subscription> running;
    running.reserve(streams.size());
    for (const StreamStart& start : streams) running.push_back(value_of(start(client)));
    if (!to_stdout) fmt::print("{}\n", printable(line_to_gimbal(client.description())));
    std::fflush(stdout);
    while (!has_failed() && client.state() != LinkState::given_up && !end.comes_soon()) continue;
  }  // before this, a write may fail
  if (!to_stdout) {
    fmt::print("{} recorded in {}\n", counted(total, "byte"), printable(options.file));
  }
  if (has_failed()) throw CommandError(problem);
  return success;
}

/// Throws CommandError for options that have no effect while only listening.
void reject_options_of_a_board(const GimbalOptions& gimbal) {
  const std::pair<bool, const char*> options[] = {
      {gimbal.timeout.has_value(), "--timeout"},
      {gimbal.attempts.has_value(), "--attempts"},
      {gimbal.attempt_timeout.has_value(), "--attempt-time"},
      {!gimbal.capture.empty(), "--capture"},
      {gimbal.verbose, "--verbose"},
  };
  for (const auto& [is_given, name] : options) {
    if (!is_given) continue;
    throw CommandError(fmt::format("{} has no effect while the line is only listened to; with "
                                   "--port ADDRESS, the command connects to the board",
                                   name),
                       wrong_usage);
  }
}

/// A capture contains the bytes of the line. Throws CommandError for a file name that suggests
/// another format.
void require_capture(const RecordOptions& options) {
  const std::string name = detail::lower_case(options.file);
  const auto has_end = [&](const char* end) { return name.ends_with(end); };
  if (!options.pcapng && std::ranges::any_of(std::array{".pcapng", ".pcap"}, has_end)) {
    throw CommandError(fmt::format("{} would be a capture of sbgc: for a file of Wireshark, add "
                                   "--pcapng",
                                   clipped(options.file)),
                       wrong_usage);
  }
  if (std::ranges::none_of(std::array{".csv", ".tsv", ".json", ".jsonl", ".xlsx"}, has_end)) return;
  const std::string first = options.streams.empty() ? "RealtimeData4" : options.streams.front();
  const std::string stream = first.substr(0, first.find(':'));
  const bool is_number = detail::parse_number<unsigned>(stream).has_value();
  const char* const format = name.find(".json") == std::string::npos ? "csv" : "jsonl";
  throw CommandError(
      fmt::format("{} would be a capture, which has the bytes of the line: for {}, use `sbgc "
                  "stream {}{} --format {}`, or record to another name and use `sbgc decode NAME "
                  "-m {} --format {}`",
                  clipped(options.file), *format == 'c' ? "a table" : "JSON",
                  is_number ? "--id " : "", clipped(stream), format, clipped(stream), format),
      wrong_usage);
}

/// With --stream or a gimbal, connects to the board; otherwise only listens to the line.
int run_record(RecordOptions options, CommandContext& context) {
  if (options.seconds) {
    options.time = std::chrono::milliseconds(std::llround(*options.seconds * 1000));
  }
  options.file = options.places.back();
  require_capture(options);
  if (options.file == "-") require_no_terminal("a file instead of -");
  const bool has_address = options.places.size() == 2;
  const bool has_gimbal = !context.gimbal.port.empty() || !context.gimbal.name.empty();
  if (has_address && has_gimbal) {
    throw CommandError("the address is given twice", wrong_usage);
  }
  if (!has_address && !has_gimbal && options.streams.empty()) {
    throw CommandError("expected an address and a file; or a file and --port, --gimbal or --stream",
                       wrong_usage);
  }
  if (!options.rates.empty() && options.streams.empty()) {
    throw CommandError("--rate is for --stream, which is missing", wrong_usage);
  }
  if (has_gimbal || !options.streams.empty()) {
    if (has_address) context.gimbal.port = options.places.front();
    return record_board(options, context);
  }
  reject_options_of_a_board(context.gimbal);
  options.address = options.places.front();
  require_address(options.address);
  return record_line(options);
}

}  // namespace

void add_record(CLI::App& app, CommandContext& context) {
  const Subcommand<RecordOptions> command(app, context, "record",
                                          "Record the output of a board to a capture");
  auto& options = command.options();
  command
      ->add_option("places", options.places,
                   "The capture; an existing file gets a new session, - is standard output. With "
                   "an address before it, which may also be pty: or capture:FILE, the command "
                   "only listens, unless --stream is given")
      ->required()
      ->expected(1, 2)
      ->type_name("[ADDRESS] FILE");
  command
      ->add_option(
          "--stream", options.streams,
          "Request this data stream, with the flags that select its contents; an unknown one by "
          "its number, with its configuration in hex; may be repeated")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("NAME[:WITH]");
  command
      ->add_option("--rate", options.rates,
                   "Messages per second (50): one rate for each --stream, or one for all")
      ->take_all()
      ->allow_extra_args(false)
      ->type_name("HZ")
      ->check(number_range(0.02, 1000.0));
  command->add_flag("--pcapng", options.pcapng, "Write a file for Wireshark instead of a capture");
  add_duration(*command, "--for", options.time, "Stop after this time; otherwise with Ctrl-C");
  command->add_option("--seconds", options.seconds, "The former name of --for")
      ->check(number_range(0.0, 1e9))
      ->group("");
  command->footer(
      "With --port, --gimbal or --stream, the command connects to the board; if the line is "
      "lost, it reconnects, and the capture gets a new session. With only an address, it sends "
      "nothing, and ends when the line ends. `sbgc decode` shows a capture, and `sbgc replay` or "
      "capture:FILE replays it; `sbgc record ADDRESS - | sbgc decode` shows the frames live. The "
      "exit status is 0 if the recording is complete, 1 if not, 2 for wrong usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc record --stream RealtimeData4 --rate 20 --for 1s capture\n"
      "  sbgc record --stream 23 --for 1s flight\n"
      "  sbgc record --stream RealtimeData4 --pcapng --for 1s capture.pcapng\n"
      "  sbgc record --stream \"RealtimeDataCustom:IMU_ANGLES|RC_DATA\" --for 1s capture");
  command.runs(run_record);
}

}  // namespace sbgc::tools
