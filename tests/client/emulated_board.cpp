#include "emulated_board.hpp"

#include <sbgc/emulator/uart.hpp>

namespace sbgc::test {

namespace {

/// The board executes a request in its next cycle, which is shorter than this.
constexpr Duration one_cycle = sbgc::milliseconds(1);

hosts::EndpointLogs silent() {
  return {[](const std::string&) {}, [](const std::string&) {}};
}

}  // namespace

emulator::EmulatorOptions quick_board() {
  emulator::EmulatorOptions options;
  options.line.board.baud_rate = 0;
  options.board.gimbal.noise = 0;
  return options;
}

EmulatedBoard::EmulatedBoard(emulator::EmulatorOptions options, emulator::Memory memory,
                             bool is_tapped)
    : options_(std::move(options)), is_tapped_(is_tapped) {
  start(std::move(memory));
}

EmulatedBoard::~EmulatedBoard() { stop(); }

void EmulatedBoard::stop() {
  if (!running_) return;
  // Before anything else, because the board's thread reads running_.
  running_->context.stop();
  if (running_->thread.joinable()) running_->thread.join();
  running_.reset();
}

EmulatedBoard::Running::~Running() {
  if (host) host->close();
  host.reset();
  endpoint.reset();
}

void EmulatedBoard::start(emulator::Memory memory) {
  stop();
  running_ = std::make_unique<Running>();
  Running& running = *running_;
  const asio::any_io_executor executor = running.context.get_executor();
  running.board = std::make_unique<serving::LiveBoard>(executor, options_, std::move(memory));
  running.back_door = running.board->connect(true, [] {}).value();
  if (is_tapped_) {
    running.board->between = [this](std::unique_ptr<io::Transport> transport) {
      return std::make_unique<Tap>(std::move(transport), hooks_);
    };
    // Posted, because the board must not be called from within the hook.
    running.board->emulator().board().on_traffic =
        [this, executor, back_door = running.back_door](const emulator::Board::Traffic& traffic) {
          if (!traffic.reaction || traffic.port == back_door) return;
          asio::post(executor, [this] {
            if (hooks_.tap != nullptr) hooks_.tap->request_executed();
          });
        };
  }
  const bool has_rate = options_.line.board.baud_rate != 0 || options_.rate_from_parameters;
  if (line_kind() == LineKind::terminal) {
    running.endpoint = hosts::open_terminal(executor, *running.board, "", has_rate, silent());
  } else if (line_kind() == LineKind::tcp) {
    running.endpoint = listen(running);
  }
  running.thread = std::thread([&context = running.context] { context.run(); });
}

TransportFactory EmulatedBoard::line() {
  if (running_->endpoint) return over(running_->endpoint->address());
  return [this](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor, running_->context.get_executor());
    serve(std::move(pair.second));
    return std::move(pair.first);
  };
}

TransportFactory EmulatedBoard::line_with(const LineSettings& settings) {
  return [this, settings](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor, running_->context.get_executor(),
                                     {.with_line = true, .mismatch = emulator::received_as});
    static_cast<void>(pair.second->line()->set(settings));
    serve(std::move(pair.second));
    return std::move(pair.first);
  };
}

void EmulatedBoard::serve(std::unique_ptr<io::Transport> transport) {
  on_thread([&] {
    Running& running = *running_;
    if (running.host) running.host->close();
    running.host = hosts::Host::connect(*running.board, std::move(transport));
    running.host->start();
  });
}

std::unique_ptr<hosts::Endpoint> EmulatedBoard::listen(Running& running) {
  return hosts::listen_tcp(running.context.get_executor(), *running.board, {"127.0.0.1", 0},
                           emulator::Board::max_ports, silent());
}

std::string EmulatedBoard::serve_tcp() {
  return on_thread([this] {
    running_->endpoint = listen(*running_);
    return running_->endpoint->address();
  });
}

std::string EmulatedBoard::serve_terminal() {
  return on_thread([this] {
    running_->endpoint =
        hosts::open_terminal(running_->context.get_executor(), live(), "", false, silent());
    return running_->endpoint->address();
  });
}

void EmulatedBoard::become(const emulator::BoardOptions& options, emulator::Memory memory) {
  options_.board = options;
  start(std::move(memory));
}

emulator::BoardOptions EmulatedBoard::options() const { return options_.board; }

emulator::Memory EmulatedBoard::memory() {
  return on_thread([this] { return live().memory(); });
}

void EmulatedBoard::on_lost(std::function<bool(const Packet&)> is_lost) {
  on_thread([&] { hooks_.is_lost = std::move(is_lost); });
}
void EmulatedBoard::on_answer_lost(std::function<bool(const Packet&)> is_answer_lost) {
  on_thread([&] { hooks_.is_answer_lost = std::move(is_answer_lost); });
}
void EmulatedBoard::tamper(std::function<void(Packets&)> change) {
  on_thread([&] { hooks_.tamper = std::move(change); });
}
void EmulatedBoard::after(std::function<void(const Packet&)> action) {
  on_thread([&] { hooks_.after = std::move(action); });
}

Packets EmulatedBoard::log() {
  return on_thread([this] { return hooks_.log; });
}
void EmulatedBoard::clear_log() {
  on_thread([this] { hooks_.log.clear(); });
}

void EmulatedBoard::unplug() {
  on_thread([this] {
    if (hooks_.tap != nullptr) hooks_.tap->unplug();
  });
}

Packets EmulatedBoard::ask(const Packet& request) {
  return on_thread([&] {
    const std::size_t port = running_->back_door;
    Packets result;
    Parser parser;
    live().take(port, live().output(port).size());  // unsolicited frames
    live().receive(port, to_frame(request));
    live().skip(one_cycle);
    parser.feed(live().output(port), [&](const Frame& frame) {
      result.push_back({frame.id, {frame.body.begin(), frame.body.end()}});
    });
    live().take(port, live().output(port).size());
    return result;
  });
}

void EmulatedBoard::skip(std::chrono::milliseconds time) {
  on_thread([&] { live().skip(milliseconds(time.count())); });
}

}  // namespace sbgc::test
