#include "emulator.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <sbgc/meta/system.hpp>
#include <sbgc/text.hpp>

#include "arguments.hpp"
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

Duration time_of(double seconds, const char* name) {
  return duration_of(number_in(seconds, name, 0, 1e9));
}

template <Name name>
double share_of(const Float<name>& value) {
  return number_in(value, name.characters, 0, 1);
}

/// The faults of a line, as those of `sbgc emulate`.
emulator::Faults faults_of(Float<"bit_errors"> bit_errors, Float<"lost"> lost,
                           Float<"duplicated"> duplicated, Float<"delayed"> delayed,
                           Float<"delay"> delay, Float<"text_every"> text_every,
                           const py::list& silences) {
  emulator::Faults faults;
  faults.bit_errors = share_of(bit_errors);
  faults.lost = share_of(lost);
  faults.duplicated = share_of(duplicated);
  faults.delayed = share_of(delayed);
  faults.delay = time_of(delay, "delay");
  faults.text_every = time_of(text_every, "text_every");
  for (const py::handle one : silences) {
    if (!py::isinstance<py::tuple>(one) || py::len(one) != 2) {
      throw py::type_error("silences: pairs of numbers are needed, not " +
                           py::repr(one).cast<std::string>());
    }
    const auto pair = py::reinterpret_borrow<py::tuple>(one);
    const auto time = [&](std::size_t at) {
      return time_of(number_of(pair[at], "silences"), "silences");
    };
    faults.silences.push_back({time(0), time(1)});
  }
  return faults;
}

std::shared_ptr<Emulation> make_board(
    const Text<"firmware">& firmware, const Text<"board">& board, const Path<"motion">& motion,
    Integer<std::uint32_t, "seed"> seed, Float<"noise"> noise, const emulator::Faults& faults,
    Integer<std::uint32_t, "baud_rate"> baud_rate,
    Integer<std::uint32_t, "input_buffer"> input_buffer, Flag<"strict"> is_strict,
    OptionalFloat<"restart_at"> restart_at, Flag<"virtual_time"> virtual_time) {
  emulator::EmulatorOptions options;
  if (!firmware.value.empty()) {
    options.board.firmware = firmware_named(firmware);
    if (const std::string problem = serving::problem_of(options.board.firmware); !problem.empty()) {
      throw py::value_error(problem);
    }
    options.board.board = serving::usual_board(options.board.firmware);
  }
  try {
    if (!board.value.empty()) options.board.board = serving::parse_board(board);
    options.board.gimbal.frame = serving::parse_motion(motion);
  } catch (const std::invalid_argument& error) {
    throw py::value_error(error.what());
  }
  options.board.gimbal.seed = seed;
  options.board.gimbal.noise = number_in(noise, "noise", 0, 1000);
  options.board.input_buffer = input_buffer;
  options.board.is_strict = is_strict;
  options.line.seed = seed;
  options.line.board.baud_rate = baud_rate;
  options.line.faults = faults;
  if (*restart_at) options.restart_at = time_of(**restart_at, "restart_at");
  return Emulation::make(options, virtual_time);
}

py::tuple to_tuple(const Axes<double>& axes) {
  return py::make_tuple(axes.roll, axes.pitch, axes.yaw);
}

/// Calls `use(board)` while other threads of Python run.
template <class Use>
auto with_board(Emulation& board, const Use& use) {
  board.require_this_process();
  return released([&] { return use(board); });
}

}  // namespace

void bind_emulator(py::module_& module) {
  py::class_<emulator::Faults>(module, "Faults").def(py::init(&faults_of));
  using Board = Emulation;
  py::class_<Board, std::shared_ptr<Board>>(module, "Emulation")
      .def(py::init(&make_board))
      .def_property_readonly("has_virtual_time", &Board::has_virtual_time)
      .def("now",
           [](Board& board) { return with_board(board, [](Board& one) { return one.now(); }); })
      .def("pass_time",
           [](Board& board, double seconds) {
             return with_board(board, [&](Board& one) { return one.pass(seconds), true; });
           })
      .def("sample",
           [](Board& board) {
             const auto sample = with_board(board, [](Board& one) { return one.sample(); });
             return py::make_tuple(to_tuple(sample.angles), to_tuple(sample.speeds));
           })
      .def("restart",
           [](Board& board) { with_board(board, [](Board& one) { return one.restart(), true; }); })
      .def("unplug",
           [](Board& board) { with_board(board, [](Board& one) { return one.unplug(), true; }); });
}

}  // namespace sbgc::python
