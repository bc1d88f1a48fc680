/// Pseudo-terminals: serial ports simulated by a program.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/line.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// The simulating side of a serial port. Programs open the other side by path().
class PseudoTerminal : public Transport {
 public:
  /// Returns the path that the other side opens, e.g. "/dev/pts/7".
  virtual std::string path() const = 0;

  /// Returns the settings of the other side. They do not affect the transfer, and there is no
  /// parity.
  virtual std::optional<LineSettings> other_line() const = 0;
};

/// Options of open_pseudo_terminal().
struct PseudoTerminalOptions {
  /// false: when the other side closes, reads and writes fail with Errc::device_lost. true:
  /// programs may open and close it, and bytes that no program reads are lost, as on a real line.
  bool stays_open = false;
};

/// A pseudo-terminal, or the error that prevented it.
struct PseudoTerminalResult {
  std::unique_ptr<PseudoTerminal> transport{};  ///< null after an error
  Error error{};

  /// True if it was opened.
  explicit operator bool() const noexcept { return transport != nullptr; }
};

/// Opens a new pseudo-terminal in raw mode.
PseudoTerminalResult open_pseudo_terminal(const asio::any_io_executor& executor,
                                          const PseudoTerminalOptions& options = {});

}  // namespace sbgc::io
