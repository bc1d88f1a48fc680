#include "messages.hpp"

#include <stdexcept>

#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

namespace sbgc::test {

namespace {

/// Returns "ROLL" for an axis of the gimbal or of space; "" for any other name.
std::string axis_word(std::string_view name) {
  for (const char* const word : {"ROLL", "PITCH", "YAW", "X", "Y", "Z"}) {
    std::string lower(word);
    for (char& c : lower) c = static_cast<char>(c - 'A' + 'a');
    if (name == lower) return word;
  }
  return "";
}

/// Calls `use` with the message as its own type.
template <class Any, class Use>
void with_message(Any& message, const Use& use) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if (auto* const found = message.template get_if<M>()) use(*found);
  });
}

}  // namespace

std::vector<ViolationCopy> violations_of(const AnyMessage& message, const Availability& versions) {
  std::vector<ViolationCopy> result;
  message.validate(versions, ViolationCopies{result});
  return result;
}

bool passes_quick_check(const AnyMessage& message, const Availability& versions) {
  bool result = false;
  with_message(message,
               [&](const auto& value) { result = detail::is_plainly_valid(value, versions); });
  return result;
}

std::vector<LeafCopy> leaves_of(const AnyMessage& message) {
  std::vector<LeafCopy> result;
  message.for_each_leaf([&](const Leaf& leaf) {
    LeafCopy copy{leaf.kind, leaf.integer, leaf.real, {}, leaf.offset, leaf.size};
    copy.bytes.assign(leaf.bytes.begin(), leaf.bytes.end());
    copy.bytes.insert(copy.bytes.end(), leaf.text.begin(), leaf.text.end());
    result.push_back(std::move(copy));
  });
  return result;
}

FieldValues spec_fields(const AnyMessage& message) {
  FieldValues result;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind == LeafKind::bytes || leaf.kind == LeafKind::text) return;
    std::string name = leaf.field.spec_name;
    const std::size_t open = name.find('{');
    if (open != std::string::npos) {
      // The innermost name of the path that is no field: an axis.
      const FieldPath* at = &leaf.path;
      while (at != nullptr && axis_word(at->name).empty()) at = at->parent;
      if (at != nullptr) name.replace(open, name.find('}') + 1 - open, axis_word(at->name));
    }
    result[name].push_back(leaf.kind == LeafKind::real ? leaf.real
                                                       : static_cast<double>(leaf.integer));
  });
  return result;
}

ByteVector encoded_body(const AnyMessage& message) {
  ByteVector result(max_body_size);
  result.resize(message.encode(result).size);
  return result;
}

WriteResult typed_frame(const AnyMessage& message, std::span<std::uint8_t> out) {
  WriteResult result;
  with_message(message, [&](const auto& value) { result = sbgc::encode_frame(value, out); });
  return result;
}

Json dom_of(const AnyMessage& message) {
  Json result;
  with_message(message, [&](const auto& value) { result = sbgc::to_dom(value, Secrets::shown); });
  return result;
}

void read_dom(const Json& json, AnyMessage& message) {
  with_message(message, [&](auto& value) { sbgc::from_dom(json, value); });
}

const MessageType& message_type(const std::string& name) {
  if (const MessageType* const type = find_message(name)) return *type;
  throw std::invalid_argument("no message " + name);
}

Selected selected(Direction direction, std::uint8_t id, std::size_t size) {
  Selected result;
  result.code =
      select(direction, id, size, [&]<class M>(Type<M>) { result.info = &Meta<M>::info; });
  return result;
}

Visited visited(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                const Contexts& contexts) {
  Visited result;
  const auto visitor = [&]<class M>(const M& message) {
    ++result.calls;
    result.info = &Meta<M>::info;
    result.fields = sbgc::to_dom(message);
  };
  result.status = visit_received(id, body, direction, visitor, contexts);
  return result;
}

const Contexts& random_contexts(std::size_t index) {
  static const std::vector<Contexts> all = [] {
    RandomBodies bodies(5);
    std::vector<Contexts> result(64);
    for (Contexts& contexts : result) {
      for (const MessageType* const type : message_types()) {
        AnyMessage message = type->make();
        if (message.decode(bodies.next(type->info->min_size))) message.teach(contexts);
      }
    }
    return result;
  }();
  return all[index % all.size()];
}

}  // namespace sbgc::test
