/// JSON of this project.
#pragma once

#include <string_view>

#include <sbgc/client/result.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc::detail {

/// Parses a JSON object with the `format`. Fails with ErrorCode::bad_file if it is anything else
/// than `what`, such as "an sbgc backup".
Result<Json> parse_own_json(std::string_view text, const char* format, const char* what);

}  // namespace sbgc::detail
