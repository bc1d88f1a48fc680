// spec/debug.yaml: debug variables.

#include "device/handlers.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/meta/debug.hpp>
#include <sbgc/validate.hpp>

#include "device/debug/debugging.hpp"

namespace sbgc::emulator {

Reaction handle(RequestContext& context, const msg::DebugVarsInfo3Request& request) {
  const std::size_t first = request.start_idx ? *request.start_idx : 0;
  return context.answer(debug_variables_info(first));
}

Reaction handle(RequestContext& context, const msg::DebugVars3Request&, MeasuredParts& parts) {
  return context.answer(debug_variable_values(parts, context.now));
}

/// The masks, then the values of the selected variables.
Reaction handle(RequestContext& context, const msg::DebugVars3RequestSelected& request,
                MeasuredParts& parts) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  const msg::DebugVars3 values = debug_variable_values(parts, context.now);
  std::vector<std::uint8_t> body;
  const auto append = [&body](std::uint32_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) {
      body.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  };
  for (const std::uint32_t mask : request.selected_mask) append(mask, sizeof mask);
  constexpr std::size_t bits = 32;
  for (std::size_t i = 0; i < values.var_value.size(); ++i) {
    const std::size_t word = i / bits;
    if (word >= request.selected_mask.size()) break;
    if (((request.selected_mask[word] >> (i % bits)) & 1U) == 0) continue;
    append(values.var_value[i].bits, size_of(values.var_value[i].type));
  }
  context.answer_body(static_cast<std::uint8_t>(msg::DebugVars3::command), body);
  return Reaction::executed;
}

Reaction handle(RequestContext& context, const msg::SetDebugPortRequest& request,
                DebugCopies& debug_copies) {
  switch (request.action) {
    case msg::DebugPortAction::stop: debug_copies.set(context.port, {}); break;
    case msg::DebugPortAction::start: debug_copies.set(context.port, request.cmd_filter); break;
    default: return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  return context.confirm();
}

}  // namespace sbgc::emulator
