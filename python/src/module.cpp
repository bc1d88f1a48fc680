// The extension of the Python package: `sbgc._core`.

#include "binding.hpp"

// NOLINTNEXTLINE: a macro of pybind11
PYBIND11_MODULE(_core, module) {
  sbgc::python::bind_messages(module);
  sbgc::python::bind_codec(module);
  sbgc::python::bind_captures(module);
  sbgc::python::bind_bode(module);
  sbgc::python::bind_emulator(module);
  sbgc::python::bind_client(module);
}
