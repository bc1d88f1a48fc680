#include "columns.hpp"

#include <algorithm>
#include <cstring>
#include <functional>
#include <future>
#include <thread>
#include <vector>

#include <sbgc/internal/fixed.hpp>

namespace sbgc::python {

namespace {

/// Calls `use` with the type of a number on the wire.
template <class Use>
void with_number(const FieldType& type, const Use& use) {
  const bool is_signed = type.lowest < 0;
  if (type.shape == FieldShape::real) return type.size == 4 ? use(float{}) : use(double{});
  switch (type.size) {
    case 1: return is_signed ? use(std::int8_t{}) : use(std::uint8_t{});
    case 2: return is_signed ? use(std::int16_t{}) : use(std::uint16_t{});
    case 3: return is_signed ? use(I24{}) : use(U24{});
    case 4: return is_signed ? use(std::int32_t{}) : use(std::uint32_t{});
    default: return is_signed ? use(std::int64_t{}) : use(std::uint64_t{});
  }
}

template <class Convert>
void fill(const Rows& rows, const NumberColumn& column, const Convert& convert) {
  const std::uint8_t* from = rows.first + column.offset;
  for (std::size_t i = 0; i < rows.count; ++i, from += rows.stride) {
    const auto value = convert(from);
    std::memcpy(column.to + i * sizeof value, &value, sizeof value);
  }
}

void fill_part(const Rows& rows, std::span<const NumberColumn> columns, std::size_t first,
               std::size_t end) {
  constexpr std::size_t block = 1024;  // the bytes stay in the cache until all columns have them
  for (std::size_t begin = first; begin < end; begin += block) {
    const Rows part{rows.first + begin * rows.stride, std::min(block, end - begin), rows.stride};
    for (const NumberColumn& whole : columns) {
      const FieldType& type = *whole.type;
      const NumberColumn column{&type, whole.offset, whole.to + begin * number_size(type)};
      with_number(type, [&]<class T>(T) {
        const auto load = [](const std::uint8_t* from) { return detail::load_raw<T>(from); };
        if (type.unit == nullptr) return fill(part, column, load);
        fill(part, column, [unit = *type.unit, &load](const std::uint8_t* from) {
          return unit.real(static_cast<double>(load(from)));
        });
      });
    }
  }
}

}  // namespace

std::size_t number_size(const FieldType& type) {
  if (type.unit != nullptr) return sizeof(double);
  return type.size == 3 ? 4 : type.size;
}

void fill(const Rows& rows, std::span<const NumberColumn> columns) {
  constexpr std::size_t worth_a_thread = 50'000;  // rows, which take some milliseconds
  const std::size_t most = std::clamp(std::thread::hardware_concurrency(), 1U, 4U);
  const std::size_t threads = std::clamp<std::size_t>(rows.count / worth_a_thread, 1, most);
  const auto begin_of = [&](std::size_t part) { return rows.count * part / threads; };
  std::vector<std::future<void>> others;  // not std::jthread, which some systems lack
  for (std::size_t i = 1; i < threads; ++i) {
    others.push_back(std::async(std::launch::async, fill_part, std::cref(rows), columns,
                                begin_of(i), begin_of(i + 1)));
  }
  fill_part(rows, columns, 0, begin_of(1));
}

}  // namespace sbgc::python
