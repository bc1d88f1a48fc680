#include <sbgc/io/error.hpp>

namespace sbgc::io {

namespace {

class Category final : public std::error_category {
 public:
  const char* name() const noexcept override { return "sbgc.io"; }

  std::string message(int value) const override {
    switch (static_cast<Errc>(value)) {
      case Errc::end_of_stream: return "The other side has closed the connection.";
      case Errc::device_lost: return "The device is gone: it may have been unplugged.";
      case Errc::no_such_port: return "There is no such port.";
      case Errc::not_a_port: return "This is not a serial port.";
      case Errc::permission_denied: return "You do not have permission to open it.";
      case Errc::busy: return "Another program is using it.";
      case Errc::line_refused: return "The port does not support these line settings.";
      case Errc::bad_address: return "The address is malformed.";
      case Errc::host_not_found: return "No host of this name was found.";
      case Errc::refused: return "The connection was refused: nothing listens there.";
      case Errc::unreachable: return "The host cannot be reached.";
      case Errc::timed_out: return "Nothing answered in time.";
      case Errc::not_a_capture: return "This is not a capture.";
    }
    return "The error code is unknown.";
  }
};

}  // namespace

const std::error_category& error_category() noexcept {
  static const Category category;
  return category;
}

}  // namespace sbgc::io
