#include "any_message.hpp"

#include <stdexcept>

#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>

namespace sbgc::test {

namespace {

/// Collects the raw values of a message by the specification's field names.
class FieldCollector {
 public:
  template <class T>
  void members(const T& value) {
    Meta<T>::visit(value, *this);
  }
  template <class Member>
  void operator()(const FieldInfo& field, const Member& member) {
    value(member, field.spec_name);
  }
  FieldValues take() { return std::move(values_); }

 private:
  template <class T>
  void value(const T& value, const std::string& name) {
    if constexpr (std::is_enum_v<T>) {
      add(name, static_cast<std::underlying_type_t<T>>(value));
    } else if constexpr (std::is_arithmetic_v<T>) {
      add(name, static_cast<double>(value));
    } else if constexpr (RawValue<T>) {
      add(name, static_cast<double>(value.raw()));
    } else if constexpr (requires { Meta<T>::fields; }) {
      members(value);
    }
  }
  void value(Counter counter, const std::string& name) {
    add(name, static_cast<double>(counter.count));
  }
  template <class T>
  void value(const Optional<T>& optional, const std::string& name) {
    if (optional) value(*optional, name);
  }
  template <class T>
  void value(const Axes<T>& axes, const std::string& name) {
    value(axes.roll, for_index(name, "{AXIS}", "ROLL"));
    value(axes.pitch, for_index(name, "{AXIS}", "PITCH"));
    value(axes.yaw, for_index(name, "{AXIS}", "YAW"));
  }
  template <class T>
  void value(const Xyz<T>& xyz, const std::string& name) {
    value(xyz.x, for_index(name, "{XYZ}", "X"));
    value(xyz.y, for_index(name, "{XYZ}", "Y"));
    value(xyz.z, for_index(name, "{XYZ}", "Z"));
  }
  template <class T, std::size_t n>
  void value(const std::array<T, n>& array, const std::string& name) {
    for (const T& element : array) value(element, name);
  }
  template <class T, std::size_t n>
  void value(const BoundedArray<T, n>& array, const std::string& name) {
    for (const T& element : array) value(element, name);
  }

  static std::string for_index(std::string name, const std::string& place,
                               const std::string& word) {
    const auto at = name.find(place);
    if (at != std::string::npos) name.replace(at, place.size(), word);
    return name;
  }
  void add(const std::string& name, double value) { values_[name].push_back(value); }

  FieldValues values_;
};

/// Copies leaves; no lambda, as ViolationCopies.
struct LeafCopies {
  std::vector<LeafCopy>& copies;

  void operator()(const Leaf& leaf) const {
    LeafCopy copy{leaf.kind, leaf.integer, leaf.real, {}, leaf.offset, leaf.size};
    copy.bytes.assign(leaf.bytes.begin(), leaf.bytes.end());
    copy.bytes.insert(copy.bytes.end(), leaf.text.begin(), leaf.text.end());
    copies.push_back(std::move(copy));
  }
};

template <class M>
class Holder final : public AnyMessage {
 public:
  Status decode(std::span<const std::uint8_t> body, const Contexts& contexts) override {
    return decode_in(body, message_, contexts);
  }
  WriteResult encode(std::span<std::uint8_t> out) const override {
    return sbgc::encode(message_, out);
  }
  WriteResult encode_frame(std::span<std::uint8_t> out) const override {
    return sbgc::encode_frame(message_, out);
  }
  bool equals(const AnyMessage& other) const override {
    return message_ == dynamic_cast<const Holder&>(other).message_;
  }
  void teach(Contexts& contexts) const override { contexts.learn(without_surplus(message_)); }
  std::size_t tail_size() const override {
    if constexpr (requires { message_.tail; }) {
      return message_.tail.size();
    } else {
      return 0;
    }
  }
  std::vector<ViolationCopy> violations() const override { return violations_of(message_); }
  std::vector<ViolationCopy> walk(const Availability& versions) const override {
    std::vector<ViolationCopy> result;
    ViolationCopies copies{result};
    detail::Check<ViolationCopies> check(versions, copies);
    check.members(message_, nullptr);
    return result;
  }
  bool is_plainly_valid(const Availability& versions) const override {
    return detail::is_plainly_valid(message_, versions);
  }
  FieldValues spec_fields() const override {
    FieldCollector collector;
    collector.members(message_);
    return collector.take();
  }
  std::vector<LeafCopy> leaves() const override {
    std::vector<LeafCopy> result;
    for_each_leaf(message_, LeafCopies{result});
    return result;
  }
  Json to_dom() const override { return sbgc::to_dom(message_); }
  void from_dom(const Json& json) override { sbgc::from_dom(json, message_); }
  std::string to_json() const override { return sbgc::to_json(message_); }
  JsonResult from_json(std::string_view text) override { return sbgc::from_json(text, message_); }

 private:
  M message_{};
};

}  // namespace

ByteVector AnyMessage::body() const {
  ByteVector result(max_body_size);
  result.resize(encode(result).size);
  return result;
}

const std::vector<MessageType>& message_types() {
  static const std::vector<MessageType> types = [] {
    std::vector<MessageType> result;
    AllMessages::for_each([&]<class M>(Type<M>) {
      result.push_back({&Meta<M>::info, M::form, []() -> std::unique_ptr<AnyMessage> {
                          return std::make_unique<Holder<Received<M>>>();
                        }});
    });
    return result;
  }();
  return types;
}

const MessageType& message_type(const std::string& name) {
  for (const MessageType& type : message_types()) {
    if (type.info->name == name) return type;
  }
  throw std::invalid_argument("no message " + name);
}

Selected selected(Direction direction, std::uint8_t id, std::size_t size) {
  Selected result;
  result.code =
      select(direction, id, size, [&]<class M>(Type<M>) { result.info = &Meta<M>::info; });
  return result;
}

const MessageType* find_message_type(Direction direction, std::uint8_t id, std::size_t size) {
  const MessageInfo* info = nullptr;
  select_received(direction, id, size, [&]<class M>(Type<M>) { info = &Meta<M>::info; });
  return info == nullptr ? nullptr : &message_type(info->name);
}

Visited visited(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                const Contexts& contexts) {
  Visited result;
  const auto visitor = [&]<class M>(const M& message) {
    ++result.calls;
    result.info = &Meta<M>::info;
    result.fields = to_dom(message);
  };
  result.status = visit_received(id, body, direction, visitor, contexts);
  return result;
}

const Contexts& random_contexts(std::size_t index) {
  static const std::vector<Contexts> all = [] {
    RandomBodies bodies(5);
    std::vector<Contexts> result(64);
    for (Contexts& contexts : result) {
      for (const MessageType& type : message_types()) {
        const auto message = type.make();
        if (message->decode(bodies.next(type.info->min_size))) message->teach(contexts);
      }
    }
    return result;
  }();
  return all[index % all.size()];
}

}  // namespace sbgc::test
