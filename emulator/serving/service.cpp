#include "serving/service.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <sbgc/text.hpp>

#include "serving/arguments.hpp"
#include "serving/new_board.hpp"
#include "serving/state_keeper.hpp"

namespace sbgc::serving {

namespace {

/// Collects one line per frame, a request before its responses. The board reports its reaction to a
/// request only after it has sent the responses.
class FrameLog {
 public:
  explicit FrameLog(DescribeFrame describe) : describe_(std::move(describe)) {}

  void add(const emulator::Board::Traffic& traffic);
  /// Takes the lines since the last call. Must not be called while the board executes a request.
  std::vector<std::string> take();

 private:
  DescribeFrame describe_;
  std::vector<std::string> lines_{};
  std::size_t responses_ =
      0;  // responses at the end of lines_ whose request has not been reported yet
  Instant at_{};
  std::size_t port_ = 0;
};

void FrameLog::add(const emulator::Board::Traffic& traffic) {
  if (traffic.at != at_ || traffic.port != port_) responses_ = 0;
  at_ = traffic.at;
  port_ = traffic.port;
  const bool is_request = traffic.reaction.has_value();
  const auto place = lines_.end() - static_cast<std::ptrdiff_t>(is_request ? responses_ : 0);
  lines_.insert(place, describe_(traffic));
  responses_ = is_request ? 0 : responses_ + 1;
}

std::vector<std::string> FrameLog::take() {
  responses_ = 0;
  return std::exchange(lines_, {});
}

/// Adds to a big-endian number.
void add_to(std::span<std::uint8_t> bytes, unsigned number) {
  for (std::size_t i = bytes.size(); i-- > 0 && number != 0;) {
    number += bytes[i];
    bytes[i] = static_cast<std::uint8_t>(number & 0xFFU);
    number >>= 8U;
  }
}

std::string model(msg::BoardVersion board, msg::FirmwareVersion firmware) {
  return "a board " + to_string(board) + " with firmware " + to_string(firmware);
}

}  // namespace

Service::Service(asio::io_context& context, const ServiceOptions& options, ServiceLogs logs,
                 std::function<void(std::error_code)> on_end)
    : context_(context), options_(options), logs_(std::move(logs)), on_end_(std::move(on_end)) {
  for (hosts::Log* const log : {&logs_.endpoint, &logs_.event, &logs_.warning}) {
    if (!*log) *log = [](const std::string&) {};
  }
  boards_.reserve(options.count);
  for (unsigned number = 0; number < options.count; ++number) add(number);
}

void Service::add(unsigned number) {
  emulator::EmulatorOptions emulator = options_.emulator;
  emulator.line.seed += number;
  emulator.board.gimbal.seed += number;
  add_to(emulator.board.device_id, number);
  add_to(emulator.board.mcu_id, number);
  const std::string state = numbered_name(options_.state, number);
  std::shared_ptr<StateFile> file;
  std::optional<SavedMemory> saved;
  if (!state.empty()) {
    file = std::make_shared<StateFile>(state);
    saved = file->load();
    emulator.board.waits_for_saving = true;
  }
  if (saved) {
    emulator::BoardOptions& board = emulator.board;
    const MemoryOwner& owner = saved->owner;
    if (!options_.board_is_given) board.board = owner.board;
    if (!options_.firmware_is_given) board.firmware = owner.firmware;
    if (owner.board != board.board || owner.firmware != board.firmware) {
      throw std::runtime_error(fmt::format("{} is the state of {}, not of {}", state,
                                           model(owner.board, owner.firmware),
                                           model(board.board, board.firmware)));
    }
    if (const std::string problem = problem_of(board.firmware); !problem.empty()) {
      throw std::runtime_error(state + ": " + problem);
    }
    board.device_id = owner.device_id;
    board.mcu_id = owner.mcu_id;
  } else if (options_.firmware_is_given && !options_.board_is_given) {
    emulator.board.board = usual_board(emulator.board.firmware);
  }
  Served& served = boards_.emplace_back();
  served.board =
      std::make_unique<LiveBoard>(context_.get_executor(), emulator,
                                  saved ? std::move(saved->memory) : new_memory(emulator.board));
  if (file) {
    served.state = std::make_unique<StateKeeper>(
        context_.get_executor(), savers(), *served.board,
        [file](const SavedMemory& memory) { return file->save(memory); },
        numbered(logs_.warning, number));
    served.board->on_memory_changed = [&keeper = *served.state] { keeper.changed(); };
  }
  if (logs_.describe_frame) {
    const auto frames = std::make_shared<FrameLog>(logs_.describe_frame);
    served.board->emulator().board().on_traffic =
        [frames](const emulator::Board::Traffic& traffic) { frames->add(traffic); };
    served.board->after_traffic = [frames, log = numbered(logs_.event, number)] {
      for (const std::string& line : frames->take()) log(line);
    };
  }
  open_endpoints(served, number);
}

void Service::open_endpoints(Served& served, unsigned number) {
  const asio::any_io_executor executor = context_.get_executor();
  const hosts::EndpointLogs logs{numbered(logs_.event, number), numbered(logs_.warning, number)};
  const auto add = [&](std::unique_ptr<hosts::Endpoint> endpoint) {
    logs_.endpoint(fmt::format("emulated gimbal {}: {}", number + 1, endpoint->address()));
    served.endpoints.push_back(std::move(endpoint));
  };
  const auto at = [&](hosts::ListenAddress address) {
    if (address.port != 0) address.port = static_cast<std::uint16_t>(address.port + number);
    return address;
  };
  const emulator::EmulatorOptions& emulator = options_.emulator;
  const bool has_rate = emulator.rate_from_parameters || emulator.line.board.baud_rate != 0;
  if (options_.terminal) {
    const std::string link = numbered_name(options_.link, number);
    add(hosts::open_terminal(executor, *served.board, link, has_rate, logs));
  }
  // TCP and UDP share the remaining places, so that neither can take them all.
  const std::size_t others = (options_.terminal ? 1U : 0U) + (options_.stdio ? 1U : 0U);
  const std::size_t places = emulator::Board::max_ports - others;
  const std::size_t for_udp = options_.tcp ? places / 2 : places;
  const std::size_t for_tcp = options_.udp ? places - for_udp : places;
  if (options_.tcp)
    add(hosts::listen_tcp(executor, *served.board, at(*options_.tcp), for_tcp, logs));
  if (options_.udp)
    add(hosts::listen_udp(executor, *served.board, at(*options_.udp), for_udp, logs));
  if (options_.stdio) add(hosts::use_stdio(executor, *served.board, on_end_));
}

asio::thread_pool& Service::savers() {
  // They mostly wait for disks.
  constexpr unsigned most = 8;
  if (!savers_) savers_.emplace(std::min(options_.count, most));
  return *savers_;
}

hosts::Log Service::numbered(const hosts::Log& log, unsigned number) const {
  if (options_.count == 1) return log;
  return [log, number](const std::string& text) { log(fmt::format("{}: {}", number + 1, text)); };
}

std::string Service::numbered_name(const std::string& name, unsigned number) const {
  return name.empty() || options_.count == 1 ? name : fmt::format("{}-{}", name, number + 1);
}

bool Service::finish() {
  bool result = true;
  for (const Served& served : boards_) {
    if (served.state && !served.state->finish()) result = false;
  }
  return result;
}

}  // namespace sbgc::serving
