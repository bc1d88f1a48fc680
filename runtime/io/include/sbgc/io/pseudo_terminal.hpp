/// Pseudo-terminals: a serial port that a program plays.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/line.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// The playing side. The other side is opened by path(), like any serial port.
class PseudoTerminal : public Transport {
 public:
  /// What the other side opens, e.g. "/dev/pts/7".
  virtual std::string path() const = 0;

  /// The settings of the other side. Nothing on the way depends on them, and there is no parity.
  virtual std::optional<LineSettings> other_line() const = 0;
};

struct PseudoTerminalOptions {
  /// false: when the other side closes, reads and writes end with Errc::device_lost. true: programs
  /// may come and go, and bytes that nobody reads are lost, as on a real line.
  bool stays_open = false;
};

struct PseudoTerminalResult {
  std::unique_ptr<PseudoTerminal> transport{};
  Error error{};

  explicit operator bool() const noexcept { return transport != nullptr; }
};

/// Makes a new pseudo-terminal, transparent for bytes from the start.
PseudoTerminalResult open_pseudo_terminal(const asio::any_io_executor& executor,
                                          const PseudoTerminalOptions& options = {});

}  // namespace sbgc::io
