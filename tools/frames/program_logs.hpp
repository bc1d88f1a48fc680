/// Bytes in the logs of other programs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "frames/text_lines.hpp"

namespace sbgc::tools {

// Each appends the bytes of a line to `out`, up to the first problem, and sets `sender` if the line
// names it. Unrelated lines contain no bytes.

/// The Debug tab of the vendor's program: "V [86,18] [1f 46 a 0] 8a", which is the character of the
/// id, the id and the size in decimal, the body in hex, and its checksum. Appends whole frames.
std::optional<LineProblem> read_debug_tab(std::string_view line, std::vector<std::uint8_t>& out);

/// strace: 'write(3, ">V\0V\0", 5) = 5'. The traced program is the host.
std::optional<LineProblem> read_strace(std::string_view line, std::vector<std::uint8_t>& out,
                                       std::optional<Direction>& sender);

/// candump: "can0  123   [3]  3E 56 00", "(1.5) can0 123#3E5600".
std::optional<LineProblem> read_candump(std::string_view line, std::vector<std::uint8_t>& out,
                                        std::optional<Direction>& sender);

/// socat -x: "> 2026/11/26 12:34:56.000123  length=5 from=0 to=4", then the bytes in hex, with -v
/// also as characters. Its arrows do not tell on which side the board is.
class SocatLines {
 public:
  std::optional<LineProblem> read(std::string_view line, std::vector<std::uint8_t>& out);

 private:
  std::uint64_t left_ = 0;  // bytes that the last header has announced
};

/// A table with a header line, such as from Saleae Logic 2: 'name,type,start_time,duration,data',
/// then '"Async Serial","data",0.1,8.6e-05,0x3E'.
class ByteTable {
 public:
  std::optional<LineProblem> read(std::string_view line, std::vector<std::uint8_t>& out,
                                  std::optional<Direction>& sender);

 private:
  std::optional<LineProblem> read_titles(const std::vector<std::string_view>& cells);

  static constexpr std::size_t none = static_cast<std::size_t>(-1);
  char delimiter_ = '\0';  // '\0' before the header line
  // Columns.
  std::size_t data_ = none;
  std::size_t type_ = none;
  std::size_t name_ = none;
};

}  // namespace sbgc::tools
