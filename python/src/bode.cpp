// Files and analysis of frequency responses.

#include <optional>
#include <string>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/stl.h>

#include <sbgc/analysis/frequency_response.hpp>
#include <sbgc/client/bode.hpp>
#include <sbgc/meta/calibration.hpp>

#include "binding.hpp"

namespace sbgc::python {

namespace {

using Samples = std::vector<double>;

void require_same_length(const Samples& input, const Samples& output) {
  if (input.size() != output.size()) throw py::value_error("input and output differ in length");
}

std::string csv_of(const AnyMessage& request, const Samples& input, const Samples& output) {
  const auto* const of = request.get_if<msg::BodeTestStartStopRequest>();
  if (of == nullptr) throw py::type_error("not a BodeTestStartStopRequest");
  require_same_length(input, output);
  return to_csv({*of, input, output, 0});
}

py::tuple recording_from(const std::string& text) {
  const auto recording = parse_bode_csv(text);
  if (!recording) throw py::value_error(recording.error().message);
  return py::make_tuple(any_of(recording->request), recording->input, recording->output,
                        recording->lost);
}

py::tuple response_of(const Samples& input, const Samples& output, double from, double to) {
  require_same_length(input, output);
  const auto response = analysis::frequency_response(input, output, bode_sample_rate, from, to);
  py::list points;
  for (const analysis::ResponsePoint& one : response.points) {
    points.append(py::make_tuple(one.frequency, one.response, one.gain, one.phase, one.coherence,
                                 one.deviation));
  }
  return py::make_tuple(response.segments, points);
}

}  // namespace

void bind_bode(py::module_& module) {
  module.def("bode_csv", &csv_of);
  module.def("parse_bode_csv", &recording_from);
  module.attr("MAX_BODE_CSV") = max_bode_csv;
  module.def("frequency_response", &response_of);
}

}  // namespace sbgc::python
