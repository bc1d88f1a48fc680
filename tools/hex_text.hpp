/// Captures as hex text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sbgc::tools {

/// Where hex text is none, and why.
struct HexError {
  std::size_t line{};    ///< from 1
  std::size_t column{};  ///< in bytes, from 1
  std::string reason{};
};

/// "hex text, line 3 column 7: 'g' is no hex digit".
std::string to_text(const HexError& error);

/// Reads hex text block by block: two digits a byte; white space, ',' and ':' may stand between
/// bytes, "0x" in front of one, and '#' starts a comment that ends with the line.
class HexDecoder {
 public:
  /// Appends the bytes of `text` to `out`, up to whatever is no hex; nothing can follow that.
  [[nodiscard]] std::optional<HexError> feed(std::span<const std::uint8_t> text,
                                             std::vector<std::uint8_t>& out);
  /// To be called at the end: an error if half a byte is left.
  [[nodiscard]] std::optional<HexError> finish() const;

 private:
  /// What is wrong with a character that is neither a digit nor the end of a line; "" if nothing.
  std::string other(char c);
  HexError error(std::string reason) const { return {line_, column_, std::move(reason)}; }

  bool comment_ = false;
  bool half_ = false;
  std::uint8_t high_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 0;
};

}  // namespace sbgc::tools
