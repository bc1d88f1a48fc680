#include "fixed_codec.hpp"

#include <cstddef>

#include <sbgc/internal/fixed.hpp>
#include <sbgc/internal/table_access.hpp>

namespace sbgc::detail {

namespace {

/// Calls `use(kind of number)`, one with a size on the wire.
template <class Use>
void with_wire_number(RawType type, const Use& use) {
  if (type == RawType::u24) return use(U24{});
  if (type == RawType::i24) return use(I24{});
  with_raw(type, use);
}

void get(const ValueType& type, const std::uint8_t* from, void* to) {
  if (type.kind == Kind::scalar) {
    return with_wire_number(type.raw, [&]<class T>(T) { store(to, load_raw<T>(from)); });
  }
  if (type.group != nullptr) {
    for (const Slot& slot : type.group->slots) {
      get(*slot.type, from, moved(to, slot.offset));
      from += slot.type->wire;
    }
  } else if (type.kind == Kind::array) {
    for (std::size_t i = 0; i < type.count; ++i) {
      get(*type.element, from + i * type.element->wire, element_at(type, to, i));
    }
  } else {
    copy_memory(to, from, type.wire);  // bytes or a text
  }
}

void put(const ValueType& type, std::uint8_t* to, const void* from) {
  if (type.kind == Kind::scalar) {
    return with_wire_number(type.raw, [&]<class T>(T) { store_raw<T>(to, load<RawOf<T>>(from)); });
  }
  if (type.group != nullptr) {
    for (const Slot& slot : type.group->slots) {
      put(*slot.type, to, moved(from, slot.offset));
      to += slot.type->wire;
    }
  } else if (type.kind == Kind::array) {
    for (std::size_t i = 0; i < type.count; ++i) {
      put(*type.element, to + i * type.element->wire, element_at(type, from, i));
    }
  } else {
    copy_memory(to, from, type.wire);
  }
}

/// The tail, if later firmware may append one.
const Slot* tail_of(const AnyOperations& of) {
  const bool has_one = of.table->tail.type != nullptr && !of.takes_surplus;
  return has_one ? &of.table->tail : nullptr;
}

}  // namespace

Status decode_fixed(const AnyOperations& of, std::span<const std::uint8_t> body, void* message,
                    const Contexts& /*contexts*/) {
  const Slot* const tail = tail_of(of);
  const std::size_t size = of.min_size;
  if (tail != nullptr ? body.size() < size : body.size() != size) {
    return wrong_size(body.size(), size);
  }
  get({.kind = Kind::group, .group = of.table}, body.data(), message);
  if (tail == nullptr) return {};
  void* const at = moved(message, tail->offset);
  if (!resize(*tail->type, at, body.size() - size)) {
    resize(*tail->type, at, 0);
    return {Code::too_long, max_body_size};
  }
  copy_memory(moved(at, tail->type->begin), body.data() + size, body.size() - size);
  return {};
}

WriteResult encode_fixed(const AnyOperations& of, const void* message,
                         std::span<std::uint8_t> out) {
  const Slot* const tail = tail_of(of);
  const void* const at = tail == nullptr ? nullptr : moved(message, tail->offset);
  const std::size_t more = tail == nullptr ? 0 : size_at(*tail->type, at);
  const std::size_t size = of.min_size + more;
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put({.kind = Kind::group, .group = of.table}, out.data(), message);
  if (more != 0) copy_memory(out.data() + of.min_size, moved(at, tail->type->begin), more);
  return {size, {}};
}

}  // namespace sbgc::detail
