/// A full-screen terminal, using ncurses.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string_view>

namespace sbgc::tools {

enum class Style : unsigned char { normal, bold, dim, title, good, bad, accent };

/// Keys that are not characters.
namespace key {
inline constexpr int up = 1001;
inline constexpr int down = 1002;
inline constexpr int left = 1003;
inline constexpr int right = 1004;
inline constexpr int page_up = 1005;
inline constexpr int page_down = 1006;
inline constexpr int home = 1007;
inline constexpr int end = 1008;
inline constexpr int resized = 1009;
}  // namespace key

/// Takes over the terminal, and restores it afterwards. Only one may exist.
class Screen {
 public:
  /// Throws CommandError if there is no terminal, or its type is unknown.
  Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;
  ~Screen();

  std::size_t width() const;
  std::size_t height() const;
  /// True if the terminal shows UTF-8.
  bool has_utf8() const { return has_utf8_; }

  void clear();
  /// Marks everything that is written from now on as outdated.
  void set_faint(bool is_faint) { is_faint_ = is_faint; }
  /// Writes text at a position, cut at the right edge. Positions outside the screen are ignored.
  void put(std::size_t row, std::size_t column, std::string_view text, Style style = Style::normal);
  /// Fills the rest of a row.
  void fill(std::size_t row, Style style);
  /// Shows what was written.
  void show();

  /// Waits for a key; returns nothing after the timeout.
  std::optional<int> wait_for_key(std::chrono::milliseconds time);

 private:
  bool has_utf8_ = false;
  bool is_faint_ = false;
};

}  // namespace sbgc::tools
