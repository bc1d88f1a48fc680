#include "frames/stream_type.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/surplus.hpp>

#include "command/command_error.hpp"
#include "command/wording.hpp"
#include "frames/command_lookup.hpp"
#include "values/assignments.hpp"
#include "values/complete_message.hpp"
#include "values/field_patterns.hpp"
#include "values/message_names.hpp"

namespace sbgc::tools {

namespace {

/// A field of the request, named as in its JSON.
struct RequestField {
  std::string path{};
  const EnumInfo* names{};
  std::int64_t value{};
};

std::vector<RequestField> request_fields(const AnyMessage& request) {
  std::vector<RequestField> result;
  request.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.kind != LeafKind::integer || leaf.field.reserved) return;
    result.push_back({to_string(leaf.path), leaf.names, leaf.integer});
  });
  return result;
}

/// Returns the set of flags that selects the contents of samples: the only one in a nested field. A
/// flag set of the request itself concerns its execution.
std::optional<RequestField> content_flags(const AnyMessage& request) {
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
void set(AnyMessage& request, const std::vector<Assignment>& assignments) {
  try {
    assign(request, assignments);
  } catch (const ValueError& error) {
    throw CommandError(error.what(), wrong_usage);
  }
}

std::vector<std::string> names_of(const EnumInfo& info) {
  std::vector<std::string> names;
  for (const ValueInfo& value : info.values) names.emplace_back(value.name);
  return names;
}

std::function<void(const AnyMessage&)> taker(SampleHandler handler) {
  return [handler = std::move(handler)](const AnyMessage& message) {
    handler([&](const std::function<void(const Leaf&)>& use) {
      message.for_each_leaf([&](const Leaf& leaf) { use(leaf); });
    });
  };
}

}  // namespace

StreamType::StreamType(const MessageType& type)
    : type_(&type), request_(detail::message_type<roles::StreamRequest>()) {
  auto& command = roles::stream_command(*request_.get_if<roles::StreamRequest>());
  command = static_cast<std::remove_reference_t<decltype(command)>>(type.info->id);
  add_demanded(request_);
}

StreamType StreamType::find(std::string_view name) {
  std::vector<std::string> known;
  std::vector<std::string> commands;
  for (const MessageType* const type : stream_types()) {
    const MessageInfo& info = *type->info;
    const bool is_it = detail::is_same_word(name, info.name) ||
                       is_command_name(name, info.command) || parse_command_id(name) == info.id;
    if (is_it) return StreamType(*type);
    known.emplace_back(info.name);
    commands.emplace_back(info.command);
  }
  std::vector<std::string> all = known;
  all.insert(all.end(), commands.begin(), commands.end());
  throw CommandError(fmt::format("there is no data stream of '{}'{}", clipped(name),
                                 detail::did_you_mean(
                                     detail::nearest(name, all),
                                     "there are streams of " + detail::alternatives(known, false))),
                     wrong_usage);
}

Subscription StreamType::listen(Client& client, SampleHandler handler) const {
  return client.subscribe(*type_, taker(std::move(handler)));
}

roles::StreamRequest StreamType::with_interval(std::int64_t count) const {
  roles::StreamRequest result = without_surplus(*request_.get_if<roles::StreamRequest>());
  auto& interval = roles::stream_interval(result);
  using Interval = std::remove_reference_t<decltype(interval)>;
  interval = Interval(static_cast<typename Interval::raw_type>(count));
  return result;
}

Result<roles::StreamRequest> StreamType::request(std::chrono::milliseconds interval) const {
  auto timed = detail::stream_request<roles::StreamRequest>(interval);
  if (!timed) return timed.error();
  return with_interval(roles::stream_interval(*timed).raw());
}

std::vector<StreamField> StreamType::fields() const {
  // A sample of zeros has all the fields.
  const roles::StreamRequest request = with_interval(1);
  const std::array<std::uint8_t, max_body_size> zeros{};
  Contexts contexts;
  contexts.learn(request);
  AnyMessage sample = type_->make();
  static_cast<void>(
      sample.decode(std::span(zeros).first(response_policy(request).stream.size), contexts));
  std::vector<StreamField> fields;
  sample.for_each_leaf([&](const Leaf& leaf) {
    if (leaf.field.reserved || leaf.kind == LeafKind::counter) return;
    fields.push_back({to_string(leaf.path), leaf.unit == nullptr ? "" : leaf.unit->name});
  });
  return fields;
}

Result<Subscription> StreamType::start(Client& client, std::chrono::milliseconds interval,
                                       SampleHandler handler) const {
  const auto asked = request(interval);
  if (!asked) return asked.error();
  return client.stream(*type_, *asked, taker(std::move(handler)));
}

void StreamType::async_start(AsyncClient& client, std::chrono::milliseconds interval,
                             std::function<void(const AnyMessage&)> handler,
                             std::function<void(Result<Subscription>)> done) const {
  const auto asked = request(interval);
  if (!asked) return done(asked.error());
  client.async_stream(*type_, *asked, std::move(handler), CallOptions(), std::move(done));
}

void StreamType::configure(std::string_view with) {
  while (!with.empty()) {
    const std::size_t comma = std::min(with.find(','), with.size());
    const std::string_view one = with.substr(0, comma);
    if (one.find('=') != std::string_view::npos) {
      set(request_, parse_assignments({std::string(one)}));
    } else if (const auto flags = content_flags(request_)) {
      set(request_, {{flags->path, std::string(one)}});
    } else {
      throw CommandError(
          fmt::format("samples of {} do not depend on flags; use NAME=VALUE", info().name),
          wrong_usage);
    }
    with.remove_prefix(std::min(comma + 1, with.size()));
  }
}

void StreamType::configure_for(std::string_view patterns) {
  const auto flags = content_flags(request_);
  if (!flags) return;
  // The fields that each flag adds to the sample.
  const std::vector<StreamField> always = fields();
  std::vector<std::string> paths;
  std::vector<std::int64_t> needs;
  for (const StreamField& field : always) {
    paths.push_back(field.path);
    needs.push_back(0);
  }
  for (const ValueInfo& flag : flags->names->values) {
    set(request_, {{flags->path, flag.name}});
    for (const StreamField& field : fields()) {
      if (std::ranges::find(paths, field.path) != paths.end()) continue;
      paths.push_back(field.path);
      needs.push_back(flag.value);
    }
  }
  const std::vector<bool> chosen = chosen_fields(patterns, *type_, paths);
  std::int64_t all = flags->value;
  for (std::size_t i = 0; i < paths.size(); ++i) all |= chosen[i] ? needs[i] : 0;
  set(request_, {{flags->path, std::to_string(all)}});
}

std::vector<std::string> StreamType::flags() const {
  const auto found = content_flags(request_);
  return found ? names_of(*found->names) : std::vector<std::string>();
}

bool StreamType::lacks_flags() const {
  const auto found = content_flags(request_);
  return found && found->value == 0;
}

roles::StreamRequest raw_stream_request(unsigned id, std::string_view config,
                                        std::chrono::milliseconds interval) {
  auto made = detail::stream_request<roles::StreamRequest>(interval);
  if (!made) throw CommandError(made.error().message);
  roles::StreamRequest request = *std::move(made);
  const auto command = static_cast<std::uint8_t>(id);
  roles::stream_command(request) = static_cast<msg::CommandFromBoard>(command);
  const auto bytes = detail::from_hex(config);
  auto& place = request.config.rest;
  if (!bytes || !place.resize(bytes->size())) {
    throw CommandError(
        fmt::format("the configuration of stream {} is up to {} pairs of hex digits, such as 0e45",
                    id, place.capacity()),
        wrong_usage);
  }
  std::ranges::copy(*bytes, place.begin());
  std::array<std::uint8_t, max_body_size> body{};
  if (!encode(request, std::span(body))) {
    throw CommandError(fmt::format("the stream of {} has a name, and flags that choose its "
                                   "contents: {}",
                                   id, command_name(command, Direction::from_board)),
                       wrong_usage);
  }
  return request;
}

}  // namespace sbgc::tools
