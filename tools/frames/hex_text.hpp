/// Bytes as hex text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sbgc::tools {

/// The position and the reason of an error in a text.
struct TextError {
  std::size_t line{};    ///< from 1
  std::size_t column{};  ///< in bytes, from 1
  std::string reason{};
};

/// Decodes hex text in blocks: two digits per byte, or one for those below 16. White space, ',',
/// ':', ';', '.', '-', '|', '$', quotes and brackets may separate bytes, "0x" or "\x" may precede a
/// byte, 'h' may follow one, and '#' starts a comment that ends with the line.
class HexDecoder {
 public:
  /// Appends the bytes of `text` to `out`, up to the first error. Must not be called after an
  /// error.
  [[nodiscard]] std::optional<TextError> feed(std::span<const std::uint8_t> text,
                                              std::vector<std::uint8_t>& out);
  /// Must be called at the end. Appends a final single digit; returns an error if half a byte is
  /// left.
  [[nodiscard]] std::optional<TextError> finish(std::vector<std::uint8_t>& out);

 private:
  /// Processes a character that is neither a digit nor the end of a line. Returns the error; "" if
  /// it is valid.
  std::string other(char c, std::vector<std::uint8_t>& out);
  /// Returns false if half a byte is left.
  bool end_word(std::vector<std::uint8_t>& out);
  TextError error(std::string reason) const { return {line_, column_, std::move(reason)}; }

  bool comment_ = false;
  bool half_ = false;
  bool alone_ = true;         // if half_: no digit before it in the same word
  bool is_prefixed_ = false;  // "0x" begins the word
  bool has_two_ = false;      // a word that needs two digits per byte, such as "00"
  bool escape_ = false;       // the last character is a backslash
  std::uint8_t high_ = 0;
  std::size_t angle_ = 0;  // the column of a '<' that may be the last character
  std::size_t line_ = 1;
  std::size_t column_ = 0;
};

}  // namespace sbgc::tools
