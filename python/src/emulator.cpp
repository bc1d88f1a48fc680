#include "emulator.hpp"

#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/post.hpp>

#include <sbgc/io/memory.hpp>
#include <sbgc/meta/system.hpp>
#include <sbgc/text.hpp>

#include "hosts/host.hpp"
#include "serving/arguments.hpp"
#include "serving/live_board.hpp"

namespace sbgc::python {

/// The board and its thread, which never runs Python.
class Emulation : public std::enable_shared_from_this<Emulation> {
 public:
  explicit Emulation(const emulator::EmulatorOptions& options)
      : board_(context_.get_executor(), options, {}), thread_([this] { context_.run(); }) {}
  Emulation(const Emulation&) = delete;
  Emulation& operator=(const Emulation&) = delete;
  ~Emulation() {
    context_.stop();
    thread_.join();
    for (const auto& host : hosts_) host->close();
  }

  /// Runs `action()` on the board's thread, and returns its result.
  template <class Action>
  auto on_thread(Action action) {
    std::packaged_task<std::invoke_result_t<Action>()> task(std::move(action));
    auto done = task.get_future();
    asio::post(context_, [task = std::move(task)]() mutable { task(); });
    return done.get();
  }

  TransportFactory line() {
    return [board = shared_from_this()](const asio::any_io_executor& executor) {
      auto pair = io::make_memory_pair(executor, board->context_.get_executor());
      board->on_thread([&] {
        auto host = hosts::Host::connect(board->board_, std::move(pair.second));
        if (host == nullptr) return;  // no port is free: the line stays silent
        host->start();
        board->hosts_.push_back(std::move(host));
      });
      return std::move(pair.first);
    };
  }

  emulator::Sample sample() {
    return on_thread([this] { return board_.emulator().board().gimbal().sample(board_.now()); });
  }
  void restart() {
    on_thread([this] { board_.emulator().restart(board_.now()); });
  }
  void unplug() {
    on_thread([this] {
      for (const auto& host : hosts_) host->close();
      hosts_.clear();
    });
  }

 private:
  asio::io_context context_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_{context_.get_executor()};
  serving::LiveBoard board_;
  std::vector<std::shared_ptr<hosts::Host>> hosts_{};
  std::thread thread_;
};

TransportFactory line_to(const std::shared_ptr<Emulation>& board) { return board->line(); }

namespace {

/// Returns the firmware with this text, such as "2.74".
msg::FirmwareVersion firmware_named(const std::string& text) {
  for (std::uint32_t raw = 0; raw <= 0xFFFF; ++raw) {
    const msg::FirmwareVersion version(static_cast<std::uint16_t>(raw));
    if (to_string(version) == text) return version;
  }
  throw py::value_error("'" + text + "' is no version of firmware, such as 2.74");
}

std::shared_ptr<Emulation> make_board(const std::string& firmware, const std::string& motion,
                                      std::uint32_t seed, double noise, double bit_errors,
                                      double lost, double duplicated, std::uint32_t baud_rate) {
  emulator::EmulatorOptions options;
  if (!firmware.empty()) {
    options.board.firmware = firmware_named(firmware);
    if (const std::string problem = serving::problem_of(options.board.firmware); !problem.empty()) {
      throw py::value_error(problem);
    }
    options.board.board = serving::usual_board(options.board.firmware);
  }
  try {
    options.board.gimbal.frame = serving::parse_motion(motion);
  } catch (const std::invalid_argument& error) {
    throw py::value_error(error.what());
  }
  for (const double share : {bit_errors, lost, duplicated}) {
    if (!(share >= 0 && share <= 1)) throw py::value_error("a share is 0 to 1");
  }
  options.board.gimbal.seed = seed;
  options.board.gimbal.noise = noise;
  options.line.seed = seed;
  options.line.board.baud_rate = baud_rate;
  options.line.faults.bit_errors = bit_errors;
  options.line.faults.lost = lost;
  options.line.faults.duplicated = duplicated;
  return std::make_shared<Emulation>(options);
}

py::tuple to_tuple(const Axes<double>& axes) {
  return py::make_tuple(axes.roll, axes.pitch, axes.yaw);
}

}  // namespace

void bind_emulator(py::module_& module) {
  py::class_<Emulation, std::shared_ptr<Emulation>>(module, "Emulation")
      .def(py::init(&make_board))
      .def("angles", [](Emulation& board) { return to_tuple(board.sample().angles); })
      .def("speeds", [](Emulation& board) { return to_tuple(board.sample().speeds); })
      .def("restart", &Emulation::restart)
      .def("unplug", &Emulation::unplug);
}

}  // namespace sbgc::python
