/// Input files and the standard output of the command.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/text_output.hpp>

namespace sbgc::tools {

/// Input cannot be read; what() names the input and the reason.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or the standard input ("-"), read in blocks as they arrive.
class Input {
 public:
  /// Throws InputError if `name` cannot be opened. Says that it waits for what is `awaited`, such
  /// as "JSON lines", if people have to type it.
  Input(const std::string& name, const char* awaited);
  /// Bytes that are already here.
  explicit Input(std::string_view bytes);

  /// Returns the next bytes; empty at the end. The view is valid until the next call. Throws
  /// InputError.
  std::span<const std::uint8_t> read();

  /// Reads the next line without its end and without a byte order mark; returns false at the end.
  /// Keeps only the first `limit + 1` bytes of a line longer than `limit`. Throws InputError.
  bool read_line(std::string& line, std::size_t limit);

  const std::string& name() const noexcept { return name_; }

 private:
  std::string name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::uint8_t> block_;
  bool is_read_ = false;  // without a file
  bool is_first_line_ = true;
};

/// Collects text for the standard output and writes it in blocks. Throws std::runtime_error if that
/// fails.
class StandardOutput final : public TextOutput {
 public:
  StandardOutput();

  /// Writes what is collected, because a reader may be waiting for it.
  void flush();

 private:
  void make_room() override { flush(); }

  std::vector<char> block_;
};

/// Throws CommandError if the standard output is a terminal, which must not get bytes of the
/// protocol. `instead` is what the user can do.
void require_no_terminal(const char* instead);

}  // namespace sbgc::tools
