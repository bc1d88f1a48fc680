#include "input.hpp"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>
#include <unistd.h>

namespace sbgc::tools {

namespace {

int keep_open(std::FILE*) { return 0; }

std::unique_ptr<std::FILE, int (*)(std::FILE*)> open(const std::string& name) {
  if (name == "-") return {stdin, keep_open};
  std::FILE* const file = std::fopen(name.c_str(), "rb");
  if (file == nullptr) {
    throw InputError(fmt::format("can not open '{}': {}", name, std::strerror(errno)));
  }
  return {file, std::fclose};
}

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Input::Input(const std::string& name) : name_(name), file_(open(name)), block_(65536) {}

std::span<const std::uint8_t> Input::read() {
  // read(2) hands over what is there; fread would wait until the block is full.
  ssize_t size = 0;
  do {
    size = ::read(fileno(file_.get()), block_.data(), block_.size());
  } while (size < 0 && errno == EINTR);
  if (size < 0) {
    throw InputError(fmt::format("can not read '{}': {}", name_, std::strerror(errno)));
  }
  return {block_.data(), static_cast<std::size_t>(size)};
}

bool Input::read_line(std::string& line) {
  line.clear();
  int c = 0;
  while ((c = std::getc(file_.get())) != EOF && c != '\n') line += static_cast<char>(c);
  if (std::ferror(file_.get()) != 0) {
    throw InputError(fmt::format("can not read '{}': {}", name_, std::strerror(errno)));
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return c != EOF || !line.empty();
}

void HexDecoder::feed(std::span<const std::uint8_t> text, std::vector<std::uint8_t>& out) {
  for (const std::uint8_t byte : text) {
    const char c = static_cast<char>(byte);
    ++column_;
    if (c == '\n') {
      if (half_) fail("half a byte at the end of the line");
      comment_ = false;
      ++line_;
      column_ = 0;
      continue;
    }
    if (comment_) continue;
    const int digit = digit_value(c);
    if (digit >= 0 && half_) {
      out.push_back(static_cast<std::uint8_t>(high_ << 4 | digit));
      half_ = false;
    } else if (digit >= 0) {
      high_ = static_cast<std::uint8_t>(digit);
      half_ = true;
    } else if ((c == 'x' || c == 'X') && half_ && high_ == 0) {
      half_ = false;  // it was the prefix of a byte
    } else if (half_) {
      fail(fmt::format("half a byte: a second digit is missing before '{}'", c));
    } else if (c == '#') {
      comment_ = true;
    } else if (c != ' ' && c != '\t' && c != '\r' && c != ',' && c != ':') {
      const bool printable = byte > 0x20 && byte < 0x7F;
      fail(printable ? fmt::format("'{}' is no hex digit", c)
                     : fmt::format("byte 0x{:02x} is no hex digit", byte));
    }
  }
}

void HexDecoder::finish() const {
  if (half_) fail("half a byte at the end: the number of hex digits is odd");
}

void HexDecoder::fail(const std::string& reason) const {
  throw InputError(fmt::format("hex text, line {} column {}: {}", line_, column_, reason));
}

}  // namespace sbgc::tools
