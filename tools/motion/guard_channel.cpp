#include "motion/guard_channel.hpp"

#include <array>
#include <cerrno>
#include <cstring>

#include <sys/socket.h>
#include <sys/uio.h>
#include <unistd.h>

namespace sbgc::tools {

namespace {

/// One packet: a byte and a descriptor.
struct Packet {
  unsigned char byte = 0;
  alignas(cmsghdr) std::array<char, CMSG_SPACE(sizeof(int))> control{};
  iovec data{&byte, 1};
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

}  // namespace

bool send_line(int channel, const GuardedLine& line) {
  Packet packet;
  packet.byte = static_cast<unsigned char>(line.after);
  cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
  control->cmsg_level = SOL_SOCKET;
  control->cmsg_type = SCM_RIGHTS;
  control->cmsg_len = CMSG_LEN(sizeof(int));
  std::memcpy(CMSG_DATA(control), &line.descriptor, sizeof(int));
  ssize_t size = 0;
  do {
    size = ::sendmsg(channel, &packet.header, MSG_NOSIGNAL);
  } while (size < 0 && errno == EINTR);
  return size == 1;
}

GuardedLine receive_line(int channel) {
  GuardedLine line;
  while (true) {
    Packet packet;
    const ssize_t size = ::recvmsg(channel, &packet.header, MSG_CMSG_CLOEXEC);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return line;  // the end, or no channel at all
    const cmsghdr* const control = CMSG_FIRSTHDR(&packet.header);
    if (control == nullptr || control->cmsg_type != SCM_RIGHTS) continue;
    if (line.descriptor >= 0) ::close(line.descriptor);
    std::memcpy(&line.descriptor, CMSG_DATA(control), sizeof(int));
    line.after = static_cast<AfterStop>(packet.byte);
  }
}

}  // namespace sbgc::tools
