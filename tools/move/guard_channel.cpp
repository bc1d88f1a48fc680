#include "move/guard_channel.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

namespace sbgc::tools {

namespace {

/// One packet: a byte and a descriptor, or the text of parameters.
struct Packet {
  std::array<char, 1024> bytes{};
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec data{bytes.data(), bytes.size()};
  msghdr header{};

  Packet() {
    header.msg_iov = &data;
    header.msg_iovlen = 1;
    header.msg_control = control.data();
    header.msg_controllen = control.size();
  }
  Packet(const Packet&) = delete;
  Packet& operator=(const Packet&) = delete;
  ~Packet() = default;
};

bool send_packet(int channel, const Packet& packet) {
  ssize_t size = 0;
  do {
    size = ::sendmsg(channel, &packet.header, MSG_NOSIGNAL);
  } while (size < 0 && errno == EINTR);
  return size == static_cast<ssize_t>(packet.data.iov_len);
}

/// The name of the message, a null, the copy, and the body.
std::string packed_text(const Parameters& parameters) {
  std::string text = parameters.id.message;
  text += '\0';
  text += static_cast<char>(parameters.id.copy);
  return text.append(parameters.body.begin(), parameters.body.end());
}

Parameters unpacked(std::string_view text) {
  Parameters parameters;
  const std::size_t end = text.find('\0');
  if (end == std::string_view::npos || end + 2 > text.size()) return parameters;
  parameters.id.message = text.substr(0, end);
  parameters.id.copy = static_cast<std::uint8_t>(text[end + 1]);
  const std::string_view body = text.substr(end + 2);
  parameters.body.assign(body.begin(), body.end());
  return parameters;
}

}  // namespace

bool send_line(int channel, const GuardedLine& line) {
  Packet packet;
  packet.bytes[0] = static_cast<char>(line.after);
  packet.data.iov_len = 1;
  cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(control), &line.descriptor, sizeof(int));
  return send_packet(channel, packet);
}

bool send_parameters(int channel, const Parameters& parameters) {
  const std::string text = packed_text(parameters);
  Packet packet;
  if (text.size() > packet.bytes.size()) {
    errno = EMSGSIZE;
    return false;
  }
  std::ranges::copy(text, packet.bytes.begin());
  packet.data.iov_len = text.size();
  packet.header.msg_control = nullptr;
  packet.header.msg_controllen = 0;
  return send_packet(channel, packet);
}

GuardedLine receive_line(int channel) {
  GuardedLine line;
  while (true) {
    Packet packet;
    const ssize_t size = ::recvmsg(channel, &packet.header, MSG_CMSG_CLOEXEC);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return line;  // the end, or no channel at all
    const cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
    if (control == nullptr) {
      const std::string_view text(packet.bytes.data(), static_cast<std::size_t>(size));
      // The sender is this program, so that they can be decoded.
      static_cast<void>(line.restored.put(unpacked(text)));
      continue;
    }
    if (control->cmsg_type != SCM_RIGHTS) continue;
    if (line.descriptor >= 0) ::close(line.descriptor);
    std::memcpy(&line.descriptor, CMSG_DATA(control), sizeof(int));
    line.after = static_cast<AfterStop>(packet.bytes[0]);
  }
}

}  // namespace sbgc::tools
