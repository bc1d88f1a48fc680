// Messages of any type, with fields accessed by path.

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/stl.h>

#include <sbgc/json/hex.hpp>
#include <sbgc/text.hpp>
#include <sbgc/validate.hpp>

#include "arguments.hpp"

namespace sbgc::python {

namespace {

/// True if this is the path "axes.roll.angle", or the elements of it that `at` has.
bool is_at(const FieldPath* at, std::string_view path) {
  if (at == nullptr) return path.empty();
  if (*at->name != '\0') {
    const std::string_view name = at->name;
    if (!path.ends_with(name)) return false;
    path.remove_suffix(name.size());
    if (at->parent == nullptr) return path.empty();
    if (!path.ends_with('.')) return false;
    path.remove_suffix(1);
  } else {
    const std::size_t open = path.rfind('[');
    if (open == std::string_view::npos || !path.ends_with(']')) return false;
    std::size_t index = 0;
    std::from_chars(path.data() + open + 1, path.data() + path.size(), index);
    if (index != at->index) return false;
    path = path.substr(0, open);
  }
  return is_at(at->parent, path);
}

/// Returns the last step of the path `at` that equals `path`; null if it leads elsewhere.
const FieldPath* step_to(const FieldPath& at, std::string_view path) {
  for (const FieldPath* step = &at; step != nullptr; step = step->parent) {
    if (is_at(step, path)) return step;
  }
  return nullptr;
}

bool is_below(const FieldPath& at, std::string_view path) {
  return path.empty() || step_to(at, path) != nullptr;
}

std::string number_text(double number) {
  char buffer[32];
  char* const end = std::to_chars(buffer, buffer + sizeof buffer, number).ptr;
  return {buffer, end};
}

bool is_a_set(const Leaf& leaf) {
  return leaf.packed != nullptr || (leaf.names != nullptr && leaf.names->is_flags);
}

/// Returns the value of a leaf: a float if it has a unit, unless `raw`.
py::object value_of(const Leaf& leaf, bool raw) {
  const UnitInfo* const unit = raw ? nullptr : leaf.unit;
  switch (leaf.kind) {
    case LeafKind::integer:
    case LeafKind::counter: {
      if (unit != nullptr) return py::float_(unit->real(leaf.number()));
      const auto bits = static_cast<std::uint64_t>(leaf.integer);
      if (leaf.is_u64) return py::int_(bits);
      if (is_a_set(leaf)) return py::int_(detail::low_bits(bits, leaf.size));
      return py::int_(leaf.integer);
    }
    case LeafKind::real: return py::float_(unit != nullptr ? unit->real(leaf.real) : leaf.real);
    case LeafKind::bytes: return to_bytes(leaf.bytes);
    case LeafKind::text: break;
  }
  return to_text(leaf.text);
}

/// Returns the value at a path, optionally raw: get(path, raw=False); None if there is none. A
/// method without pybind11, whose dispatch takes longer than the rest.
PyObject* get(PyObject* self, PyObject* const* arguments, Py_ssize_t count) {
  // NOLINTNEXTLINE(*-reinterpret-cast): Python has checked the type
  const auto place = reinterpret_cast<py::detail::instance*>(self)->get_value_and_holder();
  const auto* const message = static_cast<const AnyMessage*>(place.value_ptr());
  if (message == nullptr || count < 1 || count > 2) {
    PyErr_SetString(PyExc_TypeError, "get(path, raw=False)");
    return nullptr;
  }
  Py_ssize_t size = 0;
  const char* const path = PyUnicode_AsUTF8AndSize(arguments[0], &size);
  if (path == nullptr) return nullptr;
  const int raw = count == 2 ? PyObject_IsTrue(arguments[1]) : 0;
  if (raw < 0) return nullptr;
  try {
    py::object result = py::none();
    message->with_leaf({path, static_cast<std::size_t>(size)},
                       [&](const Leaf& leaf) { result = value_of(leaf, raw != 0); });
    return result.release().ptr();
  } catch (py::error_already_set& error) {
    error.restore();
  } catch (const std::exception& error) {
    PyErr_SetString(PyExc_RuntimeError, error.what());
  }
  return nullptr;  // no C++ exception may pass through the interpreter
}

/// Assigns, and raises a FieldError with the reason on failure.
void assign(AnyMessage& message, std::string_view path, std::string_view text, bool validates) {
  const std::string problem = message.assign(path, text, validates);
  if (!problem.empty()) raise("FieldError", problem, path);
}

[[noreturn]] void raise_type(std::string_view path, const py::handle& value, const char* needed) {
  PyErr_Clear();
  throw py::type_error(std::string(path) + ": " + needed + " is needed, not " +
                       py::repr(value).cast<std::string>());
}

/// Calls `use` with the leaf at a path, which is added if it is missing.
template <class Use>
void with_leaf(const AnyMessage& message, std::string_view path, const Use& use) {
  if (message.with_leaf(path, use)) return;
  AnyMessage extended = message;
  extended.add(path);
  extended.with_leaf(path, use);
}

std::string announced_text(const Leaf& leaf, const std::string& number) {
  return leaf.announced == NumberType::none ? number : name(leaf.announced) + (':' + number);
}

void set_real(AnyMessage& message, std::string_view path, const py::object& value) {
  // A value of an enum, flags or a packed value has no unit.
  if (PyLong_Check(value.ptr()) && !PyLong_CheckExact(value.ptr())) {
    raise_type(path, value, "a number");
  }
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) raise_type(path, value, "a number");
  std::string text = number_text(number);
  with_leaf(message, path, [&](const Leaf& leaf) {
    // Numbers that are computed may be too small; text must not be.
    const bool has_steps = leaf.kind == LeafKind::integer && leaf.unit != nullptr;
    const bool is_zero = has_steps && std::round(leaf.unit->raw(number)) == 0;
    const auto& special = leaf.field.special;
    if (is_zero && std::ranges::find(special, 0, &Special::value) == special.end()) {
      text = number_text(leaf.unit->real(0));
    }
    text = announced_text(leaf, text);
    // With its unit: a number without one can be a sentinel.
    if (leaf.unit != nullptr && *leaf.unit->name != '\0')
      text += ' ' + std::string(leaf.unit->name);
  });
  assign(message, path, text, true);
}

/// Sets the raw number.
void set_raw(AnyMessage& message, std::string_view path, const py::object& value) {
  if (PyFloat_Check(value.ptr())) {
    assign(message, path, "raw:" + number_text(value.cast<double>()), true);
    return;
  }
  const auto number = py::reinterpret_steal<py::int_>(PyNumber_Index(value.ptr()));
  if (!number) raise_type(path, value, "an integer");
  auto text = py::repr(number).cast<std::string>();
  with_leaf(message, path, [&](const Leaf& leaf) {
    text = announced_text(leaf, leaf.unit != nullptr ? "raw:" + text : text);
  });
  assign(message, path, text, true);
}

void set_bytes(AnyMessage& message, std::string_view path, const py::object& value) {
  if (PyObject_CheckBuffer(value.ptr()) == 0) raise_type(path, value, "a bytes-like object");
  with_bytes(py::reinterpret_borrow<py::buffer>(value),
             [&](Bytes bytes) { assign(message, path, detail::to_hex(bytes), true); });
}

void set_text(AnyMessage& message, std::string_view path, const py::object& value) {
  const auto bytes = py::reinterpret_steal<py::bytes>(
      PyUnicode_AsEncodedString(value.ptr(), "utf-8", "surrogateescape"));
  if (!bytes) raise_type(path, value, "a text");
  assign(message, path, std::string(bytes), true);
}

/// Sets a value of any kind: human-readable text, or a number in the unit of the field.
void put(AnyMessage& message, std::string_view path, const py::object& value) {
  bool is_number = false;
  bool has_unit = false;
  bool is_text = false;
  with_leaf(message, path, [&](const Leaf& leaf) {
    is_number = leaf.kind == LeafKind::integer || leaf.kind == LeafKind::real;
    has_unit = leaf.unit != nullptr || leaf.kind == LeafKind::real;
    is_text = leaf.kind == LeafKind::text;
  });
  if (is_text || PyUnicode_Check(value.ptr())) {
    if (is_text) return set_text(message, path, value);
    return assign(message, path, value.cast<std::string>(), true);
  }
  if (!is_number) return set_bytes(message, path, value);
  return has_unit ? set_real(message, path, value) : set_raw(message, path, value);
}

/// Returns the paths of the values that end with a name: "pitch.p" finds "axes.pitch.p".
std::vector<std::string> find(const AnyMessage& message, const std::string& name) {
  std::vector<std::string> found;
  message.for_each_leaf([&](const Leaf& leaf) {
    std::string path = sbgc::to_string(leaf.path);
    if (path == name || path.ends_with('.' + name)) found.push_back(std::move(path));
  });
  return found;
}

/// Returns the paths of all values that people set.
std::vector<std::string> paths(const AnyMessage& message) {
  std::vector<std::string> found;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind == LeafKind::counter || leaf.field.reserved) return;
    found.push_back(sbgc::to_string(leaf.path));
  });
  return found;
}

/// Returns the value at a path in readable form: the names of enum values and flags.
py::object said(const AnyMessage& message, std::string_view path) {
  py::object result = py::none();
  message.with_leaf(path, [&](const Leaf& leaf) {
    const bool is_named =
        leaf.names != nullptr &&
        (leaf.names->is_flags || std::ranges::any_of(leaf.names->values, [&](const ValueInfo& one) {
           return one.value == leaf.integer;
         }));
    result = is_named ? py::object(py::str(value_text(leaf))) : value_of(leaf, false);
  });
  return result;
}

using Values = std::vector<std::pair<std::string, AnyValue>>;

AnyValue raw_value(const Leaf& leaf) {
  if (leaf.announced != NumberType::none) {
    const auto bits = leaf.kind == LeafKind::real
                          ? std::bit_cast<std::uint32_t>(static_cast<float>(leaf.real))
                          : static_cast<std::uint32_t>(detail::low_bits(
                                static_cast<std::uint64_t>(leaf.integer), leaf.size));
    return Number{leaf.announced, bits};
  }
  switch (leaf.kind) {
    case LeafKind::real: return leaf.real;
    case LeafKind::bytes: return std::vector<std::uint8_t>(leaf.bytes.begin(), leaf.bytes.end());
    case LeafKind::text: return std::string(leaf.text);
    default: return leaf.integer;
  }
}

/// Returns the values below a path, by their relative paths.
Values values_below(const AnyMessage& message, std::string_view path) {
  Values result;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind == LeafKind::counter || !is_below(leaf.path, path)) return;
    result.emplace_back(sbgc::to_string(leaf.path).substr(path.size()), raw_value(leaf));
  });
  return result;
}

bool is_equal(const AnyMessage& a, std::string_view path, const AnyMessage& b,
              std::string_view other) {
  return values_below(a, path) == values_below(b, other);
}

/// Removes everything optional below a path.
void clear(AnyMessage& message, std::string_view path) {
  for (const auto& [rest, value] : values_below(message, path)) {
    for (std::size_t end = 1; end <= rest.size(); ++end) {
      const bool is_step = end == rest.size() || rest[end] == '.' || rest[end] == '[';
      if (is_step) message.remove(std::string(path) + rest.substr(0, end));
    }
  }
}

/// Copies the values below a path of another message. A value keeps its physical value; its unit
/// may depend on a flag.
void copy_values(AnyMessage& to, std::string_view path, const AnyMessage& from,
                 std::string_view other) {
  clear(to, path);
  to.add(path);
  for (const auto& [rest, value] : values_below(from, other)) {
    const std::string place = std::string(path) + rest;
    if (!to.set(place, value)) {
      raise("FieldError", place + ": it cannot have this value", place);
    }
    double real = 0;
    const UnitInfo* unit = nullptr;
    from.with_leaf(std::string(other) + rest, [&](const Leaf& leaf) {
      unit = leaf.unit;
      if (unit != nullptr) real = unit->real(leaf.number());
    });
    if (unit == nullptr) continue;
    const UnitInfo* actual = unit;
    to.with_leaf(place, [&](const Leaf& leaf) { actual = leaf.unit; });
    if (actual != unit) assign(to, place, number_text(real) + ' ' + unit->name, false);
  }
}

/// Returns the text of the values below a path, like to_string(): "{angle = -30 deg, …}".
std::string text_below(const AnyMessage& message, std::string_view path) {
  std::string text;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind == LeafKind::counter || is_unused(leaf) || !is_below(leaf.path, path)) return;
    std::string name = sbgc::to_string(leaf.path).substr(path.size());
    if (name.starts_with('.')) name.erase(0, 1);
    text += (text.empty() ? "" : ", ") + name + " = " + value_text(leaf);
  });
  return '{' + text + '}';
}

py::list violations(const AnyMessage& message, Integer<std::uint16_t, "firmware"> firmware,
                    Integer<std::uint8_t, "board"> board) {
  const Availability versions{*firmware == 0 ? newest.firmware : *firmware,
                              *board == 0 ? newest.board : *board};
  py::list result;
  message.validate(versions, [&](const Violation& violation) {
    const double value = violation.value;
    result.append(py::make_tuple(sbgc::to_string(violation.path), sbgc::to_string(violation), value,
                                 violation.limit, name(violation.rule)));
  });
  return result;
}

py::bytes body_of(const AnyMessage& message) {
  std::array<std::uint8_t, max_body_size> bytes{};
  const WriteResult written = message.encode(bytes);
  if (!written) {
    raise_status("EncodeError", message.type().info->name, written.status);
  }
  return to_bytes(Bytes(bytes).first(written.size));
}

py::bytes frame_of(const AnyMessage& message, Integer<unsigned, "framing"> framing) {
  std::array<std::uint8_t, max_frame_size> bytes{};
  const WriteResult written = message.encode_frame(framing_at(framing), bytes);
  if (!written) {
    raise_status("EncodeError", message.type().info->name, written.status);
  }
  return to_bytes(Bytes(bytes).first(written.size));
}

void decode(AnyMessage& message, const py::buffer& body, const Contexts* contexts) {
  const Status status = with_bytes(body, [&](Bytes bytes) {
    return message.decode(bytes, contexts == nullptr ? Contexts{} : *contexts);
  });
  if (!status) raise_status("DecodeError", message.type().info->name, status);
}

AnyMessage make_message(std::string_view name) {
  const MessageType* const type = find_message(name);
  if (type == nullptr) throw py::value_error("there is no message " + std::string(name));
  return type->make();
}

void read_json(AnyMessage& message, const Text<"text">& text) {
  const JsonResult read = message.from_json(*text);
  if (!read) raise("FieldError", sbgc::to_string(*read.problem), read.problem->field);
}

// Packed values

void collect_packed(const std::vector<FieldType>& fields,
                    std::map<std::string_view, const FieldType*>& types) {
  for (const FieldType& field : fields) {
    if (field.packed != nullptr) types.emplace(field.packed->name, &field);
    collect_packed(field.members, types);
  }
}

/// Returns the type of a field with this packed value.
const FieldType& packed_type(std::string_view name) {
  static const auto types = [] {
    std::map<std::string_view, const FieldType*> result;
    for (const MessageType* const type : message_types()) collect_packed(type->fields(), result);
    return result;
  }();
  const auto found = types.find(name);
  if (found == types.end()) throw py::value_error("no packed value " + std::string(name));
  return *found->second;
}

py::object part_of(std::string_view packed, std::uint64_t raw, std::string_view part) {
  for (const PartInfo& one : packed_type(packed).packed->parts) {
    if (one.name != part) continue;
    const std::int64_t value = detail::part_value(one, raw);
    if (one.unit != nullptr) return py::float_(one.unit->real(static_cast<double>(value)));
    return py::int_(value);
  }
  throw py::value_error(std::string(packed) + " has no part " + std::string(part));
}

std::uint64_t with_part(std::string_view packed, std::uint64_t raw, std::string_view part,
                        const std::string& value) {
  const FieldType& type = packed_type(packed);
  const ParsedValue parsed = parse_value(type, nullptr, std::string(part) + ':' + value, raw);
  if (!parsed) raise("FieldError", std::string(packed) + ": " + parsed.problem, part);
  return detail::low_bits(static_cast<std::uint64_t>(std::get<std::int64_t>(parsed.value)),
                          type.size);
}

std::string packed_text(std::string_view packed, std::uint64_t raw) {
  return detail::packed_text(*packed_type(packed).packed, raw);
}

py::list message_names() {
  py::list result;
  for (const MessageType* const type : message_types()) result.append(type->info->name);
  return result;
}

}  // namespace

void bind_messages(py::module_& module) {
  py::class_<AnyMessage> message_class(module, "AnyMessage");
  static PyMethodDef get_method{"get", nullptr, METH_FASTCALL, nullptr};  // Python keeps it
  // NOLINTNEXTLINE(*-reinterpret-cast): as Python has it
  get_method.ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void*>(&get));
  message_class.attr("get") = py::reinterpret_steal<py::object>(
      PyDescr_NewMethod(reinterpret_cast<PyTypeObject*>(message_class.ptr()), &get_method));
  message_class.def(py::init(&make_message))
      .def_property_readonly("name", [](const AnyMessage& m) { return m.type().info->name; })
      .def_property_readonly("id", [](const AnyMessage& m) { return m.type().info->id; })
      .def("copy", [](const AnyMessage& m) { return m; })
      .def("take", [](AnyMessage& m, const AnyMessage& other) { m = other; })
      .def("has", &AnyMessage::has)
      .def("count", &AnyMessage::count)
      .def("add", &AnyMessage::add)
      .def("remove", &AnyMessage::remove)
      .def("assign", [](AnyMessage& message, const Text<"path">& path, const Text<"text">& text,
                        bool validates) { assign(message, *path, *text, validates); })
      .def("set_real", &set_real)
      .def("set_raw", &set_raw)
      .def("set_bytes", &set_bytes)
      .def("set_text", &set_text)
      .def("put", &put)
      .def("find", &find)
      .def("paths", &paths)
      .def("said", &said)
      .def("copy_values", &copy_values)
      .def("is_equal", &is_equal)
      .def("text", &text_below)
      .def("violations", &violations)
      .def("decode", &decode, py::arg("body"), py::arg("contexts").none(true))
      .def("body", &body_of)
      .def("frame", &frame_of)
      .def(
          "to_json",
          [](const AnyMessage& message, bool secrets) {
            return message.to_json(secrets ? Secrets::shown : Secrets::hidden);
          },
          py::arg("secrets") = false)
      .def("read_json", &read_json)
      .def("__eq__", [](const AnyMessage& a, const AnyMessage& b) { return a == b; });
  module.def("message_names", &message_names);
  module.def("part_of", &part_of);
  module.def("with_part", &with_part);
  module.def("packed_text", &packed_text);
}

}  // namespace sbgc::python
