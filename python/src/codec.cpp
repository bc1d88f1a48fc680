// Finds frames in streams, and decodes single frames.

#include <optional>

#include <pybind11/stl.h>

#include <sbgc/parser.hpp>
#include <sbgc/surplus.hpp>

#include "arguments.hpp"

namespace sbgc::python {

namespace {

/// A frame that owns its bytes.
struct OwnFrame {
  unsigned id{};
  py::bytes body{};
  std::uint64_t offset{};
  unsigned framing{};
};

unsigned index_of(Framing framing) {
  unsigned index = 0;
  while (framings.at(index) != framing) ++index;
  return index;
}

OwnFrame own(const Frame& frame) {
  return {frame.id, to_bytes(frame.body), frame.offset, index_of(frame.framing)};
}

AnyMessage decode_body(std::uint8_t id, Bytes body, bool from_board, const Contexts* contexts) {
  const Direction direction = from_board ? Direction::from_board : Direction::to_board;
  const Contexts& known = contexts == nullptr ? detail::nothing_known : *contexts;
  const MessageType* const type = find_message(direction, id, body.size(), known);
  if (type == nullptr) {
    const Code code = select(direction, id, body.size(), [](auto) {});
    raise_status("DecodeError", "command " + std::to_string(id), {code});
  }
  AnyMessage message = type->make();
  const Status status = message.decode(body, known);
  if (!status) raise_status("DecodeError", type->info->name, status);
  return message;
}

[[noreturn]] void raise_frame(const std::string& text) {
  raise("DecodeError", text, "no_frame", "", 0);
}

AnyMessage decode_frame(const py::buffer& object, bool from_board, const Contexts* contexts) {
  return with_bytes(object, [&](Bytes bytes) {
    if (bytes.empty()) raise_frame("there are no bytes");
    const Candidate found = AllFrameFormats{}.inspect(bytes.data(), bytes.size());
    switch (found.verdict) {
      case Verdict::frame: break;
      case Verdict::incomplete: raise_frame("the frame is incomplete");
      case Verdict::no_start: raise_frame("this is no start of a frame");
      case Verdict::bad_header: raise_frame("the checksum of the header is wrong, or the id is 0");
      case Verdict::bad_body: raise_frame("the checksum of the body is wrong");
    }
    if (found.size != bytes.size()) {
      raise_frame("the frame has " + std::to_string(found.size) + " bytes, and " +
                  std::to_string(bytes.size() - found.size) + " more follow");
    }
    const Frame frame = frame_at(bytes.data());
    return decode_body(frame.id, frame.body, from_board, contexts);
  });
}

/// The frames of a stream in one framing, or in all.
class StreamParser {
 public:
  explicit StreamParser(OptionalInteger<unsigned, "framing"> framing) {
    if (*framing) parser_.formats().accept_only(framing_at(**framing));
  }

  py::list feed(const py::buffer& chunk) {
    py::list result;
    with_bytes(chunk, [&](Bytes bytes) {
      parser_.feed(bytes, [&](const Frame& frame) { result.append(own(frame)); });
    });
    return result;
  }
  py::list flush() {
    py::list result;
    parser_.flush([&](const Frame& frame) { result.append(own(frame)); });
    return result;
  }
  ParserCounters counters() const { return parser_.counters(); }
  std::size_t waiting() const { return parser_.waiting_bytes(); }

 private:
  BasicParser<AnyFrameFormats> parser_{};
};

}  // namespace

void bind_codec(py::module_& module) {
  py::class_<Contexts>(module, "Contexts")
      .def(py::init<>())
      .def("learn", [](Contexts& contexts, const AnyMessage& message) { message.teach(contexts); });
  module.def("decode_body", [](Integer<std::uint8_t, "id"> id, const py::buffer& body,
                               bool from_board, const Contexts* contexts) {
    return with_bytes(body, [&](Bytes bytes) {
      if (bytes.size() > max_body_size) {
        raise_status("DecodeError", "command " + std::to_string(*id), {Code::too_long});
      }
      return decode_body(id, bytes, from_board, contexts);
    });
  });
  module.def("decode_frame", &decode_frame);

  py::class_<OwnFrame>(module, "Frame")
      .def_readonly("id", &OwnFrame::id)
      .def_readonly("body", &OwnFrame::body)
      .def_readonly("offset", &OwnFrame::offset)
      .def_readonly("framing", &OwnFrame::framing);
  py::class_<StreamParser>(module, "StreamParser")
      .def(py::init<OptionalInteger<unsigned, "framing">>())
      .def("feed", &StreamParser::feed)
      .def("flush", &StreamParser::flush)
      .def_property_readonly("waiting", &StreamParser::waiting)
      .def_property_readonly("counters", [](const StreamParser& parser) {
        const ParserCounters c = parser.counters();
        return py::make_tuple(c.frames, c.skipped_bytes, c.header_errors, c.body_errors,
                              c.incomplete);
      });
}

}  // namespace sbgc::python
