#include <array>
#include <cstddef>
#include <cstring>
#include <string_view>

#include <sbgc/any.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/text.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/to_json.hpp>

#include "path_steps.hpp"

namespace sbgc::detail {

namespace {

/// Walks along a path using the tables, skipping other values. The offset of the leaf is unknown.
class LeafFinder : LeafWalk {
 public:
  LeafFinder(std::string_view path, Use use, void* user, const Availability& versions)
      : LeafWalk(use, user, versions), steps_(path) {}

  /// Uses the value at the path. Returns false if the message does not have it.
  bool find(const StructTable& table, const void* message) {
    table_ = &table;
    message_ = message;
    return members(table, message, nullptr);
  }

  /// Returns the number of elements at the path; 0 if the message has no such list.
  std::size_t count(const StructTable& table, const void* message) {
    members(table, message, nullptr);
    return count_;
  }

 private:
  bool members(const StructTable& table, const void* object, const FieldPath* parent) {
    const std::string_view name = steps_.take_name();
    const VariableInfo* variable = nullptr;
    const FieldInfo* field = table.fields;
    for (const Slot& slot : table.slots) {
      const void* const at = moved(object, slot.offset);
      if (slot.type->is_variable_id) variable = find_variable(load<msg::VariableId>(at));
      if (name == field->name) {
        const FieldPath path{parent, field->name};
        const bool has_variable = field->is_variable_value && is_plain_integer(*slot.type);
        return value(*field, *slot.type, at, path, has_variable ? variable : nullptr);
      }
      ++field;
    }
    if (table.tail.type == nullptr || name != tail_field.name) return false;
    const void* const tail = moved(object, table.tail.offset);
    if (size_at(*table.tail.type, tail) == 0) return false;
    return value(tail_field, *table.tail.type, tail, {parent, tail_field.name});
  }

  bool value(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path,
             const VariableInfo* variable = nullptr) {
    switch (type.kind) {
      case Kind::group: return members(*type.group, at, &path);
      case Kind::axes: return axis(field, type, at, path);
      case Kind::array:
      case Kind::list: return element(field, type, at, path);
      case Kind::optional: return is_present(type, at) && value(field, *type.element, at, path);
      default: break;
    }
    if (!steps_.is_end()) return false;
    if (field.alternative != nullptr) skip(*table_, message_);
    if (variable != nullptr) {
      scalar(field, type, at, path, {.unit = &variable->unit}, variable->later);
    } else {
      LeafWalk::value(field, type, at, path);
    }
    return true;
  }

  bool axis(const FieldInfo& field, const ValueType& type, const void* at, const FieldPath& path) {
    const std::string_view name = steps_.take_name();
    for (std::size_t i = 0; i < type.count; ++i) {
      const char* const own = type.group->fields[i].name;
      if (name == own) return value(field, *type.element, element_at(type, at, i), {&path, own, i});
    }
    return false;
  }

  bool element(const FieldInfo& field, const ValueType& type, const void* at,
               const FieldPath& path) {
    const std::size_t size = size_at(type, at);
    if (steps_.is_end()) count_ = size;
    const std::size_t index = steps_.take_index();
    if (index >= size) return false;
    return value(field, *type.element, element_at(type, at, index), {&path, "", index});
  }

  PathSteps steps_;
  const StructTable* table_ = nullptr;
  const void* message_ = nullptr;
  std::size_t count_ = 0;
};

/// Compares messages like their operator==, which compares real numbers as such.
bool are_equal(const StructTable& table, const void* a, const void* b) noexcept;

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

bool are_equal(const StructTable& table, const void* a, const void* b) noexcept {
  const auto is_same = [&](const Slot& slot) {
    return are_equal(*slot.type, moved(a, slot.offset), moved(b, slot.offset));
  };
  for (const Slot& slot : table.slots) {
    if (!is_same(slot)) return false;
  }
  return table.tail.type == nullptr || is_same(table.tail);
}

}  // namespace
}  // namespace sbgc::detail

namespace sbgc {

namespace {

/// The tail of a message.
class Tail {
 public:
  Tail(const detail::Slot& slot, void* message)
      : type_(*slot.type), at_(detail::moved(message, slot.offset)) {}

  std::span<const std::uint8_t> bytes() const noexcept {
    const auto* const begin = static_cast<const std::uint8_t*>(detail::moved(at_, type_.begin));
    return {begin, detail::size_at(type_, at_)};
  }
  void assign(std::span<const std::uint8_t> bytes) noexcept {
    detail::resize(type_, at_, bytes.size());
    if (bytes.empty()) return;  // memcpy() does not accept null pointers
    std::memcpy(detail::moved(at_, type_.begin), bytes.data(), bytes.size());
  }

 private:
  const detail::ValueType& type_;
  void* at_;
};

}  // namespace

const MessageType* find_message(std::string_view name) noexcept {
  for (const MessageType* const type : message_types()) {
    if (type->info->name == name) return type;
  }
  return nullptr;
}

AnyMessage::AnyMessage(const MessageType& type)
    : type_(&type), memory_(std::make_unique<std::byte[]>(type.memory)) {
  type.operations->construct(memory_.get());
}

AnyMessage::AnyMessage(const MessageType& type, const void* message)
    : type_(&type), memory_(std::make_unique<std::byte[]>(type.memory)) {
  const detail::AnyOperations& operations = *type.operations;
  std::memcpy(memory_.get(), message, operations.size);
  // The surplus may begin there, in the padding of the message.
  if (operations.takes_surplus) Tail(operations.table->tail, memory_.get()).assign({});
}

AnyMessage::AnyMessage(const AnyMessage& other) : AnyMessage(*other.type_) {
  std::memcpy(memory_.get(), other.memory_.get(), type_->memory);
}

// With surplus, these behave like the functions for WithSurplus<M>.

Status AnyMessage::decode(std::span<const std::uint8_t> body, const Contexts& contexts) noexcept {
  const detail::AnyOperations& operations = *type_->operations;
  const Status status = operations.decode(operations, body, memory_.get(), contexts);
  if (!operations.takes_surplus) return status;
  Tail tail(table().tail, memory_.get());
  tail.assign({});
  if (status.code != Code::too_long || body.size() <= type_->info->max_size) return status;
  tail.assign(body.subspan(status.offset));
  return operations.decode(operations, body.first(status.offset), memory_.get(), contexts);
}

WriteResult AnyMessage::encode(std::span<std::uint8_t> out) const noexcept {
  const detail::AnyOperations& operations = *type_->operations;
  const WriteResult written = operations.encode(operations, memory_.get(), out);
  if (!written || !operations.takes_surplus) return written;
  const auto surplus = Tail(table().tail, memory_.get()).bytes();
  if (surplus.empty()) return written;
  const auto at = static_cast<std::uint16_t>(written.size);
  const std::size_t size = written.size + surplus.size();
  if (size > out.size()) return {0, {Code::buffer_too_small, at, tail_field.name}};
  std::memcpy(out.data() + at, surplus.data(), surplus.size());
  alignas(std::max_align_t) std::array<std::byte, detail::largest_with_surplus> memory{};
  operations.construct(memory.data());
  const Status status = operations.decode(operations, out.first(size), memory.data(), {});
  const bool is_surplus =
      status.code == Code::too_long && size > type_->info->max_size && status.offset == at;
  if (!is_surplus) return {0, {Code::presence_mismatch, at, tail_field.name}};
  return {size, {}};
}

bool AnyMessage::find_leaf(std::string_view path, const Availability& versions,
                           detail::LeafWalk::Use use, void* user) const {
  return detail::LeafFinder(path, use, user, versions).find(table(), memory_.get());
}

std::size_t AnyMessage::count(std::string_view path) const {
  detail::LeafFinder finder(path, nullptr, nullptr, {});
  return finder.count(table(), memory_.get());
}

bool AnyMessage::validate(const Availability& versions, detail::Violations::Report report,
                          void* user) const {
  return detail::report_violations(table(), memory_.get(), versions, report, user);
}

bool operator==(const AnyMessage& a, const AnyMessage& b) noexcept {
  return a.type_ == b.type_ && detail::are_equal(a.table(), a.memory_.get(), b.memory_.get());
}

WriteResult AnyMessage::encode_frame(Framing framing, std::span<std::uint8_t> out) const noexcept {
  std::array<std::uint8_t, max_body_size> body{};
  const WriteResult written = encode(body);
  if (written)
    return write_frame(framing, type_->info->id, std::span(body).first(written.size), out);
  Status status = written.status;
  if (status.code == Code::buffer_too_small) status.code = Code::too_long;
  return {0, status};
}

void AnyMessage::write_json(TextOutput& out, Secrets secrets) const {
  detail::put_json(out, table(), memory_.get(), secrets);
}

std::string AnyMessage::to_json(Secrets secrets) const {
  return detail::json_string(table(), memory_.get(), secrets);
}

JsonResult AnyMessage::from_json(std::string_view text) {
  const AnyMessage read(*type_);
  JsonResult result = detail::read_json(text, table(), read.memory_.get());
  // In place, so that pointers returned by get_if() remain valid.
  if (result) std::memcpy(memory_.get(), read.memory_.get(), type_->memory);
  return result;
}

bool AnyMessage::holds_secret() const {
  bool is_found = false;
  if (type_->info->has_secret()) {
    for_each_leaf([&](const Leaf& leaf) { is_found = is_found || sbgc::holds_secret(leaf); });
  }
  return is_found;
}

bool holds_secret(Direction direction, std::uint8_t id, std::span<const std::uint8_t> body) {
  const MessageType* const type = find_message(direction, id, body.size());
  if (type == nullptr || !type->info->has_secret()) return false;
  AnyMessage message = type->make();
  return !message.decode(body) || message.holds_secret();
}

std::string to_string(const AnyMessage& message) {
  const MessageType& type = message.type();
  return detail::leaves_text(type.info->name, *type.operations->table, message.address());
}

}  // namespace sbgc
