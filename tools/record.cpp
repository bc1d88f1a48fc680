// sbgc record: records a line to a capture.

#include <array>
#include <csignal>
#include <cstdio>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <unistd.h>

#include <sbgc/io/open.hpp>
#include <sbgc/io/recorder.hpp>

#include "commands.hpp"
#include "wording.hpp"

namespace sbgc::tools {

namespace {

struct RecordOptions {
  std::string address;
  std::string file;
  std::optional<double> seconds;
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
  io::CaptureWriter writer;
  io::OpenResult opened = io::open(context.get_executor(), options.address);
  if (!opened) throw std::runtime_error(opened.error.message);
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
  asio::signal_set signals(context, SIGINT, SIGTERM);
  asio::steady_timer timer(context);
  Listener listener(*transport, [&] {
    signals.cancel();
    timer.cancel();
  });
  stop = [&] { listener.stop(); };
  const auto stop_unless_cancelled = [&](std::error_code cancelled) {
    if (!cancelled) stop();
  };
  signals.async_wait([&](std::error_code cancelled, int) { stop_unless_cancelled(cancelled); });
  if (options.seconds) {
    timer.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(*options.seconds)));
    timer.async_wait(stop_unless_cancelled);
  }
  if (!to_stdout) fmt::print("{}\n", transport->description());
  std::fflush(stdout);
  listener.read();
  context.run();
  if (!to_stdout) {
    fmt::print("{} recorded in {}\n", counted(listener.total(), "byte"), options.file);
  }
  if (!file_problem.empty()) throw std::runtime_error(file_problem);
  if (!listener.problem().empty()) throw std::runtime_error(listener.problem());
  return success;
}

}  // namespace

void add_record(CLI::App& app, int& status) {
  auto* const command = app.add_subcommand("record", "Record the output of a board to a capture");
  auto options = std::make_shared<RecordOptions>();
  command
      ->add_option("address", options->address,
                   "/dev/ttyUSB0, serial:PATH?baud=NUMBER&parity=none|even, tcp:HOST:PORT, "
                   "udp:HOST:PORT, pty: or capture:FILE")
      ->required();
  command
      ->add_option("file", options->file,
                   "The capture; an existing file gets a new session. - means standard output")
      ->required();
  command->add_option("--seconds", options->seconds, "Stop after this time; otherwise with Ctrl-C")
      ->check(CLI::Range(0.0, 1e9));
  command->footer(
      "Nothing is sent. `sbgc decode` shows a capture, and capture:FILE replays it; `sbgc record "
      "ADDRESS - | sbgc decode` shows the frames live. The exit status is 0 if everything was "
      "recorded, 1 if not, 2 for wrong usage.");
  command->callback([options, &status] { status = record_line(*options); });
}

}  // namespace sbgc::tools
