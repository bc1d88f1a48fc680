#include <array>
#include <charconv>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <sys/stat.h>

#include <sbgc/io/network.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/io/serial.hpp>

#include "descriptor.hpp"
#include "termios.hpp"

namespace sbgc::io {

namespace {

/// Thrown to end parsing; never leaves this file.
struct Malformed {
  std::string reason;
};

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;

/// Parses a decimal number from 1 to `max`.
std::optional<std::uint32_t> number(std::string_view text, std::uint32_t max) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value == 0 || value > max) {
    return std::nullopt;
  }
  return value;
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Parses "path?key=value&key=value". Returns the path and passes each option to `take`, which
/// returns false for an unknown key. `known` names the keys.
template <class Take>
std::string split_options(std::string_view text, const char* known, Take take) {
  const std::size_t mark = text.rfind('?');
  std::string path(text.substr(0, mark));
  if (path.empty()) throw Malformed{"the path is missing"};
  if (mark == std::string_view::npos) return path;
  std::set<std::string_view> seen;
  std::string_view rest = text.substr(mark + 1);
  for (bool more = true; more;) {
    const std::size_t end = rest.find('&');
    const std::string_view option = rest.substr(0, end);
    more = end != std::string_view::npos;
    if (more) rest.remove_prefix(end + 1);
    const std::size_t equals = option.find('=');
    const std::string_view key = option.substr(0, equals);
    if (equals == std::string_view::npos) {
      throw Malformed{quoted(option) + " is not an option; options are " + known};
    }
    if (!seen.insert(key).second) throw Malformed{quoted(key) + " occurs twice"};
    if (!take(key, option.substr(equals + 1))) {
      throw Malformed{"unknown option " + quoted(key) + "; options are " + known};
    }
  }
  return path;
}

SerialAddress parse_serial(std::string_view text) {
  SerialAddress result;
  const auto take = [&](std::string_view key, std::string_view value) {
    if (key == "baud") {
      const auto rate = number(value, std::numeric_limits<std::uint32_t>::max());
      if (!rate) throw Malformed{quoted(value) + " is not a baud rate"};
      result.line.baud_rate = *rate;
    } else if (key == "parity") {
      if (value != "none" && value != "even") {
        throw Malformed{quoted(value) + " is not a parity; parities are none and even"};
      }
      result.line.parity = value == "even" ? Parity::even : Parity::none;
    } else {
      return false;
    }
    return true;
  };
  result.path = split_options(text, "baud=NUMBER and parity=none|even", take);
  return result;
}

CaptureAddress parse_capture(std::string_view text) {
  CaptureAddress result;
  const auto take = [&](std::string_view key, std::string_view value) {
    if (key != "timing") return false;
    if (value != "original" && value != "fast") {
      throw Malformed{quoted(value) + " is not a timing; timings are original and fast"};
    }
    result.timing = value == "fast" ? ReplayTiming::fast : ReplayTiming::original;
    return true;
  };
  result.file = split_options(text, "timing=original|fast", take);
  return result;
}

template <class T>
T parse_host_and_port(std::string_view text) {
  if (text.starts_with("//")) throw Malformed{"slashes before the host are not allowed"};
  const std::size_t colon = text.rfind(':');
  const bool bracketed = text.starts_with('[');
  if (colon == std::string_view::npos || (bracketed && text.ends_with(']'))) {
    throw Malformed{"the port is missing; write HOST:PORT"};
  }
  std::string_view host = text.substr(0, colon);
  if (bracketed) {
    if (!host.ends_with(']')) throw Malformed{"the ']' after the IPv6 address is missing"};
    host = host.substr(1, host.size() - 2);
  } else if (host.find(':') != std::string_view::npos) {
    throw Malformed{"an IPv6 address needs brackets; write [ADDRESS]:PORT"};
  }
  if (host.empty()) throw Malformed{"the host is missing; write HOST:PORT"};
  const auto port = number(text.substr(colon + 1), 65535);
  if (!port) {
    throw Malformed{quoted(text.substr(colon + 1)) + " is not a port; ports are 1 to 65535"};
  }
  return {std::string(host), static_cast<std::uint16_t>(*port)};
}

Address parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string_view kind = text.substr(0, colon);
  if (text.empty()) throw Malformed{"it is empty"};
  if (kind.find('/') != std::string_view::npos) return parse_serial(text);
  if (colon == std::string_view::npos) {
    throw Malformed{"a port is written with its path, such as /dev/" + std::string(text)};
  }
  const std::string_view rest = text.substr(colon + 1);
  if (kind == "serial") return parse_serial(rest);
  if (kind == "tcp") return parse_host_and_port<TcpAddress>(rest);
  if (kind == "udp") return parse_host_and_port<UdpAddress>(rest);
  if (kind == "capture") return parse_capture(rest);
  if (kind == "pty") {
    if (!rest.empty()) throw Malformed{"nothing may follow 'pty:'"};
    return PtyAddress{};
  }
  throw Malformed{"unknown kind " + quoted(kind) + "; kinds are serial, tcp, udp, pty and capture"};
}

}  // namespace

AddressResult parse_address(std::string_view text) {
  try {
    return {parse(text), {}};
  } catch (const Malformed& malformed) {
    return {{},
            {Errc::bad_address,
             "The address " + quoted(text) + " is malformed: " + malformed.reason + "."}};
  }
}

OpenResult open(const asio::any_io_executor& executor, std::string_view address,
                const OpenOptions& options) {
  AddressResult parsed = parse_address(address);
  if (!parsed) return {nullptr, std::move(parsed.error)};
  return open(executor, parsed.address, options);
}

OpenResult open(const asio::any_io_executor& executor, const Address& address,
                const OpenOptions& options) {
  return std::visit(
      Overloaded{
          [&](const SerialAddress& at) { return open_serial(executor, at.path, at.line); },
          [&](const TcpAddress& at) {
            return open_tcp(executor, at.host, at.port, options.timeout);
          },
          [&](const UdpAddress& at) {
            return open_udp(executor, at.host, at.port, options.timeout);
          },
          [&](const PtyAddress&) {
            PseudoTerminalResult result = open_pseudo_terminal(executor, {.stays_open = true});
            return OpenResult{std::move(result.transport), std::move(result.error)};
          },
          [&](const CaptureAddress& at) { return open_replay(executor, at.file, at.timing); }},
      address);
}

OpenResult adopt(const asio::any_io_executor& executor, int descriptor) {
  detail::Descriptor fd(descriptor);
  struct stat status {};
  if (fstat(fd.get(), &status) == 0) {
    if (S_ISSOCK(status.st_mode)) return adopt_socket(executor, fd.release());
    if (detail::is_terminal(fd.get())) return adopt_serial(executor, fd.release());
  }
  return {nullptr, {Errc::not_a_port, "This descriptor is not that of a line."}};
}

}  // namespace sbgc::io
