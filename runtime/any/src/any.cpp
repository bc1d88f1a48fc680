#include <array>
#include <cstddef>
#include <cstring>

#include <sbgc/any.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/table_access.hpp>
#include <sbgc/text.hpp>
#include <sbgc/to_json.hpp>

#include "equal_values.hpp"
#include "leaf_finder.hpp"

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
  // There, in the padding of the message, the surplus may begin.
  if (operations.takes_surplus) Tail(operations.table->tail, memory_.get()).assign({});
}

AnyMessage::AnyMessage(const AnyMessage& other) : AnyMessage(*other.type_) {
  std::memcpy(memory_.get(), other.memory_.get(), type_->memory);
}

// With surplus, these do what the functions for WithSurplus<M> do.

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
  // In place: what get_if() has returned stays valid.
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
