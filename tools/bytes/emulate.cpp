// sbgc emulate: emulated gimbals.

#include <chrono>
#include <csignal>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>
#include <sys/resource.h>

#include <sbgc/internal/words.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/text.hpp>

#include "board/password.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "frames/command_lookup.hpp"
#include "serving/arguments.hpp"
#include "serving/faults.hpp"
#include "serving/service.hpp"
#include "values/field_text.hpp"

namespace sbgc::tools {

namespace {

using serving::Service;
using serving::ServiceOptions;

struct EmulateOptions {
  ServiceOptions service{};
  std::uint32_t seed = 1;
  bool verbose = false;
  std::string password_file{};
  std::optional<Duration> seconds{};
  std::optional<std::chrono::milliseconds> time{};
};

const char* to_text(emulator::Reaction reaction) {
  switch (reaction) {
    case emulator::Reaction::executed: return "executed";
    case emulator::Reaction::refused: return "refused";
    case emulator::Reaction::unknown: return "not supported";
    case emulator::Reaction::malformed: return "malformed";
    case emulator::Reaction::lost: return "lost: input buffer full";
    case emulator::Reaction::not_listening: return "not listening";
    case emulator::Reaction::locked: return "ignored: wants the password first";
  }
  return "?";
}

/// Returns, for example, "    1.2340  host 0 > CMD_BOARD_INFO (86), 0 bytes  executed", with `>`
/// for frames to the board and `<` for frames from it.
std::string describe_frame(const emulator::Board::Traffic& traffic) {
  const Direction direction = traffic.reaction ? Direction::to_board : Direction::from_board;
  const Frame& frame = traffic.frame;
  const std::string name = command_name(frame.id, direction);
  std::string result = fmt::format(
      "{:10.4f}  host {} {} {} ({}), {}", static_cast<double>(traffic.at.us) * 1e-6, traffic.port,
      traffic.reaction ? '>' : '<', name.empty() ? "unknown command" : name, frame.id,
      counted(frame.body.size(), "byte"));
  if (traffic.reaction) result += fmt::format("  {}", to_text(*traffic.reaction));
  return result;
}

/// Raises the limit of open files: each pseudo-terminal needs two, each host one.
void allow_many_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);  // on failure, opening a file reports the error
}

int serve(const EmulateOptions& options) {
  remark_in_background();
  const auto to_stderr = [](const std::string& text) { remark("{}\n", text); };
  const auto to_stdout = [](const std::string& text) {
    background_stdout().write(printable(text) + '\n');
  };
  serving::ServiceLogs logs;
  logs.endpoint = to_stdout;
  // Standard output carries the bytes for the host.
  if (options.service.stdio) logs.endpoint = to_stderr;
  logs.warning = [](const std::string& text) { remark("sbgc: {}\n", text); };
  if (options.verbose) {
    logs.event = logs.endpoint;
    logs.describe_frame = describe_frame;
  }

  allow_many_files();
  std::signal(SIGPIPE, SIG_IGN);  // a closed reader must not kill the process
  asio::io_context context(1);
  asio::signal_set signals(context);
  for (const int signal : asking_signals()) signals.add(signal);
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
  if (!options.service.stdio) finish_stdout();
  return is_saved && !problem ? success : failure;
}

/// Adds an option whose value is parsed by `parse`.
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

/// Returns 0 for "settings".
std::uint32_t parse_rate(const std::string& text) {
  if (detail::is_same_word(text, "settings")) return 0;
  std::uint32_t rate = 0;
  if (!CLI::detail::lexical_cast(text, rate) || rate < slowest_rate || rate > fastest_rate) {
    throw std::invalid_argument(
        fmt::format("'{}' is neither a baud rate from {} to {} nor 'settings'", text, slowest_rate,
                    fastest_rate));
  }
  return rate;
}

std::string problem_of_path(const std::string& path) {
  return path.empty() ? "the path is empty" : "";
}

msg::FirmwareVersion firmware_to_emulate(const std::string& text) {
  const auto version = parse_firmware(text);
  std::string problem = version ? serving::problem_of(*version)
                                : fmt::format("'{}' is not {}", text, firmware_example);
  if (!problem.empty()) throw std::invalid_argument(problem);
  return *version;
}

void add_board_options(CLI::App& command, EmulateOptions& options) {
  ServiceOptions& service = options.service;
  emulator::BoardOptions& board = service.emulator.board;
  command
      .add_option("--password-file", options.password_file,
                  "File of mode 0600 with a password that hosts must send first; - asks for it")
      ->type_name("FILE")
      ->group("The board");
  add_parsed(
      command, "--firmware", firmware_to_emulate,
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
      "Board version [3.0, or 3.6 with firmware that has commands for it]", "VERSION")
      ->group("The board");
  command
      .add_option("--input-buffer", board.input_buffer,
                  "Size of the request queue in bytes; requests that do not fit are lost; 0: "
                  "no limit")
      ->check(CLI::Range(0, 1 << 20))
      ->type_name("BYTES")
      ->capture_default_str()
      ->group("The board");
  command
      .add_option("--calibration-time", board.calibration_time,
                  "Duration of calibrations and tuning in percent of the usual one")
      ->check(CLI::Range(0, 1000))
      ->type_name("PERCENT")
      ->capture_default_str()
      ->group("The board");
  command
      .add_flag("--strict", board.is_strict,
                "Refuse requests with surplus bytes, which real boards ignore")
      ->group("The board");
  add_parsed(
      command, "--motion", serving::parse_motion,
      [&](const emulator::Disturbance& motion) { board.gimbal.frame = motion; },
      "Motion of the frame: rest, handheld, drone, vehicle, or a CSV file with lines "
      "time,roll,pitch,yaw in seconds and degrees, which repeats [rest]",
      "rest|handheld|drone|vehicle|FILE")
      ->group("The board");
  command
      .add_option_function<std::string>(
          "--fault",
          [&](const std::string& list) {
            const std::string problem = serving::add_faults(list, board);
            if (!problem.empty()) throw CLI::ValidationError("--fault", problem);
          },
          "Faults of the gimbal, which `sbgc doctor` finds; separate several with commas: " +
              serving::fault_names())
      ->type_name("FAULT[,FAULT]")
      ->group("The board");
  add_parsed(
      command, "--reset-at", serving::parse_seconds,
      [&](Duration at) { service.emulator.restart_at = at; }, "Restart the board after this time",
      "SECONDS")
      ->group("The board");
  command
      .add_option(
          "--state", service.state,
          "File for the non-volatile memory of the board; the board confirms a change once it is "
          "saved; with --count: FILE-1, FILE-2 ...")
      ->type_name("FILE")
      ->check(problem_of_path)
      ->group("The board");
  command.add_option("--count", service.count, "Number of boards")
      ->check(CLI::Range(1, 1000))
      ->type_name("NUMBER")
      ->capture_default_str()
      ->group("The board");
  command
      .add_option("--seed", options.seed,
                  "Seed of the random numbers; the same seed gives the same noise")
      ->type_name("NUMBER")
      ->capture_default_str()
      ->group("The board");
}

void add_endpoint_options(CLI::App& command, EmulateOptions& options) {
  ServiceOptions& service = options.service;
  command.add_flag("--pty", service.terminal, "A pseudo-terminal; the default")
      ->group("Where hosts connect");
  command
      .add_option("--link", service.link,
                  "A symbolic link to the pseudo-terminal; with --count: PATH-1, "
                  "PATH-2 ...")
      ->type_name("PATH")
      ->check(problem_of_path)
      ->group("Where hosts connect");
  const auto add_listen = [&](const char* name, std::optional<hosts::ListenAddress>& address,
                              const char* help) {
    add_parsed(
        command, name, serving::parse_listen,
        [&address](const hosts::ListenAddress& parsed) { address = parsed; }, help, "[HOST:]PORT")
        ->group("Where hosts connect");
  };
  add_listen("--tcp", service.tcp,
             "Listen on this TCP port, 0 for any free one; on localhost unless HOST is another "
             "address of this machine; with --count: on this port and the following ones");
  add_listen("--udp", service.udp,
             "Listen on this UDP port. Each sender is a host; if all places are taken, a new "
             "host replaces a silent one. A board has 8 places; TCP and UDP get half each");
  command
      .add_flag("--stdio", service.stdio,
                "Standard input and output; messages go to standard error")
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
      "Limit the rate; a host with another rate on the pseudo-terminal sends and receives "
      "garbage; 'settings' selects the rate in the board's parameters [no limit]",
      "RATE");
  command
      .add_option_function<std::string>(
          "--parity",
          [&](const std::string& parity) {
            line.board.parity = parity == "even" ? Parity::even : Parity::none;
          },
          "Parity of the line; a byte with parity takes 11 bits [none]")
      ->transform(one_of({"none", "even"}))
      ->type_name("PARITY")
      ->group("The line");
  const auto add_share = [&](const char* name, double& share, const char* help) {
    add(
        name, serving::parse_share, [&share](double parsed) { share = parsed; }, help, "SHARE");
  };
  add_share("--bit-errors", faults.bit_errors, "Share of flipped bits");
  add_share("--lose", faults.lost, "Share of lost bytes");
  add_share("--duplicate", faults.duplicated, "Share of duplicated bytes");
  add(
      "--delay", serving::parse_delay,
      [&](const serving::DelayFault& delay) {
        faults.delayed = delay.share;
        faults.delay = delay.delay;
      },
      "Share of bytes that arrive 20 ms late, or by this time; later bytes wait", "SHARE[:MS]");
  add(
      "--text", serving::parse_interval, [&](Duration every) { faults.text_every = every; },
      "Interval of text lines between frames of the board", "SECONDS");
  add(
      "--silence", serving::parse_silence,
      [&](const emulator::Silence& silence) { faults.silences.push_back(silence); },
      "A period in seconds in which the line carries nothing; may be repeated", "FROM:LENGTH")
      ->take_all()
      ->trigger_on_parse();
}

/// Checks and completes combinations of options.
void check(EmulateOptions& options) {
  ServiceOptions& service = options.service;
  if (!service.tcp && !service.udp && !service.stdio) service.terminal = true;
  if (!service.link.empty()) service.terminal = true;
  if (service.stdio && service.count > 1) {
    throw CLI::ValidationError("--stdio", "requires --count 1");
  }
  for (const auto* const address : {&service.tcp, &service.udp}) {
    if (*address && (*address)->port != 0 &&
        (*address)->port + service.count - 1 > std::numeric_limits<std::uint16_t>::max()) {
      throw CLI::ValidationError("--count", fmt::format("there are fewer than {} ports from {}",
                                                        service.count, (*address)->port));
    }
  }
  service.emulator.line.seed = options.seed;
  service.emulator.board.gimbal.seed = options.seed;
}

}  // namespace

void add_emulate(CLI::App& app, CommandContext& context) {
  const Subcommand<EmulateOptions> command(app, context, "emulate",
                                           "Emulate gimbals for programs that talk to them");
  auto& options = command.options();
  add_endpoint_options(*command, options);
  add_board_options(*command, options);
  add_line_options(*command, options);
  command->add_flag("-v,--verbose", options.verbose,
                    "Print each frame, and report hosts that connect and disconnect");
  add_parsed(
      *command, "--seconds", serving::parse_seconds,
      [&options](Duration time) { options.seconds = time; }, "The former name of --for", "SECONDS");
  command->get_option("--seconds")->group("");
  add_duration(*command, "--for", options.time, "Stop after this time; otherwise with Ctrl-C");
  command->footer(
      "A SHARE is 0.01 or 1%. The command first prints a line for each endpoint:\n"
      "  emulated gimbal 1: /dev/pts/7 (also /tmp/gimbal)\n"
      "\n"
      "Examples:\n"
      "  sbgc emulate --link /tmp/gimbal --verbose\n"
      "  sbgc emulate --tcp 5000 --count 20 --state gimbals/state\n"
      "  sbgc emulate --baud 115200 --bit-errors 1e-5 --text 2 --silence 30:5\n"
      "  sbgc emulate --fault low-battery,resonance=37Hz:0.1:pitch\n"
      "  sbgc emulate --firmware 2.43b9 --board 3.0 --motion handheld\n"
      "\n"
      "The exit status is 0 after Ctrl-C, a termination signal, --for or the end of standard "
      "input; 1 if something cannot be opened or saved; 2 for wrong usage, including a motion "
      "file that cannot be read.");
  command.runs([](EmulateOptions& chosen) {
    check(chosen);
    if (chosen.time) chosen.seconds = sbgc::milliseconds(chosen.time->count());
    if (!chosen.password_file.empty()) {
      chosen.service.emulator.board.password =
          read_password(chosen.password_file, "the emulated board");
    }
    return serve(chosen);
  });
}

}  // namespace sbgc::tools
