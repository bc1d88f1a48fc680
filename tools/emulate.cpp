// sbgc emulate: gimbals that are not there.

#include <chrono>
#include <csignal>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <sbgc/io/clock.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/text.hpp>

#include "command_lookup.hpp"
#include "commands.hpp"
#include "serving/arguments.hpp"
#include "serving/nonblocking_lines.hpp"
#include "serving/service.hpp"
#include "wording.hpp"

namespace sbgc::tools {

namespace {

using serving::Service;
using serving::ServiceOptions;

struct EmulateOptions {
  ServiceOptions service{};
  std::uint32_t seed = 1;
  bool verbose = false;
  std::optional<Duration> seconds{};
};

const char* to_text(emulator::Outcome outcome) {
  switch (outcome) {
    case emulator::Outcome::carried_out: return "carried out";
    case emulator::Outcome::refused: return "refused";
    case emulator::Outcome::unknown: return "unknown here";
    case emulator::Outcome::malformed: return "malformed";
    case emulator::Outcome::lost: return "lost: no room";
    case emulator::Outcome::not_listening: return "not listening";
  }
  return "?";
}

/// "    1.2340  host 0 > CMD_BOARD_INFO (86), 0 bytes  carried out", with `>` for frames to the
/// board and `<` for frames from it.
std::string describe_frame(const emulator::Board::Traffic& traffic) {
  const Direction direction = traffic.outcome ? Direction::to_board : Direction::from_board;
  const Frame& frame = traffic.frame;
  const std::string name = command_name(frame.id, direction);
  std::string result = fmt::format(
      "{:10.4f}  host {} {} {} ({}), {}", static_cast<double>(traffic.at.us) * 1e-6, traffic.port,
      traffic.outcome ? '>' : '<', name.empty() ? "unknown command" : name, frame.id,
      counted(frame.body.size(), "byte"));
  if (traffic.outcome) result += fmt::format("  {}", to_text(*traffic.outcome));
  return result;
}

/// Whether the terminal that is closed ends it: not with nohup.
bool heeds_hangup() {
  struct sigaction action {};
  return sigaction(SIGHUP, nullptr, &action) == 0 && action.sa_handler != SIG_IGN;
}

/// Each pseudo-terminal takes two files, and hosts take one each.
void allow_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);  // if not: what then cannot be opened says so
}

int serve(const EmulateOptions& options) {
  // Standard output belongs to the host then.
  const bool tells_on_stderr = options.service.stdio;
  // Hosts do not wait for readers of what is told, nor is one that has gone away, or a full disk, a
  // reason to leave them alone.
  serving::NonblockingLines problems(STDERR_FILENO);
  std::optional<serving::NonblockingLines> events;
  if (!tells_on_stderr) events.emplace(STDOUT_FILENO);
  serving::ServiceLogs logs;
  // A reader needs each of these. That it has failed shows in the exit status.
  logs.endpoint = [out = tells_on_stderr ? stderr : stdout](const std::string& text) {
    std::fputs((text + "\n").c_str(), out);
    std::fflush(out);
  };
  logs.warning = [&](const std::string& text) { problems.write_line("sbgc: " + text); };
  if (options.verbose) {
    logs.event = [&](const std::string& text) { (events ? *events : problems).write_line(text); };
    logs.describe_frame = describe_frame;
  }

  allow_many_files();
  std::signal(SIGPIPE, SIG_IGN);  // a reader of ours that goes away is no reason to end untidily
  asio::io_context context(1);
  asio::signal_set signals(context, SIGINT, SIGTERM);
  if (heeds_hangup()) signals.add(SIGHUP);
  signals.async_wait([&](std::error_code error, int) {
    if (!error) context.stop();
  });
  asio::steady_timer timer(context);
  if (options.seconds) {
    timer.expires_after(io::to_chrono(*options.seconds));
    timer.async_wait([&](std::error_code error) {
      if (!error) context.stop();
    });
  }
  std::error_code problem;
  Service service(context, options.service, logs, [&](std::error_code error) {
    problem = error;
    context.stop();
  });
  context.run();
  const bool is_saved = service.finish();
  if (!is_saved) logs.warning("not everything could be saved");
  if (problem) logs.warning("standard input and output: " + problem.message());
  return is_saved && !problem ? success : failure;
}

/// An option whose text is read by `parse`.
template <class Parse, class Use>
CLI::Option* add_parsed(CLI::App& command, const std::string& name, Parse parse, Use use,
                        const std::string& help, const char* type) {
  const auto read = [name, parse, use](const std::string& text) {
    try {
      use(parse(text));
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(name, error.what());
    }
  };
  return command.add_option_function<std::string>(name, read, help)->type_name(type);
}

constexpr std::uint32_t slowest_rate = 300;
constexpr std::uint32_t fastest_rate = 4'000'000;

/// 0 stands for the rate of the settings.
std::uint32_t parse_rate(const std::string& text) {
  if (text == "settings") return 0;
  std::uint32_t rate = 0;
  if (!CLI::detail::lexical_cast(text, rate) || rate < slowest_rate || rate > fastest_rate) {
    throw std::invalid_argument(fmt::format("'{}' is not a baud rate from {} to {}, nor 'settings'",
                                            text, slowest_rate, fastest_rate));
  }
  return rate;
}

std::string problem_of_path(const std::string& path) {
  return path.empty() ? "the path is empty" : "";
}

void add_board_options(CLI::App& command, EmulateOptions& options) {
  ServiceOptions& service = options.service;
  emulator::BoardOptions& board = service.emulator.board;
  add_parsed(
      command, "--firmware", serving::parse_firmware,
      [&](msg::FirmwareVersion version) {
        board.firmware = version;
        service.firmware_is_given = true;
      },
      "Firmware version, such as 2.43b9, up to " +
          to_string(msg::FirmwareVersion(newest_firmware)) + " [2.59]",
      "VERSION")
      ->group("The board");
  add_parsed(
      command, "--board", serving::parse_board,
      [&](msg::BoardVersion version) {
        board.board = version;
        service.board_is_given = true;
      },
      "Board version [3.0]", "VERSION")
      ->group("The board");
  command
      .add_option("--input-buffer", board.input_buffer,
                  "Room for requests that wait, in bytes; one that does not fit is lost whole; 0: "
                  "no limit")
      ->check(CLI::Range(0, 1 << 20))
      ->type_name("BYTES")
      ->capture_default_str()
      ->group("The board");
  add_parsed(
      command, "--motion", serving::parse_motion,
      [&](const emulator::Disturbance& motion) { board.gimbal.frame = motion; },
      "How the frame moves: rest, handheld, drone, vehicle, or a CSV file of lines "
      "time,roll,pitch,yaw in seconds and degrees, which is repeated [rest]",
      "KIND|FILE")
      ->group("The board");
  add_parsed(
      command, "--reset-at", serving::parse_seconds,
      [&](Duration at) { service.emulator.restart_at = at; }, "The board restarts by itself then",
      "SECONDS")
      ->group("The board");
  command
      .add_option(
          "--state", service.state,
          "What the board remembers without power: loaded if the file is there; each change "
          "is confirmed when the file has it; with --count FILE-1, FILE-2 ...")
      ->type_name("FILE")
      ->check(problem_of_path)
      ->group("The board");
  command.add_option("--count", service.count, "Number of boards")
      ->check(CLI::Range(1, 1000))
      ->type_name("N")
      ->capture_default_str()
      ->group("The board");
  command.add_option("--seed", options.seed, "Of all that is random: same seed, same noise")
      ->type_name("N")
      ->capture_default_str()
      ->group("The board");
}

void add_endpoint_options(CLI::App& command, EmulateOptions& options) {
  ServiceOptions& service = options.service;
  command
      .add_flag("--pty", service.terminal, "A pseudo-terminal; that is what there is without any")
      ->group("Where hosts connect");
  command
      .add_option("--link", service.link,
                  "A symbolic link to the pseudo-terminal while it exists; with --count PATH-1, "
                  "PATH-2 ...")
      ->type_name("PATH")
      ->check(problem_of_path)
      ->group("Where hosts connect");
  const auto add_listen = [&](const char* name, std::optional<serving::ListenAddress>& address,
                              const char* help) {
    add_parsed(
        command, name, serving::parse_listen,
        [&address](const serving::ListenAddress& parsed) { address = parsed; }, help, "[HOST:]PORT")
        ->group("Where hosts connect");
  };
  add_listen("--tcp", service.tcp,
             "Listen on this TCP port, 0 for any; of this machine alone unless HOST is another of "
             "its addresses; with --count on the ports behind it, too");
  add_listen("--udp", service.udp,
             "The same for UDP; each sender is a host, and when all places are taken, a new one "
             "takes that of the longest silent. A board has 8 places; TCP and UDP have half each");
  command.add_flag("--stdio", service.stdio, "Standard input and output; messages go to stderr")
      ->group("Where hosts connect");
}

void add_line_options(CLI::App& command, EmulateOptions& options) {
  emulator::EmulatorOptions& emulator = options.service.emulator;
  emulator::LineOptions& line = emulator.line;
  emulator::Faults& faults = line.faults;
  const auto add = [&](const char* name, auto parse, auto use, const char* help, const char* type) {
    return add_parsed(command, name, parse, use, help, type)->group("The line");
  };
  add(
      "--baud", parse_rate,
      [&](std::uint32_t rate) {
        emulator.rate_from_parameters = rate == 0;
        line.board.baud_rate = rate;
      },
      "Bytes take their time, and a host with another rate on the pseudo-terminal hears and says "
      "garbage; 'settings': the rate in the board's settings [no limit]",
      "RATE");
  command
      .add_option_function<std::string>(
          "--parity",
          [&](const std::string& parity) {
            line.board.parity = parity == "even" ? Parity::even : Parity::none;
          },
          "A byte with parity takes 11 bits [none]")
      ->check(CLI::IsMember({"none", "even"}))
      ->type_name("PARITY")
      ->group("The line");
  const auto add_share = [&](const char* name, double& share, const char* help) {
    add(
        name, serving::parse_share, [&share](double parsed) { share = parsed; }, help, "SHARE");
  };
  add_share("--bit-errors", faults.bit_errors, "Share of bits that are turned over");
  add_share("--lose", faults.lost, "Share of bytes that are lost");
  add_share("--duplicate", faults.duplicated, "Share of bytes that come twice");
  add(
      "--delay", serving::parse_delay,
      [&](const serving::DelayFault& delay) {
        faults.delayed = delay.share;
        faults.delay = delay.delay;
      },
      "Share of bytes that come later, by 20 ms or this time; those behind wait", "SHARE[:MS]");
  add(
      "--text", serving::parse_interval, [&](Duration every) { faults.text_every = every; },
      "A line of text between two frames of the board, so often", "SECONDS");
  add(
      "--silence", serving::parse_silence,
      [&](const emulator::Silence& silence) { faults.silences.push_back(silence); },
      "The line carries nothing, from then on for so long, in seconds; may be repeated",
      "FROM:LENGTH")
      ->take_all()
      ->trigger_on_parse();
}

/// What goes together, and what does not.
void check(EmulateOptions& options) {
  ServiceOptions& service = options.service;
  if (!service.tcp && !service.udp && !service.stdio) service.terminal = true;
  if (!service.link.empty()) service.terminal = true;
  if (service.stdio && service.count > 1) {
    throw CLI::ValidationError("--stdio", "there is only one, so that --count must be 1");
  }
  for (const auto* const address : {&service.tcp, &service.udp}) {
    if (*address && (*address)->port != 0 &&
        (*address)->port + service.count - 1 > std::numeric_limits<std::uint16_t>::max()) {
      throw CLI::ValidationError("--count", fmt::format("there are no {} ports from {} on",
                                                        service.count, (*address)->port));
    }
  }
  service.emulator.line.seed = options.seed;
  service.emulator.board.gimbal.seed = options.seed;
}

}  // namespace

void add_emulate(CLI::App& app, int& status) {
  auto* const command =
      app.add_subcommand("emulate", "Play gimbals, for programs that talk to them");
  auto options = std::make_shared<EmulateOptions>();
  add_endpoint_options(*command, *options);
  add_board_options(*command, *options);
  add_line_options(*command, *options);
  command->add_flag("-v,--verbose", options->verbose,
                    "Print each frame, and hosts that come and go");
  add_parsed(
      *command, "--seconds", serving::parse_seconds,
      [options](Duration time) { options->seconds = time; },
      "Stop after this time; else with Ctrl-C", "SECONDS");
  command->footer(
      "A SHARE is 0.01 or 1%. A line for each place to connect to is printed first:\n"
      "  emulated gimbal 1: /dev/pts/7 (also /tmp/gimbal)\n"
      "\n"
      "Examples:\n"
      "  sbgc emulate --link /tmp/gimbal --verbose\n"
      "  sbgc emulate --tcp 5000 --count 20 --state gimbals/state\n"
      "  sbgc emulate --baud 115200 --bit-errors 1e-5 --text 2 --silence 30:5\n"
      "  sbgc emulate --firmware 2.43b9 --board 3.0 --motion handheld\n"
      "\n"
      "The exit status is 0 when it was reported to end, by Ctrl-C, a signal, --seconds or the end "
      "of "
      "the standard input, 1 when something cannot be opened or saved, 2 for wrong usage, which "
      "includes a file of motion that cannot be read.");
  command->callback([options, &status] {
    check(*options);
    status = serve(*options);
  });
}

}  // namespace sbgc::tools
