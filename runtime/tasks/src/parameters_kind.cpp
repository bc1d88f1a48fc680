#include "parameters_kind.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include <sbgc/explain.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/text.hpp>

namespace sbgc::detail {
namespace {

/// Returns a mask with 1 bits in the fields of this role.
std::vector<std::uint8_t> mask_of(const MessageType& type, FieldRole role) {
  std::vector<std::uint8_t> mask;
  type.make().for_each_leaf([&](const Leaf& leaf) {
    mask.resize(leaf.offset + leaf.size, leaf.field.role == role ? 0xFF : 0x00);
  });
  return mask;
}

/// Returns the first request that the board supports; null if there is none.
const MessageType* supported(const std::vector<const MessageType*>& requests,
                             const Availability& versions) {
  const auto found = std::find_if(
      requests.begin(), requests.end(),
      [&](const MessageType* request) { return objection_to(*request->info, versions).empty(); });
  return found != requests.end() ? *found : nullptr;
}

template <class... Ms>
std::vector<const MessageType*> types_in(TypeList<Ms...>) {
  return {find_message(Meta<Ms>::info.name)...};
}

/// A value as text, for comparison.
struct LeafText {
  std::string path;
  std::string raw;
  std::string meaning;  ///< for example "-30 deg" or "FOLLOW_MODE_FC"; may be ""
};

/// Returns the values that are parameters. Bytes without a meaning become separate numbers.
std::vector<LeafText> leaf_texts(const AnyMessage& message, const Availability& versions) {
  std::vector<LeafText> texts;
  auto add = [&](const Leaf& leaf) {
    const FieldRole role = leaf.field.role;
    if (role == FieldRole::copy || role == FieldRole::state) return;
    if (leaf.kind == LeafKind::counter) return;
    if (leaf.kind != LeafKind::bytes) {
      texts.push_back({to_string(leaf.path), raw_text(leaf), meaning_text(leaf)});
      return;
    }
    for (std::size_t i = 0; i < leaf.bytes.size(); ++i) {
      texts.push_back({to_string(FieldPath{&leaf.path, "", i}), std::to_string(leaf.bytes[i]), ""});
    }
  };
  message.for_each_leaf(add, versions);
  return texts;
}

template <class M>
ParametersKind parameters_kind_of() {
  const MessageType& type = *find_message(ParametersOf<M>::name);
  return {
      .type = &type,
      .copies = ParametersOf<M>::copies,
      .state_mask = mask_of(type, FieldRole::state),
      .general_mask = mask_of(type, FieldRole::general),
      .readers = types_in(typename ParametersOf<M>::Readers{}),
      .writers = types_in(typename ParametersOf<M>::Writers{}),
  };
}

/// Returns a byte of the mask; 0 past its end.
std::uint8_t at(const std::vector<std::uint8_t>& mask, std::size_t index) {
  return index < mask.size() ? mask[index] : std::uint8_t{0};
}

/// Takes the bits of `other` where the mask has 1 bits, and those of `byte` elsewhere.
std::uint8_t mixed(std::uint8_t byte, std::uint8_t other, std::uint8_t mask) {
  return static_cast<std::uint8_t>((byte & ~mask) | (other & mask));
}

}  // namespace

const std::vector<ParametersKind>& parameters_kinds() {
  static const std::vector<ParametersKind> kinds = [] {
    std::vector<ParametersKind> result;
    ParameterMessages::for_each(
        [&]<class M>(Type<M>) { result.push_back(parameters_kind_of<M>()); });
    return result;
  }();
  return kinds;
}

std::string ParametersKind::problem(Body body, std::uint8_t copy) const {
  AnyMessage message = type->make();
  if (const Status status = message.decode(body); !status) {
    return fmt::format("{} bytes cannot be a {}: {}", body.size(), name(), text(status.code));
  }
  if (copy >= copies) return fmt::format("there is no copy {} of {}", copy, name());
  std::string result;
  message.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.field.role != FieldRole::copy || leaf.integer == copy) return;
    result = fmt::format("the body is of profile {}", leaf.integer + 1);
  });
  return result;
}

bool ParametersKind::is_readable(const Availability& versions) const {
  return supported(readers, versions) != nullptr;
}

bool ParametersKind::is_writable(const Availability& versions) const {
  return supported(writers, versions) != nullptr;
}

Task<Result<std::vector<std::uint8_t>>> ParametersKind::read(std::uint8_t copy,
                                                             CallOptions options) const {
  const TaskMachine& task = co_await tasks::this_task();
  const MessageType* const reader = supported(readers, task.identity().versions());
  if (reader == nullptr) {
    co_return ClientError{ErrorCode::unsupported,
                          fmt::format("this board cannot report {}", name())};
  }
  AnyMessage request = reader->make();
  const StructTable& table = *reader->operations->table;
  for (const FieldInfo& field : std::span(table.fields, table.slots.size())) {
    if (field.role == FieldRole::copy) request.set(field.name, std::int64_t{copy});
  }
  const auto answer = co_await tasks::call(request, options);
  if (!answer) co_return answer.error();
  std::vector<std::uint8_t> body(max_body_size);
  body.resize(*answer ? (*answer)->encode(body).size : 0);
  // The answer of an older request has the same fields, but its own id.
  const bool is_it = *answer && (&(*answer)->type() == type || type->make().decode(body));
  if (is_it) co_return body;
  co_return ClientError{ErrorCode::bad_response, fmt::format("the board sent no {}", name())};
}

Task<Result<bool>> ParametersKind::write(std::vector<std::uint8_t> body,
                                         CallOptions options) const {
  const TaskMachine& task = co_await tasks::this_task();
  const MessageType* const writer = supported(writers, task.identity().versions());
  if (writer == nullptr) {
    co_return ClientError{ErrorCode::unsupported,
                          fmt::format("this board cannot store {}", name())};
  }
  AnyMessage request = writer->make();
  static_cast<void>(request.decode(body));  // problem() has checked this
  const Result<Reply> reply = co_await tasks::transact(request, options);
  if (!reply) co_return reply.error();
  co_return reply->kind != ReplyKind::unconfirmed;
}

AnyMessage ParametersKind::message(Body body) const {
  AnyMessage result = type->make();
  static_cast<void>(result.decode(body));
  return result;
}

const ParametersKind* find_parameters_kind(std::string_view name) {
  const auto& kinds = parameters_kinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(),
                                  [&](const auto& kind) { return kind.name() == name; });
  return found != kinds.end() ? &*found : nullptr;
}

std::vector<ParametersId> readable_parameters(const Availability& versions) {
  std::vector<ParametersId> result;
  for (const ParametersKind& kind : parameters_kinds()) {
    if (!kind.is_readable(versions)) continue;
    for (std::uint8_t copy = 0; copy < kind.copies; ++copy) {
      result.push_back({kind.name(), copy});
    }
  }
  return result;
}

std::optional<std::vector<std::uint8_t>> merged(const ParametersKind& kind, Body wanted,
                                                Body present) {
  if (wanted.size() > present.size()) return std::nullopt;
  std::vector<std::uint8_t> result(present.begin(), present.end());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    result[i] = mixed(wanted[i], present[i], at(kind.state_mask, i));
  }
  return result;
}

bool are_equal(const ParametersKind& kind, Body a, Body b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (((a[i] ^ b[i]) & ~at(kind.state_mask, i)) != 0) return false;
  }
  return true;
}

std::vector<FieldChange> field_changes(const ParametersKind& kind, Body before, Body after,
                                       const Availability& versions,
                                       const Availability& versions_after) {
  std::vector<FieldChange> changes;
  std::vector<LeafText> now = leaf_texts(kind.message(after), versions_after);
  std::unordered_map<std::string_view, const LeafText*> by_path;
  for (const LeafText& leaf : now) by_path.emplace(leaf.path, &leaf);
  for (LeafText& leaf : leaf_texts(kind.message(before), versions)) {
    const auto found = by_path.find(leaf.path);
    if (found == by_path.end()) {
      changes.push_back({leaf.path, leaf.raw, "", leaf.meaning, ""});
      continue;
    }
    const LeafText& other = *found->second;
    if (other.raw != leaf.raw) {
      changes.push_back({leaf.path, leaf.raw, other.raw, leaf.meaning, other.meaning});
    }
    by_path.erase(found);
  }
  for (const LeafText& leaf : now) {
    if (by_path.contains(leaf.path)) {
      changes.push_back({leaf.path, "", leaf.raw, "", leaf.meaning});
    }
  }
  return changes;
}

std::vector<FieldChange> general_changes(const ParametersKind& kind, Body before, Body after,
                                         const Availability& versions) {
  std::vector<std::uint8_t> changed(before.begin(), before.end());
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    changed[i] = mixed(before[i], after[i], at(kind.general_mask, i));
  }
  return field_changes(kind, before, changed, versions, versions);
}

}  // namespace sbgc::detail
