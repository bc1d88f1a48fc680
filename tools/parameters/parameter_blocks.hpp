/// The blocks of parameters of a board.
#pragma once

#include <cstdint>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/client/parameters.hpp>

namespace sbgc::tools {

/// A message that holds parameters.
struct ParameterMessage {
  const MessageType* type = nullptr;
  std::uint8_t copies = 1;  ///< one for each profile, or only one
};

/// All of them, in the order of the specification's families.
const std::vector<ParameterMessage>& parameter_messages();

/// Returns the number of copies of such a block on the board.
std::uint8_t copy_count(const ParametersId& id);

/// True for a parameter: neither state of a board, nor reserved.
bool is_settable(const FieldInfo& field);

/// Returns the message with the values of a block of a ParameterSet.
AnyMessage message_in(const Parameters& block);

/// Puts the values of the message into `set`, as the block with this id. Errors: `invalid`.
Result<void> put_message(ParameterSet& set, const ParametersId& id, const AnyMessage& message);

}  // namespace sbgc::tools
