#include "command/input_output.hpp"

#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "command/command_error.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"

namespace sbgc::tools {

namespace {

int keep_open(std::FILE*) { return 0; }

std::unique_ptr<std::FILE, int (*)(std::FILE*)> open(const std::string& name) {
  if (name == "-") return {stdin, keep_open};
  std::FILE* const file = std::fopen(name.c_str(), "rb");
  if (file == nullptr) {
    throw InputError(fmt::format("cannot open '{}': {}", name, std::strerror(errno)));
  }
  return {file, std::fclose};
}

}  // namespace

Input::Input(const std::string& name, const char* awaited)
    : name_(name), file_(open(name)), block_(65536) {
  if (name != "-" || !is_terminal(stdin)) return;
  remark("sbgc: waits for {}; end them with {}\n", awaited, end_of_input);
}

Input::Input(std::string_view bytes)
    : name_("the arguments"), file_(nullptr, keep_open), block_(bytes.begin(), bytes.end()) {}

std::span<const std::uint8_t> Input::read() {
  if (file_ == nullptr) {
    return std::exchange(is_read_, true) ? std::span<const std::uint8_t>() : block_;
  }
  // fread would wait until the block is full.
  const std::ptrdiff_t size = read_available(file_.get(), block_);
  if (size < 0) {
    throw InputError(fmt::format("cannot read '{}': {}", name_, std::strerror(errno)));
  }
  return {block_.data(), static_cast<std::size_t>(size)};
}

bool Input::read_line(std::string& line, std::size_t limit) {
  line.clear();
  int c = 0;
  bool is_whole = true;
  while ((c = std::getc(file_.get())) != EOF && c != '\n') {
    if (line.size() <= limit) {
      line += static_cast<char>(c);
    } else {
      is_whole = false;
    }
  }
  if (std::ferror(file_.get()) != 0) {
    throw InputError(fmt::format("cannot read '{}': {}", name_, std::strerror(errno)));
  }
  if (is_whole && !line.empty() && line.back() == '\r') line.pop_back();
  if (std::exchange(is_first_line_, false) && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
  return c != EOF || !line.empty();
}

StandardOutput::StandardOutput() : block_(65536) {
  provide(block_.data(), block_.data() + block_.size());
}

void StandardOutput::flush() {
  const auto size = static_cast<std::size_t>(end_of_text() - block_.data());
  provide(block_.data(), block_.data() + block_.size());
  const bool is_written = std::fwrite(block_.data(), 1, size, stdout) == size;
  if (!is_written || std::fflush(stdout) != 0) {
    throw std::runtime_error("cannot write to the standard output");
  }
}

void require_no_terminal(const char* instead) {
  if (!is_terminal(stdout)) return;
  throw CommandError(
      fmt::format("the output is not text; redirect it to a file or a program, or use {}", instead),
      wrong_usage);
}

}  // namespace sbgc::tools
