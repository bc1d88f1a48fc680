/// The messages of one kind in a capture.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/any.hpp>

#include "binding.hpp"

namespace sbgc::python {

/// Bodies one after the other, as an array of numpy: each behind the time in seconds (f64) and its
/// size (u8), and with zeros up to the size of the largest.
class Bodies {
 public:
  static constexpr std::size_t head_size = sizeof(double) + 1;

  explicit Bodies(std::size_t body_size) : stride_(head_size + body_size) {}

  void add(double time, Bytes body) {
    if (head_size + body.size() > stride_) widen(head_size + body.size());
    const std::size_t begin = bytes_.size();
    bytes_.resize(begin + stride_);
    std::uint8_t* const row = bytes_.data() + begin;
    std::memcpy(row, &time, sizeof time);
    row[sizeof time] = static_cast<std::uint8_t>(body.size());
    if (!body.empty()) std::memcpy(row + head_size, body.data(), body.size());
  }

  std::size_t stride() const noexcept { return stride_; }
  std::vector<std::uint8_t>& bytes() noexcept { return bytes_; }

 private:
  void widen(std::size_t stride) {
    std::vector<std::uint8_t> wider(bytes_.size() / stride_ * stride);
    for (std::size_t row = 0; row * stride_ < bytes_.size(); ++row) {
      std::copy_n(bytes_.data() + row * stride_, stride_, wider.data() + row * stride);
    }
    bytes_ = std::move(wider);
    stride_ = stride;
  }

  std::size_t stride_;
  std::vector<std::uint8_t> bytes_{};
};

/// The values of messages whose layout varies, by their paths.
class Columns {
 public:
  void add(double time, const AnyMessage& message);

  /// Returns the times as f64, and for each path its name, the kind of its values (i, u, f, or O),
  /// the rows that have one as u32, and the values: as 64-bit numbers, or as a list of bytes or
  /// texts.
  py::tuple to_python() const;

 private:
  struct Column {
    char kind{};
    std::vector<std::uint32_t> rows{};
    std::vector<std::int64_t> integers{};
    std::vector<double> reals{};
    std::vector<std::string> others{};
    bool has_texts{};
  };

  std::vector<double> times_{};
  std::map<std::string, std::size_t, std::less<>> places_{};  // in `columns_`
  std::vector<std::pair<std::string, Column>> columns_{};     // in the order of the body
};

}  // namespace sbgc::python
