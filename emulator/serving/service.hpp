/// Emulated boards and their endpoints.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/emulator/board.hpp>

#include "hosts/endpoint.hpp"
#include "serving/live_board.hpp"
#include "serving/state_keeper.hpp"

namespace sbgc::serving {

/// Describes a frame in one line. The user of this library provides it, because command names are
/// not available here.
using DescribeFrame = std::function<std::string(const emulator::Board::Traffic&)>;

struct ServiceOptions {
  emulator::EmulatorOptions
      emulator{};  ///< of the first board; the others have different seeds and ids
  // True if set explicitly in `emulator`: a saved state of a different board is then rejected.
  bool board_is_given = false;
  bool firmware_is_given = false;
  unsigned count = 1;  ///< number of boards
  bool terminal = false;
  std::string link{};  ///< link to the terminal, "" for none; with several boards: link-1 ...
  std::optional<hosts::ListenAddress>
      tcp{};  ///< with several boards: this port and the following ones
  std::optional<hosts::ListenAddress> udp{};
  bool stdio = false;   ///< precondition: count is 1
  std::string state{};  ///< file, "" for none; with several boards: state-1 ...
};

struct ServiceLogs {
  hosts::Log endpoint{};  ///< for example "emulated gimbal 1: /dev/pts/7"
  hosts::Log event{};     ///< hosts connect and leave; also each frame, if `describe_frame` is set
  hosts::Log warning{};
  DescribeFrame describe_frame{};
};

/// Opens all boards and endpoints; throws std::runtime_error if one cannot be opened. Serves while
/// the context runs, and must not be destroyed meanwhile.
class Service {
 public:
  /// `on_end` is called when the standard input has ended.
  Service(asio::io_context& context, const ServiceOptions& options, ServiceLogs logs,
          std::function<void(std::error_code)> on_end = {});
  Service(const Service&) = delete;
  Service& operator=(const Service&) = delete;
  ~Service() = default;

  /// Saves the states. Returns false if one cannot be saved.
  bool finish();

  LiveBoard& board(std::size_t number) { return *boards_[number].board; }
  const std::vector<std::unique_ptr<hosts::Endpoint>>& endpoints(std::size_t number) const {
    return boards_[number].endpoints;
  }

 private:
  struct Served {
    std::unique_ptr<LiveBoard> board{};
    std::unique_ptr<StateKeeper> state{};
    std::vector<std::unique_ptr<hosts::Endpoint>> endpoints{};  // destroyed before the board
  };

  void add(unsigned number);
  void open_endpoints(Served& served, unsigned number);
  /// Prefixes each line with the number of the board if there are several boards.
  hosts::Log numbered(const hosts::Log& log, unsigned number) const;
  std::string numbered_name(const std::string& name, unsigned number) const;

  /// Created on first use.
  asio::thread_pool& savers();

  asio::io_context& context_;
  ServiceOptions options_;
  ServiceLogs logs_;
  std::function<void(std::error_code)> on_end_;
  std::optional<asio::thread_pool> savers_{};  // joined after the boards are destroyed
  std::vector<Served> boards_{};
};

}  // namespace sbgc::serving
