/// Captures as hex text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sbgc::tools {

/// The place and the reason of an error in hex text.
struct HexError {
  std::size_t line{};    ///< from 1
  std::size_t column{};  ///< in bytes, from 1
  std::string reason{};
};

/// For example "hex text, line 3 column 7: 'g' is not a hex digit".
std::string to_text(const HexError& error);

/// Decodes hex text in blocks: two digits per byte. White space, ',', ':', ';', quotes and brackets
/// may separate bytes, "0x" or "\x" may precede a byte, and '#' starts a comment that ends with the
/// line.
class HexDecoder {
 public:
  /// Appends the bytes of `text` to `out`, up to the first error. Must not be called after an
  /// error.
  [[nodiscard]] std::optional<HexError> feed(std::span<const std::uint8_t> text,
                                             std::vector<std::uint8_t>& out);
  /// Must be called at the end. Returns an error if half a byte is left.
  [[nodiscard]] std::optional<HexError> finish() const;

 private:
  /// Returns the error of a character that is neither a digit nor the end of a line; "" if it is
  /// valid.
  std::string other(char c);
  HexError error(std::string reason) const { return {line_, column_, std::move(reason)}; }

  bool comment_ = false;
  bool half_ = false;
  bool escape_ = false;  // the last character is a backslash
  std::uint8_t high_ = 0;
  std::size_t line_ = 1;
  std::size_t column_ = 0;
};

}  // namespace sbgc::tools
