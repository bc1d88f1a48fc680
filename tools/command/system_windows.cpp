#include <fcntl.h>
#include <io.h>
#include <windows.h>

#include "command/system.hpp"

namespace sbgc::tools {

/// Windows would change the ends of lines, and end the input at a byte 1A.
void prepare_standard_files() {
  for (std::FILE* const file : {stdin, stdout, stderr}) _setmode(_fileno(file), _O_BINARY);
  SetConsoleOutputCP(CP_UTF8);
}

std::ptrdiff_t read_available(std::FILE* file, std::span<std::uint8_t> into) {
  return _read(_fileno(file), into.data(), static_cast<unsigned>(into.size()));
}

const char* const end_of_input = "Ctrl+Z and Enter";

bool is_terminal(std::FILE* file) { return _isatty(_fileno(file)) != 0; }

std::size_t width_of_terminal(std::FILE* file) {
  CONSOLE_SCREEN_BUFFER_INFO info{};
  const DWORD handle = file == stderr ? STD_ERROR_HANDLE : STD_OUTPUT_HANDLE;
  if (GetConsoleScreenBufferInfo(GetStdHandle(handle), &info) == 0) return 0;
  return static_cast<std::size_t>(info.srWindow.Right - info.srWindow.Left + 1);
}

}  // namespace sbgc::tools
