// The extension of the Python package: `sbgc._core`.

#include <charconv>
#include <string>

#include <sbgc/meta/system.hpp>
#include <sbgc/text.hpp>
#include <sbgc/version.hpp>

#include "binding.hpp"

namespace {

/// The text of `sbgc --version`.
std::string about() {
  const sbgc::msg::FirmwareVersion newest(sbgc::newest_firmware);
  char model[17]{};
  std::to_chars(model, model + 16, sbgc::model_fingerprint, 16);
  return std::string("protocol: ") + sbgc::protocol_name + ", revision " + sbgc::protocol_revision +
         " (" + sbgc::protocol_date + ") and firmware up to " + sbgc::to_string(newest) +
         "\nmodel: " + std::string(16 - std::string_view(model).size(), '0') + model;
}

}  // namespace

// NOLINTNEXTLINE: a macro of pybind11
PYBIND11_MODULE(_core, module) {
  sbgc::python::bind_messages(module);
  sbgc::python::bind_codec(module);
  sbgc::python::bind_captures(module);
#ifndef SBGC_PYTHON_WITHOUT_CLIENT
  sbgc::python::bind_bode(module);
  sbgc::python::bind_emulator(module);
  sbgc::python::bind_client(module);
#endif
  module.attr("ABOUT") = about();
}
