/// Progress on standard error.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <sbgc/client/progress.hpp>

namespace sbgc::tools {

/// Draws one line that changes, if standard error is a terminal; otherwise nothing. Remarks go
/// above it. Only one may exist at a time.
class ProgressBar {
 public:
  /// `unit` is the unit of the counts, such as "bytes"; "" shows the step instead.
  explicit ProgressBar(std::string unit = "");
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  ~ProgressBar();

  void show(const Progress& progress) const;
  /// Erases the line.
  void clear() const;
  /// Shows a line of text.
  void show(std::string_view text) const;

  /// Returns a handler that shows the progress, and cancels the task when the command is
  /// interrupted. The bar must outlive it.
  ProgressHandler handler() const;

 private:
  bool is_on_;
  std::string unit_;
};

}  // namespace sbgc::tools
