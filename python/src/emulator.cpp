#include "emulator.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <sbgc/meta/system.hpp>
#include <sbgc/text.hpp>

#include "serving/arguments.hpp"

namespace sbgc::python {

namespace {

/// Returns the firmware with this text, such as "2.74".
msg::FirmwareVersion firmware_named(const std::string& text) {
  for (std::uint32_t raw = 0; raw <= 0xFFFF; ++raw) {
    const msg::FirmwareVersion version(static_cast<std::uint16_t>(raw));
    if (to_string(version) == text) return version;
  }
  throw py::value_error("'" + text + "' is no version of firmware, such as 2.74");
}

double share_of(double value) {
  if (value >= 0 && value <= 1) return value;
  throw py::value_error("a share is 0 to 1");
}

Duration time_of(double seconds) {
  if (seconds >= 0 && seconds <= 1e9) return duration_of(seconds);
  throw py::value_error("a time is 0 to 1000000000 seconds");
}

/// The faults of a line, as those of `sbgc emulate`.
emulator::Faults faults_of(double bit_errors, double lost, double duplicated, double delayed,
                           double delay, double text_every,
                           const std::vector<std::pair<double, double>>& silences) {
  emulator::Faults faults;
  faults.bit_errors = share_of(bit_errors);
  faults.lost = share_of(lost);
  faults.duplicated = share_of(duplicated);
  faults.delayed = share_of(delayed);
  faults.delay = time_of(delay);
  faults.text_every = time_of(text_every);
  for (const auto& [from, length] : silences) {
    faults.silences.push_back({time_of(from), time_of(length)});
  }
  return faults;
}

std::shared_ptr<Emulation> make_board(const std::string& firmware, const std::string& board,
                                      const std::string& motion, std::uint32_t seed, double noise,
                                      const emulator::Faults& faults, std::uint32_t baud_rate,
                                      std::size_t input_buffer, bool is_strict,
                                      std::optional<double> restart_at, bool virtual_time) {
  emulator::EmulatorOptions options;
  if (!firmware.empty()) {
    options.board.firmware = firmware_named(firmware);
    if (const std::string problem = serving::problem_of(options.board.firmware); !problem.empty()) {
      throw py::value_error(problem);
    }
    options.board.board = serving::usual_board(options.board.firmware);
  }
  try {
    if (!board.empty()) options.board.board = serving::parse_board(board);
    options.board.gimbal.frame = serving::parse_motion(motion);
  } catch (const std::invalid_argument& error) {
    throw py::value_error(error.what());
  }
  options.board.gimbal.seed = seed;
  options.board.gimbal.noise = noise;
  options.board.input_buffer = input_buffer;
  options.board.is_strict = is_strict;
  options.line.seed = seed;
  options.line.board.baud_rate = baud_rate;
  options.line.faults = faults;
  if (restart_at) options.restart_at = time_of(*restart_at);
  return std::make_shared<Emulation>(options, virtual_time);
}

py::tuple to_tuple(const Axes<double>& axes) {
  return py::make_tuple(axes.roll, axes.pitch, axes.yaw);
}

}  // namespace

void bind_emulator(py::module_& module) {
  py::class_<emulator::Faults>(module, "Faults").def(py::init(&faults_of));
  py::class_<Emulation, std::shared_ptr<Emulation>>(module, "Emulation")
      .def(py::init(&make_board))
      .def_property_readonly("has_virtual_time",
                             [](Emulation& board) { return board.time() != nullptr; })
      .def("now", &Emulation::now)
      .def("pass_time",
           [](Emulation& board, double seconds) {
             return released([&] {
               board.pass(seconds);
               return true;
             });
           })
      .def("angles", [](Emulation& board) { return to_tuple(board.sample().angles); })
      .def("speeds", [](Emulation& board) { return to_tuple(board.sample().speeds); })
      .def("restart", &Emulation::restart)
      .def("unplug", &Emulation::unplug);
}

}  // namespace sbgc::python
