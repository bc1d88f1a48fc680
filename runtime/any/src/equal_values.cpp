#include "equal_values.hpp"

#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/table_access.hpp>

namespace sbgc::detail {

namespace {

bool are_equal(const ValueType& type, const void* a, const void* b) noexcept {
  switch (type.kind) {
    case Kind::scalar:
      if (is_real(type.raw)) return load_real(type.raw, a) == load_real(type.raw, b);
      return is_same_memory(a, b, type.memory);
    case Kind::group: return are_equal(*type.group, a, b);
    case Kind::number: return load<Number>(a) == load<Number>(b);
    case Kind::counter: return true;  // follows from the list
    case Kind::optional:
      if (is_present(type, a) != is_present(type, b)) return false;
      return !is_present(type, a) || are_equal(*type.element, a, b);
    case Kind::axes:
    case Kind::array:
    case Kind::list:
    case Kind::bytes:
    case Kind::text: break;
  }
  const std::size_t size = type.is_bounded ? size_at(type, a) : type.count;
  if (type.is_bounded && size_at(type, b) != size) return false;
  if (type.element == nullptr) {
    return is_same_memory(moved(a, type.begin), moved(b, type.begin), size);
  }
  for (std::size_t i = 0; i < size; ++i) {
    if (!are_equal(*type.element, element_at(type, a, i), element_at(type, b, i))) return false;
  }
  return true;
}

}  // namespace

bool are_equal(const StructTable& table, const void* a, const void* b) noexcept {
  const auto is_same = [&](const Slot& slot) {
    return are_equal(*slot.type, moved(a, slot.offset), moved(b, slot.offset));
  };
  for (const Slot& slot : table.slots) {
    if (!is_same(slot)) return false;
  }
  return table.tail.type == nullptr || is_same(table.tail);
}

}  // namespace sbgc::detail
