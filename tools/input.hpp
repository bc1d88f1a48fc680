/// Where the bytes of a capture come from.
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace sbgc::tools {

/// Input that can not be read; what() says which and why.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or the standard input ("-"), read block by block as it comes in.
class Input {
 public:
  /// Throws InputError if `name` can not be opened.
  explicit Input(const std::string& name);

  /// The next bytes, empty at the end. The view is valid until the next call. Throws InputError.
  std::span<const std::uint8_t> read();

  /// The next line without its end, false at the end. Throws InputError.
  bool read_line(std::string& line);

  const std::string& name() const noexcept { return name_; }

 private:
  std::string name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::uint8_t> block_;
};

/// Reads hex text block by block: two digits a byte; white space, ',' and ':' may stand between
/// bytes, "0x" in front of one, and '#' starts a comment that ends with the line.
class HexDecoder {
 public:
  /// Appends the bytes of `text` to `out`. Throws InputError at whatever is no hex.
  void feed(std::span<const std::uint8_t> text, std::vector<std::uint8_t>& out);
  /// To be called at the end: throws InputError if half a byte is left.
  void finish() const;

 private:
  [[noreturn]] void fail(const std::string& reason) const;

  bool comment_ = false;
  bool half_ = false;
  std::uint8_t high_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 0;
};

}  // namespace sbgc::tools
