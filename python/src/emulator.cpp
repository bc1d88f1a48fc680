#include "emulator.hpp"

#include <string>

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
