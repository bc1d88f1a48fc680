/// Messages as JSON text and back: to_json(message), from_json(text, message). <sbgc/json_dom.hpp>
/// converts between messages and the values of nlohmann_json.
#pragma once

#include <sbgc/from_json.hpp>
#include <sbgc/to_json.hpp>
