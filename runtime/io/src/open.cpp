#include <array>
#include <concepts>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

#include <sys/stat.h>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/network.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/io/serial.hpp>

#include "termios.hpp"

namespace sbgc::io {

namespace {

using sbgc::detail::lower_case;

/// Thrown to end parsing; never leaves this file.
struct Malformed {
  std::string reason;
};

/// Parses a decimal number from 1 to `max`.
std::optional<std::uint32_t> number(std::string_view text, std::uint32_t max) {
  const auto value = sbgc::detail::parse_number<std::uint32_t>(text);
  return value && *value != 0 && *value <= max ? value : std::nullopt;
}

bool is_number(std::string_view text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos;
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

/// Rejects "COM3", "COM3:" and "\\\\.\\COM3", in any case.
void reject_port_of_windows(std::string_view path) {
  if (path.starts_with(R"(\\.\)")) path.remove_prefix(4);
  if (path.ends_with(':')) path.remove_suffix(1);
  if (lower_case(path.substr(0, 3)) != "com" || !is_number(path.substr(3))) return;
  throw Malformed{
      "it is a port of Windows, where sbgc only describes, decodes and encodes messages; WSL has "
      "the "
      "port as /dev/ttyUSB0 or /dev/ttyACM0 once usbipd attaches it"};
}

void parse_rest(std::string_view text, SerialAddress& result) {
  const auto take = [&](std::string_view key, std::string_view value) {
    const std::string word = lower_case(value);
    if (key == "baud") {
      const auto rate = number(value, std::numeric_limits<std::uint32_t>::max());
      if (!rate) throw Malformed{quoted(value) + " is not a baud rate"};
      result.line.baud_rate = *rate;
    } else if (key == "parity") {
      if (word != "none" && word != "even") {
        throw Malformed{quoted(value) + " is not a parity; parities are none and even"};
      }
      result.line.parity = word == "even" ? Parity::even : Parity::none;
    } else {
      return false;
    }
    return true;
  };
  result.path = split_options(text, "baud=NUMBER and parity=none|even", take);
  reject_port_of_windows(result.path);
}

void parse_rest(std::string_view text, CaptureAddress& result) {
  const auto take = [&](std::string_view key, std::string_view value) {
    const std::string word = lower_case(value);
    if (key != "timing") return false;
    if (word != "original" && word != "fast") {
      throw Malformed{quoted(value) + " is not a timing; timings are original and fast"};
    }
    result.timing = word == "fast" ? ReplayTiming::fast : ReplayTiming::answers;
    return true;
  };
  result.file = split_options(text, "timing=original|fast", take);
}

void parse_rest(std::string_view text, PtyAddress&) {
  if (!text.empty()) throw Malformed{"nothing may follow 'pty:'"};
}

/// HOST:PORT. Another kind of address does not compile until it has its own function.
template <class T>
  requires std::same_as<T, TcpAddress> || std::same_as<T, UdpAddress>
void parse_rest(std::string_view text, T& result) {
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
  result = {std::string(host), static_cast<std::uint16_t>(*port)};
}

std::string kind_names() {
  std::string result;
  for (const AddressKind& kind : address_kinds) {
    const bool is_last = &kind == &address_kinds.back();
    if (!result.empty()) result += is_last ? " and " : ", ";
    result += kind.name;
  }
  return result;
}

/// Throws a hint at the correct form of an address without a known kind.
[[noreturn]] void fail_without_kind(std::string_view text) {
  const std::string given(text);
  const std::size_t colon = text.find(':');
  if (lower_case(text) == "pty") throw Malformed{"write pty:"};
  if (is_number(text) || (colon == 0 && is_number(text.substr(1)))) {
    throw Malformed{"the host is missing; write tcp:HOST:" + given.substr(colon + 1)};
  }
  if (colon == std::string_view::npos) {
    const bool is_host_or_file = text.find('.') != std::string_view::npos;
    throw Malformed{is_host_or_file ? "write tcp:" + given + ":PORT for a host, capture:" + given +
                                          " for a file"
                                    : "a port is written with its path, such as /dev/" + given};
  }
  const bool is_ipv6 =
      text.find_first_not_of("0123456789abcdefABCDEF:") == std::string_view::npos &&
      text.find(':', colon + 1) != std::string_view::npos;
  if (text.starts_with('[') || is_ipv6 || is_number(text.substr(colon + 1))) {
    TcpAddress ignored;
    parse_rest(text, ignored);  // reports other errors
    throw Malformed{"the kind is missing; write tcp:" + given + " or udp:" + given};
  }
  throw Malformed{"unknown kind " + quoted(text.substr(0, colon)) + "; kinds are " + kind_names()};
}

/// Parses the rest after the kind, if it is that of T.
template <class T>
bool parse_kind(std::string_view kind, std::string_view rest, Address& result) {
  if (kind != T::kind.name) return false;
  parse_rest(rest, result.emplace<T>());
  return true;
}

template <class... Ts>
bool parse_any_kind(std::string_view kind, std::string_view rest, std::variant<Ts...>& result) {
  return (parse_kind<Ts>(kind, rest, result) || ...);
}

Address parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  const std::string kind = lower_case(text.substr(0, colon));
  if (text.empty()) throw Malformed{"it is empty"};
  reject_port_of_windows(text);
  Address result;
  if (kind.find('/') != std::string::npos) {
    parse_rest(text, std::get<SerialAddress>(result));
  } else if (colon == std::string_view::npos ||
             !parse_any_kind(kind, text.substr(colon + 1), result)) {
    fail_without_kind(text);
  }
  return result;
}

using Executor = asio::any_io_executor;

OpenResult open_at(const Executor& executor, const SerialAddress& at, const OpenOptions&) {
  return open_serial(executor, at.path, at.line);
}
OpenResult open_at(const Executor& executor, const TcpAddress& at, const OpenOptions& options) {
  return open_tcp(executor, at.host, at.port, options.timeout);
}
OpenResult open_at(const Executor& executor, const UdpAddress& at, const OpenOptions& options) {
  return open_udp(executor, at.host, at.port, options.timeout);
}
OpenResult open_at(const Executor& executor, const PtyAddress&, const OpenOptions&) {
  PseudoTerminalResult result = open_pseudo_terminal(executor, {.stays_open = true});
  return {std::move(result.transport), std::move(result.error)};
}
OpenResult open_at(const Executor& executor, const CaptureAddress& at, const OpenOptions&) {
  return open_replay(executor, at.file, at.timing);
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
  return std::visit([&](const auto& at) { return open_at(executor, at, options); }, address);
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
