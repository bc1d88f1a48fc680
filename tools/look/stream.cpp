// sbgc stream: the values of a data stream, as a table, CSV or JSON.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/json/hex.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/realtime.hpp>

#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "frames/sample_writer.hpp"
#include "frames/stream_type.hpp"
#include "values/field_patterns.hpp"
#include "values/message_json.hpp"

namespace sbgc::tools {

namespace {

/// A queue of output lines. Thread-safe. Drops lines if too much text is queued.
class LineQueue {
 public:
  void put(const std::string& line) {
    const std::lock_guard lock(mutex_);
    if (waiting_.size() + line.size() > most) {
      ++dropped_;
      return;
    }
    waiting_ += line;
    changed_.notify_one();
  }

  /// Returns the queued lines; waits for some until `deadline`.
  std::string take(std::chrono::steady_clock::time_point deadline) {
    std::unique_lock lock(mutex_);
    changed_.wait_until(lock, deadline, [this] { return !waiting_.empty(); });
    return std::exchange(waiting_, {});
  }

  std::uint64_t dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
  }

 private:
  static constexpr std::size_t most = std::size_t{64} << 20;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::string waiting_;
  std::uint64_t dropped_ = 0;
};

using Clock = std::chrono::steady_clock;

struct StreamOptions {
  std::string name;
  std::optional<unsigned> id;  // instead of a name
  std::string config;          // in hex, with `id`
  double rate = 50;
  std::string format = "text";
  std::string fields;
  std::string with;
  std::optional<std::chrono::milliseconds> time;
  bool unix_time = false;
};

/// Counts the samples of a stream, and detects missing ones from its rate.
class SampleCounter {
 public:
  explicit SampleCounter(std::chrono::milliseconds interval) : interval_(interval) {}

  /// Returns the time since the last sample of this connection.
  Clock::duration count(Clock::time_point now, std::uint64_t connection) {
    if (connection != connection_) {
      finish();
      connection_ = connection;
      first_ = now;
      last_ = now;
    }
    const Clock::duration pause = now - last_;
    last_ = now;
    ++samples_;
    ++total_;
    return pause;
  }
  void finish() {
    if (samples_ == 0) return;
    const auto due = std::llround(std::chrono::duration<double>(last_ - first_) /
                                  std::chrono::duration<double>(interval_));
    lost_ += std::max<std::int64_t>(due + 1 - samples_, 0);
    samples_ = 0;
  }
  std::int64_t total() const { return total_; }
  std::int64_t lost() const { return lost_; }

 private:
  std::chrono::milliseconds interval_;
  std::uint64_t connection_ = 0;
  Clock::time_point first_{};
  Clock::time_point last_{};
  std::int64_t samples_ = 0;  // of this connection
  std::int64_t total_ = 0;
  std::int64_t lost_ = 0;
};

StreamType chosen_stream(const StreamOptions& options) {
  StreamType stream = StreamType::find(options.name);
  stream.configure(options.with);
  if (!options.fields.empty() && options.with.empty()) stream.configure_for(options.fields);
  if (stream.lacks_flags() && options.with.empty()) {
    throw CommandError(fmt::format("choose what {} contains with --fields or --with; there are {}",
                                   stream.info().name, fmt::join(stream.flags(), ", ")),
                       wrong_usage);
  }
  return stream;
}

std::vector<StreamField> shown_fields(const StreamType& stream, const std::string& patterns) {
  const std::vector<StreamField> fields = stream.fields();
  std::vector<std::string> paths;
  paths.reserve(fields.size());
  for (const StreamField& field : fields) paths.push_back(field.path);
  const std::vector<bool> chosen =
      chosen_fields(patterns, *find_message(stream.info().name), paths);
  std::vector<StreamField> result;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (chosen[i]) result.push_back(fields[i]);
  }
  return result;
}

void report_losses(const SampleCounter& counter, std::uint64_t dropped) {
  if (counter.lost() != 0) {
    remark("sbgc: about {} lost on the line, {} received\n",
           counted(static_cast<std::uint64_t>(counter.lost()), "message"), counter.total());
  }
  if (dropped != 0) {
    remark("sbgc: {} not written, because the output was too slow\n", counted(dropped, "message"));
  }
}

using End = Clock::time_point;

End end_of(const StreamOptions& options, Clock::time_point start) {
  return options.time ? start + *options.time : End::max();
}

/// Writes lines until the end, Ctrl-C, or a reason to stop, even if the reader has left or stopped.
template <class IsOver>
void write_until(End end, LineQueue& lines, const IsOver& is_over) {
  BackgroundOutput& output = background_stdout();
  while (!output.is_closed() && !was_interrupted() && Clock::now() < end && !is_over()) {
    const auto soon = std::min(end, Clock::now() + std::chrono::milliseconds(50));
    // Otherwise the lines remain in the queue.
    if (output.wait_until(soon)) output.write(lines.take(soon));
  }
}

/// Writes the rest. Returns false if the reader has stopped reading.
bool write_rest(LineQueue& lines) {
  background_stdout().finish();  // it drops earlier lines
  background_stdout().write(lines.take(Clock::now()));
  finish_stdout();
  if (background_stdout().is_complete()) return true;
  remark("sbgc: the end is not written, because nobody reads the output\n");
  return false;
}

/// Returns a frame as a line of a table, CSV or JSON.
std::string raw_line(OutputFormat format, double time, const Frame& frame) {
  const std::string body = detail::to_hex(frame.body);
  switch (format) {
    case OutputFormat::text: return fmt::format("{:>9.3f}  {}\n", time, body);
    case OutputFormat::csv: return fmt::format("{:.6f},{}\n", time, body);
    case OutputFormat::jsonl: break;
  }
  return fmt::format("{{\"version\":1,\"time\":{:.6f},\"id\":{},\"body\":\"{}\"}}\n", time,
                     frame.id, body);
}

/// Shows the bytes of a stream, including unknown ones.
int run_raw_stream(const StreamOptions& options, const CommandContext& context) {
  if (!options.name.empty() || !options.fields.empty() || !options.with.empty()) {
    throw CommandError("--id is for bytes: it has neither a name, --fields nor --with",
                       wrong_usage);
  }
  const roles::StreamRequest request =
      raw_stream_request(*options.id, options.config, interval_of(options.rate));
  const OutputFormat format = format_named(options.format);
  std::signal(SIGPIPE, SIG_IGN);
  remark_in_background();
  LineQueue lines;
  std::atomic<bool> has_ended = false;
  Client client = connect_for_long(context.gimbal);
  const Interruption interruption;
  const bool ends = is_replay(context.gimbal);
  const Subscription changes = ends ? client.on_change([&](const LinkChange&) { has_ended = true; })
                                    : report_changes(client);
  if (format == OutputFormat::text) lines.put(fmt::format("{:>9}  body\n", "time[s]"));
  if (format == OutputFormat::csv) lines.put("time[s],body\n");
  const auto start = Clock::now();
  const auto take = [&](const Frame& frame) {
    if (has_ended) return;
    lines.put(raw_line(format, std::chrono::duration<double>(Clock::now() - start).count(), frame));
  };
  Subscription samples = ends ? client.on_frame([&](const BoardFrame& one) {
    if (one.frame.id == *options.id) take(one.frame);
  })
                              : value_of(client.stream_raw(request, take));
  write_until(end_of(options, start), lines,
              [&] { return has_ended || client.state() == LinkState::given_up; });
  samples.cancel();
  return write_rest(lines) ? success : failure;
}

int run_stream(StreamOptions options, const CommandContext& context) {
  if (options.id) return run_raw_stream(options, context);
  if (options.name.empty()) {
    options.name = Meta<msg::RealtimeData3>::info.name;
    if (options.fields.empty()) options.fields = "angle.*";
  }
  const auto interval = interval_of(options.rate);
  const StreamType stream = chosen_stream(options);
  const bool is_watched = is_terminal(stdout);
  const auto writer = SampleWriter::make(
      format_named(options.format), stream.info().name, shown_fields(stream, options.fields),
      is_watched ? line_width() : 0, options.unix_time ? SampleKey::unix_time : SampleKey::time);
  std::signal(SIGPIPE, SIG_IGN);
  remark_in_background();
  LineQueue lines;
  SampleCounter counter(interval);
  std::atomic<bool> has_samples = false;
  std::atomic<bool> has_unreadable = false;
  Client client = connect_for_long(context.gimbal);
  const Interruption interruption;  // not earlier: the first Ctrl-C ends the connection attempt
  const bool ends = is_replay(context.gimbal);
  std::atomic<bool> has_ended = false;
  const Subscription changes = ends ? client.on_change([&](const LinkChange&) { has_ended = true; })
                                    : report_changes(client);

  bool is_polling = false;  // only on the thread of the client
  const Subscription notices = client.on_notice([&](const Notice& notice) {
    if (notice.kind == NoticeKind::polling && !std::exchange(is_polling, true)) {
      remark("sbgc: {}\n", notice.message);
    }
    if (notice.kind != NoticeKind::unreadable || notice.command != stream.info().id) return;
    remark("sbgc: {}\n", notice.message);
    has_unreadable = true;
  });

  const auto start = Clock::now();
  const double start_unix =
      std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
  lines.put(writer->header());
  // A stream that is silent for longer is restarted.
  const auto longest = std::max<Clock::duration>(ReconnectOptions{}.longest_silence, 3 * interval);
  const auto take = [&](const Sample& sample) {
    if (has_ended) return;                                    // the capture starts again
    if (!has_samples.exchange(true)) has_unreadable = false;  // of an earlier stream
    const auto now = Clock::now();
    const double time = std::chrono::duration<double>(now - start).count();
    const auto pause = counter.count(now, client.connections());
    if (pause > longest) {
      remark("sbgc: no messages for {:.1f} s; the board may have restarted\n",
             std::chrono::duration<double>(pause).count());
    }
    lines.put(writer->line(options.unix_time ? start_unix + time : time, sample));
  };
  Subscription samples =
      ends ? stream.listen(client, take) : value_of(stream.start(client, interval, take));
  // Until then, samples that do not decode may belong to an earlier stream that is still ending.
  const auto settled =
      Clock::now() + std::max<Clock::duration>(std::chrono::seconds(1), 3 * interval);
  write_until(end_of(options, start), lines, [&] {
    return has_ended || client.state() == LinkState::given_up ||
           (has_unreadable && !has_samples && Clock::now() > settled);
  });
  samples.cancel();
  const bool is_complete = write_rest(lines);
  counter.finish();
  // The rate of a capture may differ.
  if (!background_stdout().is_closed() && !ends) report_losses(counter, lines.dropped());
  return has_unreadable || !is_complete ? failure : success;
}

}  // namespace

void add_stream(CLI::App& app, CommandContext& context) {
  const Subcommand<StreamOptions> command(app, context, "stream",
                                          "Show the values of a data stream");
  auto& options = command.options();
  command
      ->add_option("name", options.name,
                   "The message, such as RealtimeData4; without it, the angles")
      ->type_name("STREAM");
  auto* const id = command->add_option("--id", options.id,
                                       "Show the bytes of the stream with this message id, which "
                                       "may be unknown");
  id->type_name("NUMBER")->check(CLI::Range(1, 255));
  command->add_option("--config", options.config, "CONFIG of the request for --id; 0 by default")
      ->type_name("HEX")
      ->needs(id);
  add_rate(*command, options.rate);
  add_format(*command, options.format, {"text", "jsonl", "csv"}, "Output format; text is a table");
  command
      ->add_option("--fields", options.fields,
                   "Only these fields, separated by commas: paths, unique ends of paths, or "
                   "patterns with *")
      ->type_name("FIELDS");
  command
      ->add_option("--with", options.with,
                   "What the messages contain, if the request selects it: flags joined by |, or "
                   "NAME=VALUE, separated by commas. By default, what --fields needs")
      ->type_name("FLAGS");
  add_duration(*command, "--for", options.time, "Stop after this time; otherwise with Ctrl-C");
  command->add_flag("--unix-time", options.unix_time,
                    "Print the time since 1970 instead of since the start");
  command->footer(
      "Values are in their units. In CSV, names and flags are numbers, and undefined values are "
      "empty. The time is the time of arrival. If the line is lost, the command reconnects and "
      "continues. With firmware that has no data streams (before 2.59), it requests each "
      "message. The exit status is 0 if the stream was shown until its end, Ctrl-C included, 1 "
      "if there is no connection or no such stream on this board, or if messages could not be "
      "decoded, 2 for wrong usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc stream --for 2s\n"
      "  sbgc stream RealtimeData4 --fields \"angle.*\" --for 1s\n"
      "  sbgc stream --id 23 --rate 10 --for 2s\n"
      "  sbgc stream RealtimeDataCustom --with \"IMU_ANGLES|RC_DATA\" --format csv --for 1s");
  command.runs(run_stream);
}

}  // namespace sbgc::tools
