#include "parameters/parameter_blocks.hpp"

#include <algorithm>

#include <sbgc/meta/all.hpp>
#include <sbgc/parameters.hpp>
#include <sbgc/text.hpp>

namespace sbgc::tools {

const std::vector<ParameterMessage>& parameter_messages() {
  static const std::vector<ParameterMessage> messages = [] {
    std::vector<ParameterMessage> result;
    ParameterMessages::for_each([&]<class M>(Type<M>) {
      result.push_back({find_message(ParametersOf<M>::name), ParametersOf<M>::copies});
    });
    return result;
  }();
  return messages;
}

std::uint8_t copy_count(const ParametersId& id) {
  const auto& all = parameter_messages();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ParameterMessage& message) {
    return id.message == message.type->info->name;
  });
  return found != all.end() ? found->copies : std::uint8_t{1};
}

AnyMessage message_in(const Parameters& block) {
  AnyMessage message = find_message(block.id.message)->make();
  static_cast<void>(message.decode(block.body));  // ParameterSet has checked this
  return message;
}

bool is_settable(const FieldInfo& field) {
  return field.role != FieldRole::copy && field.role != FieldRole::state && !field.reserved &&
         &field != &tail_field;
}

Result<void> put_message(ParameterSet& set, const ParametersId& id, const AnyMessage& message) {
  Parameters block{id, std::vector<std::uint8_t>(max_body_size)};
  const WriteResult written = message.encode(block.body);
  if (!written) return ClientError{ErrorCode::invalid, to_string(written.status)};
  block.body.resize(written.size);
  return set.put(std::move(block));
}

}  // namespace sbgc::tools
