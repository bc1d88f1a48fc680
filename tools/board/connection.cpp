#include "board/connection.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/io/clock.hpp>
#include <sbgc/io/observer.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/parser.hpp>

#include "board/capture_check.hpp"
#include "board/configuration.hpp"
#include "board/listed_ports.hpp"
#include "board/password.hpp"
#include "board/progress_bar.hpp"
#include "command/command_error.hpp"
#include "command/interruption.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"
#include "frames/decoded_frame.hpp"
#include "frames/frame_text.hpp"

namespace sbgc::tools {

namespace {

class FramePrinter final : public io::Observer {
 public:
  void on_read(std::span<const std::uint8_t> bytes) override {
    from_board_.feed(bytes, [this](const Frame& frame) { print(frame, Direction::from_board); });
  }
  void on_written(std::span<const std::uint8_t> bytes) override {
    to_board_.feed(bytes, [this](const Frame& frame) { print(frame, Direction::to_board); });
    to_board_.flush([this](const Frame& frame) { print(frame, Direction::to_board); });
  }
  void on_line_set(const LineSettings& settings) override {
    remark("{}  line: {}\n", time(), io::to_string(settings));
  }

 private:
  std::string time() const {
    const std::chrono::duration<double> passed = io::Clock::now() - start_;
    return fmt::format("{:.6f} s", passed.count());
  }

  void print(const Frame& frame, Direction direction) {
    std::string text = time();
    StringOutput out(text);
    put_text(out, decoder_.decode(frame, direction), colors_);
    out.finish();
    remark("{}", text);
  }

  io::Clock::time_point start_ = io::Clock::now();
  Colors colors_{stderr};
  ParserOfAll from_board_;
  ParserOfAll to_board_;
  FrameDecoder decoder_{{.json = false, .rows = true}};
};

/// Returns `inner`, or nothing, followed by an observer that prints each frame.
Wrap with_frame_printer(Wrap inner) {
  return [inner = std::move(inner)](std::unique_ptr<io::Transport> transport) {
    if (inner) transport = inner(std::move(transport));
    return io::observe(std::move(transport), std::make_shared<FramePrinter>());
  };
}

/// The search for gimbals on all serial ports takes no longer than this by default.
constexpr std::chrono::milliseconds search_time{5'000};

struct Probe {
  std::string port{};
  Result<BoardIdentity> board = ClientError{};
};

Result<BoardIdentity> probe(const std::string& port, const ConnectOptions& options) {
  const Result<Client> client = Client::connect(port, options);
  if (!client) return client.error();
  return client->identity();
}

/// Probes all ports at the same time. A gimbal is likelier on an adapter than on a built-in port,
/// so if there are adapters, only these are probed.
std::vector<Probe> probe_all(const std::vector<io::PortInfo>& ports, ConnectOptions options) {
  const bool has_usb =
      std::ranges::any_of(ports, [](const io::PortInfo& port) { return port.usb.has_value(); });
  options.timeout = std::min(options.timeout, search_time);
  options.capture.reset();
  std::vector<std::pair<std::string, std::future<Result<BoardIdentity>>>> running;
  for (const io::PortInfo& port : ports) {
    if (has_usb && !port.usb) continue;
    running.emplace_back(port.name, std::async(std::launch::async, probe, port.name, options));
  }
  const ProgressBar bar;
  std::vector<Probe> probes;
  probes.reserve(running.size());
  for (auto& [port, result] : running) {
    while (result.wait_for(std::chrono::milliseconds(200)) != std::future_status::ready) {
      const auto waiting = std::ranges::count_if(running, [](const auto& one) {
        return one.second.valid() &&
               one.second.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
      });
      bar.show(fmt::format("searching a gimbal: {} of {} may still answer", waiting,
                           counted(running.size(), "port")));
    }
    probes.push_back({port, result.get()});
  }
  return probes;
}

/// Returns why no gimbal was found, with a line for each cause: "  PORT, PORT  no board found".
std::string causes_of(const std::vector<Probe>& probes) {
  std::vector<std::pair<std::string, std::string>> ports_by_cause;
  for (const Probe& one : probes) {
    // Details are only for `--port`, and the port precedes the cause.
    std::string cause = one.board.error().message;
    cause = cause.substr(0, std::min({cause.find_first_of(":\n,"), cause.find(". ")}));
    for (const std::string& name :
         {" on serial port " + one.port, ' ' + one.port, one.port + ' '}) {
      const std::size_t at = cause.find(name);
      if (at != std::string::npos) cause.erase(at, name.size());
    }
    cause = as_message(cause);
    const auto same =
        std::ranges::find(ports_by_cause, cause, [](const auto& it) { return it.first; });
    if (same == ports_by_cause.end()) {
      ports_by_cause.emplace_back(cause, one.port);
    } else {
      same->second += ", " + one.port;
    }
  }
  std::string result;
  for (const auto& [cause, ports] : ports_by_cause)
    result.append("\n  ").append(ports).append("  ").append(cause);
  return result;
}

/// Returns the port of the only gimbal.
std::string find_gimbal_port(const ConnectOptions& options) {
  const io::PortList list = listed_ports();
  if (list.error) throw CommandError(without_period(list.error.message));
  if (list.ports.empty()) {
    throw CommandError("there are no serial ports to search for a gimbal; use --port");
  }
  const std::vector<Probe> probes = probe_all(list.ports, options);
  std::vector<const Probe*> found;
  std::string answered;
  for (const Probe& one : probes) {
    if (!one.board) continue;
    found.push_back(&one);
    answered += fmt::format("\n  {}  board {}, firmware {}", one.port, one.board->board_version(),
                            one.board->firmware_version());
    if (const std::string serial = one.board->serial_number(); !serial.empty()) {
      answered += ", serial number " + serial;
    }
  }
  if (found.size() == 1) return found.front()->port;
  if (found.empty())
    throw CommandError("found no gimbal; use --port. Searched:" + causes_of(probes));
  throw CommandError("found several gimbals; choose one with --port:" + answered);
}

}  // namespace

std::string line_to_gimbal(const std::string& own) {
  const char* const behind = std::getenv(shell_line_variable);
  return behind != nullptr ? behind : own;
}

void require_address(const std::string& address) {
  const io::AddressResult parsed = io::parse_address(address);
  if (!parsed) throw CommandError(parsed.error.message, wrong_usage);
}

LineChoice choose_line(const GimbalOptions& given, Wrap wrap) {
  const GimbalOptions options = with_configuration(given);
  LineChoice choice{options.port, connect_options(options)};
  if (choice.address.empty()) choice.address = find_gimbal_port(choice.options);
  require_address(choice.address);
  if (const std::string damage = damage_at(choice.address); !damage.empty()) {
    remark_warning(damage);
    *options.is_incomplete = true;
  }
  choice.options.wrap = std::move(wrap);
  if (options.verbose) choice.options.wrap = with_frame_printer(std::move(choice.options.wrap));
  return choice;
}

Client connect(const GimbalOptions& options, Wrap wrap) {
  const LineChoice line = choose_line(options, std::move(wrap));
  return value_of(Client::connect(line.address, line.options));
}

void fail(const ClientError& error) {
  const bool is_interrupted = error.code == ErrorCode::cancelled && was_interrupted();
  const bool is_unknown = error.code == ErrorCode::unconfirmed;
  throw CommandError(error.message, is_interrupted ? interrupted
                                    : is_unknown   ? cannot_tell
                                                   : failure);
}

GimbalOptions with_configuration(const GimbalOptions& options) {
  if (options.name.empty()) return options;
  if (!options.port.empty()) {
    throw CommandError("--port and --gimbal exclude each other", wrong_usage);
  }
  const NamedGimbal named = find_gimbal(options.name);
  GimbalOptions result = options;
  result.port = named.port;
  if (!result.timeout) result.timeout = named.timeout;
  if (!result.attempts) result.attempts = named.attempts;
  if (result.password_file.empty()) result.password_file = named.password_file;
  if (!result.attempt_timeout) result.attempt_timeout = named.attempt_timeout;
  return result;
}

void warn_of_password_in(const std::string& capture) {
  remark("sbgc: {} will hold the password: keep it private\n",
         capture == "-" ? "the capture" : capture);
}

ConnectOptions connect_options(const GimbalOptions& options) {
  ConnectOptions result;
  if (options.timeout) result.timeout = *options.timeout;
  if (options.attempts) result.retries = *options.attempts - 1;
  if (options.attempt_timeout) result.attempt_timeout = *options.attempt_timeout;
  if (!options.password_file.empty()) {
    // Otherwise every device on this machine would receive the password.
    if (options.port.empty()) {
      throw CommandError("--password-file needs --port or --gimbal", wrong_usage);
    }
    const std::string whose = options.name.empty() ? options.port : "gimbal " + options.name;
    result.password = read_password(options.password_file, whose);
    if (!options.capture.empty()) warn_of_password_in(options.capture);
  }
  result.capture = options.capture;
  result.on_capture_error = [is_incomplete = options.is_incomplete](const ClientError& error) {
    *is_incomplete = true;
    remark("sbgc: {}\n", error.message);
  };
  return result;
}

CallOptions call_options(const GimbalOptions& options) {
  CallOptions result;
  if (options.timeout) result.timeout = *options.timeout;
  return result;
}

bool is_replay(const GimbalOptions& options) {
  return with_configuration(options).port.starts_with("capture:");
}

Client connect_for_long(const GimbalOptions& options,
                        const std::function<void(ConnectOptions&)>& adjust) {
  LineChoice line = choose_line(options);
  if (adjust) adjust(line.options);
  ReconnectOptions reconnect;
  reconnect.connection = line.options;
  reconnect.list_ports = listed_ports;
  auto client = Client::connect(line.address, reconnect);
  // A recorded board responds at the recorded time, perhaps just before the request.
  for (int more = 4; !client && more > 0 && is_replay(options); --more) {
    client = Client::connect(line.address, reconnect);
  }
  return value_of(std::move(client));
}

Subscription report_changes(Client& client) {
  return client.on_change([](const LinkChange& change) {
    switch (change.state) {
      case LinkState::lost:
      case LinkState::other_board:
      case LinkState::given_up: return remark_failure(change.message);
      case LinkState::searching: return remark("sbgc: connecting again ...\n");
      case LinkState::connected: return remark("sbgc: connected again: {}\n", change.message);
      case LinkState::closed: return;
    }
  });
}

}  // namespace sbgc::tools
