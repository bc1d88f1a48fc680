// Reads the messages of a capture by kind, in one pass.

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/stl.h>

#include <sbgc/any.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/io/internal/arrival_times.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/parser.hpp>

#include "binding.hpp"
#include "columns.hpp"
#include "kinds.hpp"

namespace sbgc::python {

namespace {

struct FixedValue {
  std::string path;
  const FieldType* type;
  std::size_t offset;  ///< in the body
};

class Layout {
 public:
  /// Returns false if the layout is not fixed.
  bool add(const FieldType& type, const std::string& path) {
    if (type.is_optional) return false;
    switch (type.shape) {
      case FieldShape::group: return add_members(type.members, path + '.');
      case FieldShape::axes:
        for (const char* const axis : type.axes) {
          if (!add(type.members.front(), path + '.' + axis)) return false;
        }
        return true;
      case FieldShape::list:
        for (std::size_t i = 0; type.has_count && i < type.count; ++i) {
          if (!add(type.members.front(), path + '[' + std::to_string(i) + ']')) return false;
        }
        return type.has_count;
      case FieldShape::announced: return false;
      default: break;
    }
    const bool has_fixed_unit = type.info->alternative == nullptr && !type.info->is_variable_value;
    const bool has_fixed_size = type.is_number() || type.has_count;
    if (!has_fixed_size || !has_fixed_unit || type.is_counter) return false;
    values.push_back({path, &type, size_});
    size_ += type.size;
    return true;
  }
  bool add_members(const std::vector<FieldType>& members, const std::string& before) {
    return std::ranges::all_of(members, [&](const FieldType& member) {
      return member.is_tail() || add(member, before + member.name);
    });
  }

  std::vector<FixedValue> values{};

 private:
  std::size_t size_ = 0;
};

/// Returns the values of a message that have the same offsets in every body; nothing if offsets or
/// units depend on other values, or on earlier messages.
std::optional<std::vector<FixedValue>> fixed_layout(const MessageType& type) {
  Layout layout;
  if (!layout.add_members(type.fields(), "")) return std::nullopt;
  return std::move(layout.values);
}

/// True if the message type of such a frame depends on the request.
bool is_asked(bool from_board, const Frame& frame) {
  bool result = false;
  if (from_board) {
    select(Direction::from_board, frame.id, frame.body.size(),
           [&]<class M>(Type<M>) { result = sbgc::detail::IsAsked<M>; });
  }
  return result;
}

/// All messages of one type.
struct Kind {
  explicit Kind(const MessageType& of)
      : type(&of), layout(fixed_layout(of)), teaches(of.operations->teach != nullptr) {
    if (layout) bodies = std::make_shared<Bodies>(of.info->min_size);
  }

  const MessageType* type;
  std::optional<std::vector<FixedValue>> layout;
  bool teaches;
  std::shared_ptr<Bodies> bodies{};  // with a fixed layout
  Columns columns{};                 // without one
};

/// Reads a capture.
class CaptureReader {
 public:
  void feed(const py::buffer& chunk) {
    with_bytes(chunk, [&](Bytes bytes) { parser_.feed(bytes); });
    take_items();
  }
  void finish() {
    parser_.finish();
    take_items();
    end_session();
  }

  /// The starts of the sessions, in microseconds since 1970.
  std::vector<std::int64_t> sessions{};
  std::vector<std::pair<double, std::string>> notes{};
  std::vector<std::pair<bool, std::string>> damage{};  // first: the file is no capture
  std::uint64_t undecoded = 0;

  /// The counters of one direction.
  py::tuple counters(bool from_board) const {
    const ParserCounters& c = sides_.at(from_board ? 1 : 0).total;
    return py::make_tuple(c.frames, c.skipped_bytes, c.header_errors, c.body_errors, c.incomplete);
  }
  /// Returns the name of each kind, and its bodies or columns.
  py::list kinds() const {
    py::list result;
    for (const auto& kind : kinds_) {
      const py::object content =
          kind->layout ? py::cast(kind->bodies) : py::object(kind->columns.to_python());
      result.append(py::make_tuple(kind->type->info->name, content));
    }
    return result;
  }

 private:
  struct Side {
    ParserOfAll parser{};
    io::detail::ArrivalTimes arrivals{};
    ParserCounters total{};
  };
  /// The type of frames of one id and size.
  struct Form {
    bool is_known = false;  // false again if it depends on each request
    Kind* kind = nullptr;   // null if they do not decode
  };

  void take_items() {
    while (const auto item = parser_.next()) {
      if (const auto* const record = std::get_if<io::CaptureRecord>(&*item)) {
        take(*record);
      } else if (const auto* const session = std::get_if<io::CaptureSession>(&*item)) {
        end_session();
        sessions.push_back(session->start.time_since_epoch().count());
      } else {
        const auto& found = std::get<io::CaptureDamage>(*item);
        damage.emplace_back(found.reason == io::CaptureDamage::Reason::not_a_capture,
                            io::to_string(found));
      }
    }
  }

  /// Seconds since the start of the first session.
  double seconds(io::CaptureTime time) const {
    return static_cast<double>(sessions.back() - sessions.front() + time.count()) / 1e6;
  }

  void take(const io::CaptureRecord& record) {
    if (record.kind == io::CaptureKind::note) {
      notes.emplace_back(seconds(record.time),
                         std::string(record.bytes.begin(), record.bytes.end()));
    }
    const bool from_board = record.kind == io::CaptureKind::from_board;
    if (!from_board && record.kind != io::CaptureKind::to_board) return;
    Side& side = sides_.at(from_board ? 1 : 0);
    side.arrivals.add(record.bytes.size(), record.time);
    side.parser.feed(record.bytes, [&](const Frame& frame) { take(side, from_board, frame); });
    side.arrivals.forget(side.arrivals.size() - side.parser.waiting_bytes());
  }

  void take(Side& side, bool from_board, const Frame& frame) {
    const std::uint64_t end = frame.offset + frame_size(frame.framing, frame.body.size());
    const double time = seconds(side.arrivals.of(end));
    Form& form = forms_.at(from_board ? 1 : 0).at(frame.id).at(frame.body.size());
    // A body with a fixed layout decodes if its size is right.
    if (form.is_known && form.kind != nullptr && form.kind->layout && !form.kind->teaches) {
      return form.kind->bodies->add(time, frame.body);
    }
    if (!form.is_known) form = {!is_asked(from_board, frame), kind_of(from_board, frame)};
    if (form.kind == nullptr || !decode(*form.kind, time, frame.body)) ++undecoded;
  }

  bool decode(Kind& kind, double time, Bytes body) {
    AnyMessage message = kind.type->make();
    if (!message.decode(body, contexts_)) return false;
    message.teach(contexts_);
    if (kind.layout) {
      kind.bodies->add(time, body);
    } else {
      kind.columns.add(time, message);
    }
    return true;
  }

  /// Returns the kind of a frame; null if there is none, or such frames never decode.
  Kind* kind_of(bool from_board, const Frame& frame) {
    const Direction direction = from_board ? Direction::from_board : Direction::to_board;
    const MessageType* const type = find_message(direction, frame.id, frame.body.size(), contexts_);
    if (type == nullptr) return nullptr;
    const auto found = std::ranges::find(kinds_, type, [](const auto& kind) { return kind->type; });
    if (found != kinds_.end()) return usable(**found, frame);
    kinds_.push_back(std::make_unique<Kind>(*type));
    Kind* const kind = usable(*kinds_.back(), frame);
    if (kind == nullptr) kinds_.pop_back();
    return kind;
  }
  static Kind* usable(Kind& kind, const Frame& frame) {
    if (!kind.layout) return &kind;
    AnyMessage message = kind.type->make();
    return message.decode(frame.body) ? &kind : nullptr;
  }

  void end_session() {
    for (std::size_t i = 0; i < sides_.size(); ++i) {
      Side& side = sides_.at(i);
      side.parser.flush([&](const Frame& frame) { take(side, i == 1, frame); });
      side = Side{.total = side.total + side.parser.counters()};
    }
    contexts_ = {};
  }

  io::CaptureParser parser_{};
  std::array<Side, 2> sides_{};  // to the board, from the board
  Contexts contexts_{};
  std::vector<std::unique_ptr<Kind>> kinds_{};
  std::array<std::array<std::array<Form, max_body_size + 1>, 256>, 2> forms_{};
};

/// Returns for each value its path, its type as in simplebgc.json, its size and offset in the body,
/// whether it has a unit, and whether it is reserved.
py::object layout_of(std::string_view name) {
  const MessageType* const type = find_message(name);
  const auto layout = type == nullptr ? std::nullopt : fixed_layout(*type);
  if (!layout) return py::none();
  py::list result;
  for (const FixedValue& value : *layout) {
    const FieldType& field = *value.type;
    const char* const kind = field.shape == FieldShape::bytes  ? "bytes"
                             : field.shape == FieldShape::text ? "text"
                                                               : field.type;
    result.append(py::make_tuple(value.path, kind, field.size, value.offset, field.unit != nullptr,
                                 field.info->reserved));
  }
  return result;
}

/// Fills numpy arrays with the numbers of these paths, or with the times.
void fill_arrays(const Bodies& bodies, std::string_view message,
                 const std::map<std::string, py::buffer, std::less<>>& arrays) {
  static const FieldType seconds{.shape = FieldShape::real, .size = sizeof(double)};
  auto layout = *fixed_layout(*find_message(message));
  for (FixedValue& value : layout) value.offset += Bodies::head_size;
  layout.push_back({"time", &seconds, 0});
  std::vector<NumberColumn> columns;
  for (const FixedValue& value : layout) {
    const auto found = arrays.find(value.path);
    if (found == arrays.end()) continue;
    const py::buffer_info array = found->second.request(true);
    const std::size_t size = bodies.rows() * number_size(*value.type);
    if (static_cast<std::size_t>(array.size * array.itemsize) != size) {
      throw py::value_error(value.path + ": the array has another size");
    }
    columns.push_back({value.type, value.offset, static_cast<std::uint8_t*>(array.ptr)});
  }
  with_bytes(bodies.bytes(), [&](Bytes bytes) {
    fill({bytes.data(), bodies.rows(), bodies.stride()}, columns);
  });
}

}  // namespace

void bind_captures(py::module_& module) {
  py::class_<Bodies, std::shared_ptr<Bodies>>(module, "Bodies")
      .def_property_readonly("bytes", &Bodies::bytes)
      .def_property_readonly("stride", &Bodies::stride)
      .def("fill", &fill_arrays);
  py::class_<CaptureReader>(module, "CaptureReader")
      .def(py::init<>())
      .def("feed", &CaptureReader::feed)
      .def("finish", &CaptureReader::finish)
      .def("kinds", &CaptureReader::kinds)
      .def("counters", &CaptureReader::counters)
      .def_readonly("sessions", &CaptureReader::sessions)
      .def_readonly("notes", &CaptureReader::notes)
      .def_readonly("damage", &CaptureReader::damage)
      .def_readonly("undecoded", &CaptureReader::undecoded);
  module.def("layout_of", &layout_of);
}

}  // namespace sbgc::python
