// The program of a user who needs one family of messages.

#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>

sbgc::WriteResult write(const sbgc::msg::ControlExt& control, std::span<std::uint8_t> frame) {
  return sbgc::encode_frame(control, frame);
}
