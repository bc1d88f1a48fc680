// sbgc bridge: one board for several programs at once.

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/signal_set.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>

#include "board/progress_bar.hpp"
#include "command/background_output.hpp"
#include "command/interruption.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"
#include "hosts/endpoint.hpp"
#include "hosts/listen.hpp"
#include "share/places.hpp"
#include "share/shared_line.hpp"
#include "share/web_access.hpp"
#include "share/web_socket.hpp"

namespace sbgc::tools {

namespace {

constexpr std::chrono::milliseconds tick_time{100};
constexpr int ticks_per_status = 10;
constexpr const char* token_variable = "SBGC_TOKEN";

struct BridgeOptions {
  std::string address{};
  Places places{};
  std::vector<hosts::ListenAddress> web_sockets{};
  WebSocketAccess access{};
  bool allows_passwords = false;
  bool is_token_private = false;  ///< it comes from the environment
  std::optional<std::chrono::milliseconds> time{};
};

/// All objects that exist while hosts are served.
class BridgeService {
 public:
  BridgeService(asio::io_context& context, const CommandContext& command,
                const BridgeOptions& options)
      : timer_(context),
        signals_(context),
        line_(context, command.gimbal,
              {.allows_passwords = options.allows_passwords, .log = log, .on_change = changed}) {
    log(line_.client().description());
    // Before this, a signal ends the program at once.
    for (const int signal : asking_signals()) signals_.add(signal);
    signals_.async_wait([&context](std::error_code error, int) {
      if (!error) context.stop();
    });
    endpoints_ = open_places(context.get_executor(), line_.ports(), options.places,
                             BridgePorts::max_ports, "bridge", {log, log});
    for (const hosts::ListenAddress& at : options.web_sockets) {
      endpoints_.push_back(
          listen_web_socket(context.get_executor(), line_.ports(), at, options.access, {log, log}));
      const std::string address = endpoints_.back()->address();
      const std::string shown = options.is_token_private ? "" : "/?token=" + options.access.token;
      background_stdout().write(printable(fmt::format("bridge: {}{}\n", address, shown)));
      if (!options.access.pages.empty()) {
        background_stdout().write(printable(page_line(address, options)));
      }
    }
    tick();
  }
  BridgeService(const BridgeService&) = delete;
  BridgeService& operator=(const BridgeService&) = delete;
  ~BridgeService() {
    line_.client().close();
    endpoints_.clear();
  }

 private:
  /// A browser does not send the part of an address after '#'.
  static std::string page_line(const std::string& address, const BridgeOptions& options) {
    const std::string secret = options.is_token_private ? "" : "#token=" + options.access.token;
    return fmt::format("bridge: http{}/setup.html{}\n", address.substr(address.find(':')), secret);
  }

  static void log(const std::string& text) { remark("sbgc: {}\n", text); }

  static void changed(const LinkChange& change) {
    log(change.state == LinkState::searching ? "connecting again ..." : change.message);
  }

  void tick() {
    line_.tick();
    if (++ticks_ % ticks_per_status == 0) show_status();
    timer_.expires_after(tick_time);
    timer_.async_wait([this](std::error_code error) {
      if (!error) tick();
    });
  }

  void show_status() {
    const std::vector<BridgePorts::HostCounters> hosts = line_.ports().counters();
    std::string text =
        fmt::format("{}, {}", name(line_.client().state()), counted(hosts.size(), "host"));
    if (const auto host = line_.ports().exclusive_host()) {
      text += fmt::format(" | host {} has the line for itself", *host);
    }
    for (const auto& host : hosts) {
      text += fmt::format(" | {}: {} in, {} out", host.port, host.requests, host.messages);
      if (host.dropped != 0) text += fmt::format(", {} dropped", host.dropped);
    }
    status_.show(text);
  }

  asio::steady_timer timer_;
  asio::signal_set signals_;
  SharedLine line_;
  ProgressBar status_;
  int ticks_ = 0;
  std::vector<std::unique_ptr<hosts::Endpoint>> endpoints_{};
};

int run_bridge(const BridgeOptions& options, const CommandContext& context) {
  remark_in_background();
  std::signal(SIGPIPE, SIG_IGN);
  asio::io_context loop(1);
  asio::steady_timer end(loop);
  if (options.time) {
    end.expires_after(*options.time);
    end.async_wait([&](std::error_code error) {
      if (!error) loop.stop();
    });
  }
  const BridgeService service(loop, context, options);
  loop.run();
  finish_stdout();
  return success;
}

void take_address(const BridgeOptions& options, GimbalOptions& gimbal) {
  if (options.address.empty()) return;
  if (!gimbal.port.empty() || !gimbal.name.empty()) {
    throw CommandError("the address is given twice", wrong_usage);
  }
  gimbal.port = options.address;
}

/// Throws CommandError if no place for programs is given, or an option lacks its kind of place.
void require_places(const BridgeOptions& options, bool has_token) {
  if (options.places.empty() && options.web_sockets.empty()) {
    throw CommandError("choose where programs connect: --tcp, --udp, --pty, --link, --ws or --page",
                       wrong_usage);
  }
  if (!options.web_sockets.empty()) return;
  if (has_token) throw CommandError("--token is for --ws, which is missing", wrong_usage);
  if (!options.access.origins.empty()) {
    throw CommandError("--origin is for --ws, which is missing", wrong_usage);
  }
}

/// Throws CommandError if pages would be served to other machines, in clear text with the token.
void require_own_machine(const BridgeOptions& options) {
  if (options.access.pages.empty()) return;
  for (const hosts::ListenAddress& at : options.web_sockets) {
    if (hosts::address_of(at).is_loopback()) continue;
    throw CommandError(
        "--page is only for this machine: for others, put a server with TLS before the bridge, and "
        "let --ws listen on 127.0.0.1",
        wrong_usage);
  }
}

/// Selects the token: from the command line, the environment, or a new one.
void choose_token(BridgeOptions& options) {
  if (options.web_sockets.empty() || !options.access.token.empty()) return;
  const char* const from_environment = std::getenv(token_variable);
  options.is_token_private = from_environment != nullptr && *from_environment != '\0';
  options.access.token = options.is_token_private ? from_environment : make_token();
  const std::string problem = token_problem(options.access.token);
  if (!problem.empty()) {
    throw CommandError(fmt::format("{}: {}", token_variable, problem), wrong_usage);
  }
}

}  // namespace

void add_bridge(CLI::App& app, CommandContext& context) {
  const Subcommand<BridgeOptions> command(app, context, "bridge",
                                          "Share one gimbal between several programs");
  auto& options = command.options();
  command->add_option("address", options.address, "The address of the gimbal, as in --port")
      ->check(why_not_empty)
      ->type_name("ADDRESS");
  add_places(*command, options.places);
  add_listen(*command, "--ws", options.web_sockets,
             "Listen for WebSockets, whose binary messages carry the protocol");
  auto* const token = command->add_option(
      "--token", options.access.token,
      "The secret of WebSockets; by default a random text, which is printed. Other users see the "
      "command line, so prefer the environment variable SBGC_TOKEN");
  token->check(token_problem)->type_name("TEXT")->group(places_group);
  command
      ->add_option("--origin", options.access.origins,
                   "A web site whose pages may connect, such as http://localhost:8000; none by "
                   "default")
      ->take_all()
      ->allow_extra_args(false)
      ->check(origin_problem)
      ->type_name("ORIGIN")
      ->group(places_group);
  command
      ->add_option("--page", options.access.pages,
                   "Also serve the reference site in this folder, with the page that sets up the "
                   "gimbal; without --ws, on a free port of this machine")
      ->check(page_folder_problem)
      ->type_name("FOLDER")
      ->group(places_group);
  command->add_flag(
      "--allow-passwords", options.allows_passwords,
      "Accept passwords, from --password-file and from programs; each opens the gimbal for all "
      "programs");
  add_duration(*command, "--for", options.time, "Stop after this time; otherwise with Ctrl-C");
  command->footer(
      "Each program talks to the gimbal as if it were alone. The bridge executes requests one "
      "after another, and returns each response to the program that asked. Each program gets the "
      "streams and rates that it requests, but a stream has one configuration at a time: a "
      "request for other contents of RealtimeDataCustom gets an error. Other messages go to all "
      "programs. If the line is lost, the programs stay connected, and the bridge reconnects and "
      "restarts the streams. Anyone who can connect can move the gimbal: only programs on this "
      "machine, unless HOST says otherwise. A web page connects with new WebSocket(url, "
      "[\"sbgc\", \"token.TOKEN\"]), or with '?token=TOKEN' in the URL. The exit status is 0 "
      "after Ctrl-C, 1 if the gimbal is not found or the bridge cannot listen, 2 for wrong "
      "usage.\n"
      "\n"
      "Examples:\n"
      "  sbgc bridge /dev/ttyUSB0 --tcp 5000\n"
      "  sbgc bridge --link /tmp/gimbal --tcp 5000 -p tcp:10.0.0.7:5000");
  command.runs([token](BridgeOptions& chosen, CommandContext& shared) {
    take_address(chosen, shared.gimbal);
    if (!chosen.access.pages.empty() && chosen.web_sockets.empty()) {
      chosen.web_sockets.emplace_back();
    }
    require_own_machine(chosen);
    require_places(chosen, token->count() != 0);
    choose_token(chosen);
    return run_bridge(chosen, shared);
  });
}

}  // namespace sbgc::tools
