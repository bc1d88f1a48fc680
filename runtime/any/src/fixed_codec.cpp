#include "fixed_codec.hpp"

#include <cstddef>

#include <sbgc/internal/fixed.hpp>
#include <sbgc/internal/table_access.hpp>

namespace sbgc::detail {

namespace {

/// Calls `use(T{})` with the type of a number on the wire.
template <class Use>
void with_wire_number(RawType type, const Use& use) {
  if (type == RawType::u24) return use(U24{});
  if (type == RawType::i24) return use(I24{});
  with_raw(type, use);
}

void get(const Run& run, const std::uint8_t* body, void* message) {
  const std::uint8_t* const from = body + run.wire;
  void* const to = moved(message, run.memory);
  if (run.raw == RawType::u8) return copy_memory(to, from, run.count);
  with_wire_number(run.raw, [&]<class T>(T) {
    for (std::size_t i = 0; i < run.count; ++i) {
      store(moved(to, i * sizeof(RawOf<T>)), load_raw<T>(from + i * wire_size<T>));
    }
  });
}

void put(const Run& run, const void* message, std::uint8_t* body) {
  std::uint8_t* const to = body + run.wire;
  const void* const from = moved(message, run.memory);
  if (run.raw == RawType::u8) return copy_memory(to, from, run.count);
  with_wire_number(run.raw, [&]<class T>(T) {
    for (std::size_t i = 0; i < run.count; ++i) {
      store_raw<T>(to + i * wire_size<T>, load<RawOf<T>>(moved(from, i * sizeof(RawOf<T>))));
    }
  });
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
  for (const Run& run : of.runs) get(run, body.data(), message);
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
  for (const Run& run : of.runs) put(run, message, out.data());
  if (more != 0) copy_memory(out.data() + of.min_size, moved(at, tail->type->begin), more);
  return {size, {}};
}

}  // namespace sbgc::detail
