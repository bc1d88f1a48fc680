/// The messages of one kind in a capture.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sbgc/any.hpp>

#include "binding.hpp"

namespace sbgc::python {

/// Contiguous bodies, as a numpy array: each is preceded by the time in seconds (f64) and its size
/// (u8), and zero-padded to the largest size.
class Bodies {
 public:
  static constexpr std::size_t head_size = sizeof(double) + 1;

  explicit Bodies(std::size_t body_size) : stride_(head_size + body_size) {}

  void add(double time, Bytes body) {
    if (head_size + body.size() > stride_) widen(head_size + body.size());
    std::uint8_t* const row = resize(rows_ + 1) + rows_ * stride_;
    ++rows_;
    std::memcpy(row, &time, sizeof time);
    row[sizeof time] = static_cast<std::uint8_t>(body.size());
    std::uint8_t* const end = std::ranges::copy(body, row + head_size).out;
    std::fill(end, row + stride_, std::uint8_t{0});
  }

  std::size_t rows() const noexcept { return rows_; }
  std::size_t stride() const noexcept { return stride_; }
  const py::bytearray& bytes() const noexcept { return bytes_; }

 private:
  /// Python's array grows in place if the system can; a vector would copy its contents.
  std::uint8_t* resize(std::size_t rows) {
    if (PyByteArray_Resize(bytes_.ptr(), static_cast<py::ssize_t>(rows * stride_)) != 0) {
      throw py::error_already_set();
    }
    // NOLINTNEXTLINE(*-reinterpret-cast): from bytes to bytes
    return reinterpret_cast<std::uint8_t*>(PyByteArray_AS_STRING(bytes_.ptr()));
  }
  void widen(std::size_t stride) {
    const std::size_t from = std::exchange(stride_, stride);
    std::uint8_t* const begin = resize(rows_);
    for (std::size_t row = rows_; row-- > 0;) {
      std::uint8_t* const to = begin + row * stride;
      std::memmove(to, begin + row * from, from);
      std::fill(to + from, to + stride, std::uint8_t{0});
    }
  }

  std::size_t stride_;
  std::size_t rows_ = 0;
  py::bytearray bytes_{};
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
