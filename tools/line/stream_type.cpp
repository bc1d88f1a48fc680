#include "line/stream_type.hpp"

#include <algorithm>
#include <array>
#include <optional>

#include <fmt/format.h>

#include <sbgc/detail/suggestions.hpp>
#include <sbgc/detail/words.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/surplus.hpp>

#include "board/connection.hpp"
#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "line/field_patterns.hpp"
#include "values/assignments.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

/// A field of the request, as its JSON names it.
struct RequestField {
  std::string path{};
  const EnumInfo* names{};
  std::int64_t value{};
};

std::vector<RequestField> request_fields(const roles::StreamRequest& request) {
  std::vector<RequestField> result;
  for_each_leaf(request, [&](const Leaf& leaf) {
    if (leaf.kind != LeafKind::integer || leaf.field.reserved) return;
    result.push_back({to_string(leaf.path), leaf.names, leaf.integer});
  });
  return result;
}

/// Returns the set of flags that chooses what samples contain: the only one in a nested field. A
/// flag set of the request itself concerns its execution.
std::optional<RequestField> content_flags(const roles::StreamRequest& request) {
  std::optional<RequestField> found;
  for (RequestField& field : request_fields(request)) {
    const bool is_nested = field.path.find('.') != std::string::npos;
    if (!is_nested || field.names == nullptr || !field.names->is_flags) continue;
    if (found) return std::nullopt;
    found = std::move(field);
  }
  return found;
}

/// Sets fields of the request, as on the command line of `sbgc send`. Throws CommandError.
void set(roles::StreamRequest& request, const std::vector<Assignment>& assignments) {
  AnyMessage message = find_message(Meta<roles::StreamRequest>::info.name)->make();
  static_cast<roles::StreamRequest&>(*message.get_if<roles::StreamRequest>()) = request;
  try {
    assign(message, assignments);
  } catch (const ValueError& error) {
    throw CommandError(error.what(), wrong_usage);
  }
  request = without_surplus(*message.get_if<roles::StreamRequest>());
}

/// Adds the configuration that the message of the stream requires, as zeros.
void complete(roles::StreamRequest& request) {
  std::array<std::uint8_t, max_body_size> body{};
  std::string last;
  while (true) {
    const WriteResult written = encode(request, std::span(body));
    if (written || written.status.field == nullptr || last == written.status.field) return;
    last = written.status.field;
    set(request, {{last, "0"}});
  }
}

std::vector<std::string> names_of(const EnumInfo& info) {
  std::vector<std::string> names;
  for (const ValueInfo& value : info.values) names.emplace_back(value.name);
  return names;
}

template <class M>
class StreamOf final : public StreamType {
 public:
  StreamOf() {
    detail::choose_stream<M>(request);
    complete(request);
  }

  const MessageInfo& info() const override { return Meta<M>::info; }

  std::vector<StreamField> fields() const override {
    // A sample of zeros has all the fields.
    const ResponsePolicy policy = response_policy(with_interval(1));
    const std::array<std::uint8_t, max_body_size> zeros{};
    const std::span<const std::uint8_t> body = std::span(zeros).first(policy.stream.size);
    M sample{};
    if constexpr (requires { typename M::Context; }) {
      Contexts contexts;
      contexts.learn(with_interval(1));
      static_cast<void>(decode(body, sample, contexts.of(sample)));
    } else {
      static_cast<void>(decode(body, sample));
    }
    std::vector<StreamField> fields;
    for_each_leaf(sample, [&](const Leaf& leaf) {
      if (leaf.field.reserved || leaf.kind == LeafKind::counter) return;
      fields.push_back({to_string(leaf.path), leaf.unit == nullptr ? "" : leaf.unit->name});
    });
    return fields;
  }

  Subscription listen(ReconnectingClient& client, SampleHandler handler) const override {
    return client.subscribe<M>(taker(std::move(handler)));
  }

  Result<Subscription> start(ReconnectingClient& client, std::chrono::milliseconds interval,
                             SampleHandler handler) const override {
    auto timed = detail::stream_request<roles::StreamRequest>(interval);
    if (!timed) return timed.error();
    return client.stream<M>(with_interval(roles::stream_interval(*timed).raw()),
                            taker(std::move(handler)));
  }

 private:
  static std::function<void(const M&)> taker(SampleHandler handler) {
    return [handler = std::move(handler)](const M& message) {
      handler([&](const std::function<void(const Leaf&)>& use) {
        for_each_leaf(message, [&](const Leaf& leaf) { use(leaf); });
      });
    };
  }

  roles::StreamRequest with_interval(std::int64_t count) const {
    roles::StreamRequest result = request;
    auto& interval = roles::stream_interval(result);
    using Interval = std::remove_reference_t<decltype(interval)>;
    interval = Interval(static_cast<typename Interval::raw_type>(count));
    return result;
  }
};

}  // namespace

std::unique_ptr<StreamType> StreamType::find(std::string_view name) {
  std::unique_ptr<StreamType> found;
  std::vector<std::string> known;
  roles::StreamMessages::for_each([&]<class M>(Type<M>) {
    const MessageInfo& info = Meta<M>::info;
    known.emplace_back(info.name);
    if (!found && (detail::is_same_word(name, info.name) || is_command_name(name, info.command))) {
      found = std::make_unique<StreamOf<M>>();
    }
  });
  if (found) return found;
  std::vector<std::string> all = known;
  roles::StreamMessages::for_each(
      [&]<class M>(Type<M>) { all.emplace_back(Meta<M>::info.command); });
  throw CommandError(fmt::format("there is no data stream of '{}'{}", clipped(name),
                                 detail::did_you_mean(
                                     detail::nearest(name, all),
                                     "there are streams of " + detail::alternatives(known, false))),
                     wrong_usage);
}

void StreamType::configure(std::string_view with) {
  while (!with.empty()) {
    const std::size_t comma = std::min(with.find(','), with.size());
    const std::string_view one = with.substr(0, comma);
    if (one.find('=') != std::string_view::npos) {
      set(request, parse_assignments({std::string(one)}));
    } else if (const auto flags = content_flags(request)) {
      set(request, {{flags->path, std::string(one)}});
    } else {
      throw CommandError(
          fmt::format("samples of {} do not depend on flags; use NAME=VALUE", info().name),
          wrong_usage);
    }
    with.remove_prefix(std::min(comma + 1, with.size()));
  }
}

void StreamType::configure_for(std::string_view patterns) {
  const auto flags = content_flags(request);
  if (!flags) return;
  // Which fields each flag adds to the sample.
  const std::vector<StreamField> always = fields();
  std::vector<std::string> paths;
  std::vector<std::int64_t> needs;
  for (const StreamField& field : always) {
    paths.push_back(field.path);
    needs.push_back(0);
  }
  for (const ValueInfo& flag : flags->names->values) {
    set(request, {{flags->path, flag.name}});
    for (const StreamField& field : fields()) {
      if (std::ranges::find(paths, field.path) != paths.end()) continue;
      paths.push_back(field.path);
      needs.push_back(flag.value);
    }
  }
  const std::vector<bool> chosen = chosen_fields(patterns, *find_message(info().name), paths);
  std::int64_t all = flags->value;
  for (std::size_t i = 0; i < paths.size(); ++i) all |= chosen[i] ? needs[i] : 0;
  set(request, {{flags->path, std::to_string(all)}});
}

std::vector<std::string> StreamType::flags() const {
  const auto found = content_flags(request);
  return found ? names_of(*found->names) : std::vector<std::string>();
}

bool StreamType::lacks_flags() const {
  const auto found = content_flags(request);
  return found && found->value == 0;
}

}  // namespace sbgc::tools
