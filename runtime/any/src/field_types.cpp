#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/internal/table_access.hpp>

namespace sbgc::detail {

namespace {

std::vector<FieldType> members_of(const StructTable& table, const void* initial);

const char* type_name(RawType type) {
  constexpr const char* names[] = {"u8",  "i8",  "u16", "i16", "u24", "i24",
                                   "u32", "i32", "u64", "i64", "f32", "f64"};
  return names[static_cast<std::size_t>(type)];
}

FieldType number_type(const ValueType& type, const void* initial) {
  FieldType result{.shape = is_real(type.raw) ? FieldShape::real : FieldShape::integer,
                   .size = type.wire,
                   .unit = type.meaning.unit,
                   .names = type.meaning.names,
                   .packed = type.meaning.packed,
                   .type = type_name(type.raw)};
  if (is_real(type.raw)) return result;
  result.is_wide = type.raw == RawType::u64;
  const RawLimits limits = limits_of(type.raw);
  result.lowest = limits.lowest;
  result.highest = limits.highest;
  result.initial = load_integer(type.raw, initial);
  return result;
}

void mark_axis(FieldType& type) {
  type.is_of_axis = true;
  for (FieldType& member : type.members) mark_axis(member);
}

/// Elements share the facts of the member that they belong to.
void set_info(FieldType& type, const FieldInfo& field) {
  type.info = &field;
  if (type.has_elements() && type.members.front().info == nullptr) {
    set_info(type.members.front(), field);
  }
}

FieldType field_type(const ValueType& type, const void* initial) {
  const auto sized = [&](FieldShape shape) {
    return FieldType{
        .shape = shape, .size = type.wire, .count = type.count, .has_count = !type.is_bounded};
  };
  switch (type.kind) {
    case Kind::scalar: return number_type(type, initial);
    case Kind::bytes: return sized(FieldShape::bytes);
    case Kind::text: return sized(FieldShape::text);
    case Kind::number: return {.shape = FieldShape::announced};
    case Kind::group:
      return {.shape = FieldShape::group,
              .members = members_of(*type.group, initial),
              .size = type.wire};
    case Kind::optional: {
      FieldType result = field_type(*type.element, initial);
      result.is_optional = true;
      return result;
    }
    case Kind::counter: {
      FieldType result = field_type(value_type<std::uint8_t>, "");
      result.is_counter = true;
      return result;
    }
    case Kind::list: {
      FieldType result = sized(FieldShape::list);
      const auto element = std::make_unique<std::byte[]>(type.element->memory);
      type.construct(element.get());
      result.members.push_back(field_type(*type.element, element.get()));
      return result;
    }
    case Kind::array:
    case Kind::axes: break;
  }
  FieldType result = sized(type.kind == Kind::axes ? FieldShape::axes : FieldShape::list);
  result.members.push_back(field_type(*type.element, initial));
  if (type.kind == Kind::array) return result;
  for (std::size_t i = 0; i < type.count; ++i) result.axes.push_back(type.group->fields[i].name);
  if (type.is_gimbal) mark_axis(result.members.front());
  return result;
}

std::vector<FieldType> members_of(const StructTable& table, const void* initial) {
  std::vector<FieldType> members;
  const auto add = [&](const FieldInfo& field, const Slot& slot) {
    FieldType type = field_type(*slot.type, moved(initial, slot.offset));
    type.name = field.name;
    const bool is_limited = !type.has_count && field.max_count != 0;
    if (is_limited) type.count = std::min<std::size_t>(type.count, field.max_count);
    set_info(type, field);
    members.push_back(std::move(type));
  };
  const FieldInfo* field = table.fields;
  for (const Slot& slot : table.slots) add(*field++, slot);
  if (table.tail.type != nullptr) add(tail_field, table.tail);
  return members;
}

}  // namespace

}  // namespace sbgc::detail

namespace sbgc {

const std::vector<FieldType>& MessageType::fields() const {
  const std::vector<FieldType>* made = field_types->load(std::memory_order_acquire);
  if (made != nullptr) return *made;
  auto own = std::make_unique<const std::vector<FieldType>>(
      detail::members_of(*operations->table, make().address()));
  // Another thread may have made them at the same time.
  if (!field_types->compare_exchange_strong(made, own.get())) return *made;
  return *own.release();
}

}  // namespace sbgc
