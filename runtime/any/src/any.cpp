#include <array>
#include <cstring>

#include <sbgc/any.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/text.hpp>

namespace sbgc {

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
  type.operations->copy(message, memory_.get());
}

AnyMessage::AnyMessage(const AnyMessage& other) : AnyMessage(*other.type_) {
  std::memcpy(memory_.get(), other.memory_.get(), type_->memory);
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

std::string AnyMessage::to_json(Secrets secrets) const {
  std::string result;
  StringOutput out(result);
  write_json(out, secrets);
  out.finish();
  return result;
}

JsonResult AnyMessage::from_json(std::string_view text) {
  AnyMessage read(*type_);
  JsonResult result =
      detail::json_result(text, [&](detail::JsonReader<detail::JsonTextSource>& reader) {
        return type_->operations->read_json(reader, read.memory_.get());
      });
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
  detail::LeafList list;
  list.text = message.type().info->name;
  message.for_each_leaf(list);
  return list.text + (list.is_empty ? "{}" : "}");
}

}  // namespace sbgc
