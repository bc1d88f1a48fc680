#include "termios.hpp"

#include <array>
#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <asm/termbits.h>
#include <sys/ioctl.h>

namespace sbgc::io::detail {

namespace {

struct StandardRate {
  std::uint32_t rate;
  tcflag_t flag;
};

/// The rates that have a constant, which other programs handle better than BOTHER.
constexpr std::array<StandardRate, 18> standard_rates{{{9600, B9600},
                                                       {19200, B19200},
                                                       {38400, B38400},
                                                       {57600, B57600},
                                                       {115200, B115200},
                                                       {230400, B230400},
                                                       {460800, B460800},
                                                       {500000, B500000},
                                                       {576000, B576000},
                                                       {921600, B921600},
                                                       {1000000, B1000000},
                                                       {1152000, B1152000},
                                                       {1500000, B1500000},
                                                       {2000000, B2000000},
                                                       {2500000, B2500000},
                                                       {3000000, B3000000},
                                                       {3500000, B3500000},
                                                       {4000000, B4000000}}};

constexpr tcflag_t input_flags = IGNBRK | BRKINT | IGNPAR | PARMRK | INPCK | ISTRIP | INLCR |
                                 IGNCR | ICRNL | IUCLC | IXON | IXANY | IXOFF;
constexpr tcflag_t local_flags =
    ISIG | ICANON | ECHO | ECHOE | ECHOK | ECHONL | NOFLSH | TOSTOP | IEXTEN;
constexpr tcflag_t control_mask = CSIZE | CSTOPB | CREAD | PARENB | PARODD | CMSPAR | CRTSCTS;

tcflag_t control_flags(Parity parity) {
  return CS8 | CREAD | (parity == Parity::even ? tcflag_t{PARENB} : 0);
}

tcflag_t rate_flag(std::uint32_t rate) {
  for (const StandardRate& standard : standard_rates) {
    if (standard.rate == rate) return standard.flag;
  }
  return BOTHER;
}

std::optional<termios2> get(int fd) {
  termios2 settings{};
  if (ioctl(fd, TCGETS2, &settings) != 0) return std::nullopt;
  return settings;
}

LineSettings line_of(const termios2& settings) {
  return {settings.c_ospeed, (settings.c_cflag & PARENB) != 0 ? Parity::even : Parity::none};
}

/// Returns true if a rate is within 2 % of the wanted one, which a UART tolerates. Drivers report
/// the actual rate of the hardware.
bool is_near(std::uint32_t rate, std::uint32_t wanted) {
  return std::llabs(std::int64_t{rate} - std::int64_t{wanted}) * 50 <= std::int64_t{wanted};
}

bool is_raw(const termios2& settings) {
  return (settings.c_iflag & input_flags) == 0 && (settings.c_oflag & OPOST) == 0 &&
         (settings.c_lflag & local_flags) == 0 && settings.c_cc[VMIN] == 1 &&
         settings.c_cc[VTIME] == 0;
}

}  // namespace

bool is_terminal(int fd) { return get(fd).has_value(); }

Error make_raw(int fd, const LineSettings& line, const std::string& name) {
  if (line.baud_rate == 0) return {Errc::line_refused, "The baud rate must not be 0."};
  std::optional<termios2> settings = get(fd);
  if (!settings) return {Errc::device_lost, name + " no longer responds."};
  settings->c_iflag &= ~input_flags;
  settings->c_oflag &= ~tcflag_t{OPOST};
  settings->c_lflag &= ~local_flags;
  // CLOCAL: ignore the modem status lines. No HUPCL: closing must not change DTR, which resets some
  // boards.
  settings->c_cflag &= ~(control_mask | HUPCL | CBAUD | CBAUD << IBSHIFT);
  settings->c_cflag |= control_flags(line.parity) | CLOCAL | rate_flag(line.baud_rate) |
                       rate_flag(line.baud_rate) << IBSHIFT;
  settings->c_ispeed = line.baud_rate;
  settings->c_ospeed = line.baud_rate;
  // With VMIN 0, a read without data would look like the end of the stream.
  settings->c_cc[VMIN] = 1;
  settings->c_cc[VTIME] = 0;
  const bool accepted = ioctl(fd, TCSETS2, &*settings) == 0;
  const int reason = errno;
  const std::optional<termios2> now = get(fd);
  if (!now) return {Errc::device_lost, name + " no longer responds."};
  if (!accepted) {
    return {Errc::line_refused, name + " does not accept " + to_string(line) + ": " +
                                    std::generic_category().message(reason) + "."};
  }
  if (!is_raw(*now)) {
    return {Errc::line_refused, name +
                                    " cannot be put in raw mode: its driver insists on changing "
                                    "some of the bytes."};
  }
  const LineSettings got = line_of(*now);
  if (!is_near(got.baud_rate, line.baud_rate) || !is_near(now->c_ispeed, line.baud_rate) ||
      (now->c_cflag & control_mask) != control_flags(line.parity)) {
    return {Errc::line_refused, name + " does not support " + to_string(line) +
                                    ": its driver set " + to_string(got) + " instead."};
  }
  return {};
}

std::optional<LineSettings> line_of(int fd) {
  const std::optional<termios2> settings = get(fd);
  if (!settings) return std::nullopt;
  return line_of(*settings);
}

void discard_input(int fd) { ioctl(fd, TCFLSH, TCIFLUSH); }
void discard_both(int fd) { ioctl(fd, TCFLSH, TCIOFLUSH); }

void set_exclusive(int fd, bool exclusive) { ioctl(fd, exclusive ? TIOCEXCL : TIOCNXCL); }

}  // namespace sbgc::io::detail
