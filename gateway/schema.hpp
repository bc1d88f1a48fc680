/// The JSON Schema of what a gateway says and understands.
#pragma once

#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Returns a JSON Schema (draft 2020-12) with a definition for each kind of payload:
/// "command.TASK", "telemetry.MESSAGE", "result", "state", "event" and "gateway_state". The
/// messages are those of the model.
Json gateway_schema();

}  // namespace sbgc::tools
