/// Shared code of the extension.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#ifdef __linux__
#include <cxxabi.h>
#include <unistd.h>
#endif

#include <pybind11/pybind11.h>

#include <sbgc/any.hpp>
#include <sbgc/text/status.hpp>

namespace sbgc::python {

namespace py = pybind11;

// Each adds its part to the module.
void bind_messages(py::module_& module);
void bind_codec(py::module_& module);
void bind_captures(py::module_& module);
void bind_bode(py::module_& module);
void bind_client(py::module_& module);
void bind_emulator(py::module_& module);

class Link;
using LinkClass = py::class_<Link, std::shared_ptr<Link>>;
void bind_streams(py::module_& module, LinkClass& link);
void bind_tasks(py::module_& module, LinkClass& link);

using Bytes = std::span<const std::uint8_t>;

/// Calls `use` with the bytes of an object that supports the buffer protocol.
template <class Use>
decltype(auto) with_bytes(const py::buffer& object, const Use& use) {
  Py_buffer view;
  if (PyObject_GetBuffer(object.ptr(), &view, PyBUF_SIMPLE) != 0) throw py::error_already_set();
  const std::unique_ptr<Py_buffer, void (*)(Py_buffer*)> release(&view, PyBuffer_Release);
  return use(Bytes(static_cast<const std::uint8_t*>(view.buf), static_cast<std::size_t>(view.len)));
}

/// Waits for the interpreter. If the interpreter is finalized meanwhile, it would unwind the stack
/// of this thread, and destructors would release objects without its lock: instead, the thread
/// waits for the end of the process.
inline void wait_for_interpreter(PyThreadState* thread) {
#ifdef __linux__
  try {
    PyEval_RestoreThread(thread);
  } catch (abi::__forced_unwind&) {
    while (true) pause();
  }
#else
  PyEval_RestoreThread(thread);
#endif
}

/// Calls `use` while other threads of Python run.
template <class Use>
auto released(const Use& use) {
  PyThreadState* const thread = PyEval_SaveThread();
  auto result = use();
  wait_for_interpreter(thread);
  return result;
}

inline py::bytes to_bytes(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};  // NOLINT(*-reinterpret-cast)
}

/// Preserves bytes that are not UTF-8.
inline py::object to_text(std::string_view text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "surrogateescape"));
}

/// Raises if there is no framing with this number.
inline Framing framing_at(unsigned number) {
  if (number < framings.size()) return framings.at(number);
  throw py::value_error("framing: 0 to " + std::to_string(framings.size() - 1) +
                        " are possible, not " + std::to_string(number));
}

/// Returns a message of known type as an AnyMessage.
template <class M>
AnyMessage any_of(const M& message) {
  AnyMessage result = find_message(Meta<M>::info.name)->make();
  static_cast<M&>(*result.get_if<M>()) = message;
  return result;
}

/// Raises an exception of the package: type(text, *arguments).
template <class... Arguments>
[[noreturn]] void raise(const char* type, const std::string& text, const Arguments&... arguments) {
  const py::object exception = py::module_::import("sbgc.errors").attr(type);
  PyErr_SetObject(exception.ptr(), exception(text, arguments...).ptr());
  throw py::error_already_set();
}

/// Raises a CodecError: "GetAngles: axes.roll: The body ends before this field does".
[[noreturn]] inline void raise_status(const char* type, const std::string& what,
                                      const Status& status) {
  raise(type, what + ": " + to_string(status), name(status.code), status.field, status.offset);
}

}  // namespace sbgc::python
