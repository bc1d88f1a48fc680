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

/// Input that cannot be read; what() says which and why.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or the standard input ("-"), read block by block as it comes in.
class Input {
 public:
  /// Throws InputError if `name` cannot be opened.
  explicit Input(const std::string& name);

  /// The next bytes, empty at the end. The view is valid until the next call. Throws InputError.
  std::span<const std::uint8_t> read();

  /// The next line without its end, false at the end. Of a line longer than `limit` bytes it keeps
  /// the first `limit + 1`. Throws InputError.
  bool read_line(std::string& line, std::size_t limit);

  const std::string& name() const noexcept { return name_; }

 private:
  std::string name_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::uint8_t> block_;
};

}  // namespace sbgc::tools
