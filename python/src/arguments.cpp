#include "arguments.hpp"

#include <charconv>

namespace sbgc::python {

namespace {

[[noreturn]] void raise_argument(py::handle value, const char* name, const char* needed) {
  PyErr_Clear();
  throw py::type_error(std::string(name) + ": " + needed + " is needed, not " +
                       py::repr(value).cast<std::string>());
}

template <class T>
[[noreturn]] void raise_beyond(const char* name, const T& lowest, const T& highest,
                               const std::string& value) {
  throw py::value_error(std::string(name) + ": " + lowest + " to " + highest +
                        " are possible, not " + value);
}

}  // namespace

std::string digits_of(double number) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, number).ptr};
}

double number_of(py::handle value, const char* name) {
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) raise_argument(value, name, "a number");
  return number;
}

double number_in(double value, const char* name, double lowest, double highest) {
  if (value >= lowest && value <= highest) return value;
  raise_beyond(name, digits_of(lowest), digits_of(highest), digits_of(value));
}

std::int64_t integer_of(py::handle value, const char* name, std::int64_t lowest,
                        std::int64_t highest) {
  const auto integer = py::reinterpret_steal<py::int_>(PyNumber_Index(value.ptr()));
  if (!integer) raise_argument(value, name, "an integer");
  int is_beyond = 0;
  const std::int64_t number = PyLong_AsLongLongAndOverflow(integer.ptr(), &is_beyond);
  if (is_beyond == 0 && number >= lowest && number <= highest) return number;
  raise_beyond(name, std::to_string(lowest), std::to_string(highest),
               py::repr(integer).cast<std::string>());
}

std::string string_of(py::handle value, const char* name) {
  if (PyUnicode_Check(value.ptr()) == 0) raise_argument(value, name, "a text");
  const auto bytes = py::reinterpret_steal<py::bytes>(
      PyUnicode_AsEncodedString(value.ptr(), "utf-8", "surrogateescape"));
  if (!bytes) throw py::error_already_set();
  return bytes;
}

std::string path_of(py::handle value, const char* name) {
  const auto path = py::reinterpret_steal<py::object>(PyOS_FSPath(value.ptr()));
  if (!path) raise_argument(value, name, "the name of a file");
  return py::isinstance<py::bytes>(path) ? std::string(py::bytes(path)) : string_of(path, name);
}

msg::ControlSpeed speed_of(double value, const char* field) {
  const auto speed = quantity_of<msg::ControlSpeed>(value, field);
  if (speed.raw() == 0 && value != 0) raise_unfit<msg::ControlSpeed>(value, field);
  return speed;
}

bool flag_of(py::handle value, const char* name) {
  const int flag = PyObject_IsTrue(value.ptr());
  const bool is_number = PyBool_Check(value.ptr()) || PyNumber_Check(value.ptr());
  if (flag < 0 || !is_number) raise_argument(value, name, "True or False");
  return flag != 0;
}

std::vector<std::string> texts_of(py::handle value, const char* name) {
  if (PyUnicode_Check(value.ptr()) != 0 || !py::isinstance<py::iterable>(value)) {
    raise_argument(value, name, "a list of texts");
  }
  std::vector<std::string> texts;
  for (const py::handle one : value) texts.push_back(string_of(one, name));
  return texts;
}

std::vector<std::uint8_t> memory_of(py::handle value, const char* name) {
  if (PyObject_CheckBuffer(value.ptr()) == 0) raise_argument(value, name, "a bytes-like object");
  return with_bytes(py::reinterpret_borrow<py::buffer>(value),
                    [](Bytes all) { return std::vector<std::uint8_t>(all.begin(), all.end()); });
}

}  // namespace sbgc::python
