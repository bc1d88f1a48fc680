#include "parameters_kind.hpp"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <unordered_map>

#include <fmt/format.h>

#include <sbgc/message.hpp>
#include <sbgc/text.hpp>

namespace sbgc::detail {
namespace {

template <class M>
std::vector<std::uint8_t> bytes_of(const M& message) {
  std::vector<std::uint8_t> bytes(max_body_size);
  bytes.resize(encode(message, bytes).size);
  return bytes;
}

template <class M>
M message_of(Body body) {
  M message{};
  static_cast<void>(decode(body, message));  // problem() has checked this
  return message;
}

/// Sets all bits of a number, an enum or a quantity.
template <class T>
void set_all_bits(T& value) {
  if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(static_cast<std::underlying_type_t<T>>(~0U));
  } else if constexpr (std::is_integral_v<T>) {
    value = static_cast<T>(~0U);
  } else {
    static_assert(RawValue<T>, "a field with a role is a number");
    value = T(static_cast<typename T::raw_type>(~0U));
  }
}

/// Returns a body of M with 1 bits in the fields of this role.
template <class M>
std::vector<std::uint8_t> mask_of(FieldRole role) {
  M marked{};
  Meta<M>::visit(marked, [role](const FieldInfo& field, auto&& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    constexpr bool is_number =
        std::is_enum_v<Member> || std::is_integral_v<Member> || RawValue<Member>;
    if constexpr (is_number) {
      if (field.role == role) set_all_bits(member);
    }
  });
  return bytes_of(marked);
}

/// Calls `use(Type<Request>{})` for the first request that the board supports.
template <class... Requests, class Use>
bool with_supported(TypeList<Requests...>, const Availability& versions, Use&& use) {
  return ((is_supported<Requests>(versions) && (use(Type<Requests>{}), true)) || ...);
}

template <class M, class Request>
Task<Result<std::vector<std::uint8_t>>> read_with(std::uint8_t copy, CallOptions options) {
  Request request{};
  if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(request) = copy;
  const Result<M> answer = co_await tasks::call(request, options);
  if (!answer) co_return answer.error();
  co_return bytes_of(*answer);
}

template <class M>
Task<Result<std::vector<std::uint8_t>>> read_parameters_of(std::uint8_t copy, CallOptions options) {
  const TaskMachine& task = co_await tasks::this_task();
  std::optional<Task<Result<std::vector<std::uint8_t>>>> reading;
  with_supported(
      typename ParametersOf<M>::Readers{}, task.identity().versions(),
      [&]<class Request>(Type<Request>) { reading.emplace(read_with<M, Request>(copy, options)); });
  if (reading) co_return co_await std::move(*reading);
  co_return ClientError{ErrorCode::unsupported,
                        fmt::format("this board cannot report {}", Meta<M>::info.name)};
}

template <class M, class Request>
Task<Result<void>> write_with(std::vector<std::uint8_t> body, CallOptions options) {
  co_return co_await tasks::call(Request{message_of<M>(body)}, options);
}

template <class M>
Task<Result<void>> write_parameters_of(std::vector<std::uint8_t> body, CallOptions options) {
  const TaskMachine& task = co_await tasks::this_task();
  std::optional<Task<Result<void>>> writing;
  with_supported(typename ParametersOf<M>::Writers{}, task.identity().versions(),
                 [&]<class Request>(Type<Request>) {
                   writing.emplace(write_with<M, Request>(body, options));
                 });
  if (writing) co_return co_await std::move(*writing);
  co_return ClientError{ErrorCode::unsupported,
                        fmt::format("this board cannot store {}", Meta<M>::info.name)};
}

template <class M>
std::string problem(Body body, std::uint8_t copy) {
  M message{};
  if (const Status status = decode(body, message); !status) {
    return fmt::format("{} bytes cannot be a {}: {}", body.size(), Meta<M>::info.name,
                       text(status.code));
  }
  if (copy >= ParametersOf<M>::copies) {
    return fmt::format("there is no copy {} of {}", copy, Meta<M>::info.name);
  }
  if constexpr (ParametersOf<M>::copies > 1) {
    const int said = ParametersOf<M>::copy(message);
    if (said != copy) return fmt::format("the body is of profile {}", said + 1);
  }
  return "";
}

using ViolationReport = std::function<void(const std::vector<std::string>&, const std::string&)>;

/// Returns the paths of the values that are to blame: that of the violation, and of the field that
/// it must not exceed.
std::vector<std::string> paths_of(const Violation& violation) {
  std::vector<std::string> paths{to_string(violation.path)};
  if (violation.other == nullptr) return paths;
  std::string other = paths.front();
  const std::size_t at = other.rfind(violation.field.name);
  other.replace(at, std::string_view(violation.field.name).size(), violation.other->name);
  paths.push_back(std::move(other));
  return paths;
}

template <class M>
void violations(Body body, const Availability& versions, const ViolationReport& report) {
  validate(message_of<M>(body), versions,
           [&](const Violation& violation) { report(paths_of(violation), to_string(violation)); });
}

template <class M>
ParametersKind parameters_kind_of() {
  return {
      .name = Meta<M>::info.name,
      .summary = Meta<M>::info.summary,
      .copies = ParametersOf<M>::copies,
      .state_mask = mask_of<M>(FieldRole::state),
      .general_mask = mask_of<M>(FieldRole::general),
      .is_readable =
          [](const Availability& versions) {
            return with_supported(typename ParametersOf<M>::Readers{}, versions, [](auto) {});
          },
      .is_writable =
          [](const Availability& versions) {
            return with_supported(typename ParametersOf<M>::Writers{}, versions, [](auto) {});
          },
      .read = read_parameters_of<M>,
      .write = write_parameters_of<M>,
      .problem = problem<M>,
      .leaves = [](Body body) { return leaf_texts(message_of<M>(body)); },
      .to_json = [](Body body) { return to_dom(message_of<M>(body)); },
      .violations = violations<M>,
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

const ParametersKind* find_parameters_kind(std::string_view name) {
  const auto& kinds = parameters_kinds();
  const auto found = std::ranges::find(kinds, name, &ParametersKind::name);
  return found != kinds.end() ? &*found : nullptr;
}

std::vector<ParametersId> readable_parameters(const Availability& versions) {
  std::vector<ParametersId> result;
  for (const ParametersKind& kind : parameters_kinds()) {
    if (!kind.is_readable(versions)) continue;
    for (std::uint8_t copy = 0; copy < kind.copies; ++copy) {
      result.push_back({std::string(kind.name), copy});
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

std::vector<FieldChange> field_changes(const ParametersKind& kind, Body before, Body after) {
  std::vector<FieldChange> changes;
  std::vector<LeafText> now = kind.leaves(after);
  std::unordered_map<std::string_view, const LeafText*> by_path;
  for (const LeafText& leaf : now) by_path.emplace(leaf.path, &leaf);
  for (LeafText& leaf : kind.leaves(before)) {
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

std::vector<FieldChange> general_changes(const ParametersKind& kind, Body before, Body after) {
  std::vector<std::uint8_t> changed(before.begin(), before.end());
  for (std::size_t i = 0; i < std::min(before.size(), after.size()); ++i) {
    changed[i] = mixed(before[i], after[i], at(kind.general_mask, i));
  }
  return field_changes(kind, before, changed);
}

}  // namespace sbgc::detail
