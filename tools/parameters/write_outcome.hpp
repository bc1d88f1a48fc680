/// The result of writing parameters, for the user.
#pragma once

#include <string>
#include <vector>

#include <sbgc/client/parameters.hpp>

namespace sbgc::tools {

/// Returns the changes that the report wants, a line for each; "" if there are none.
std::string changes_text(const WriteReport& report);

/// The same for the differences of two sets of parameters.
std::string changes_text(const std::vector<ParametersChange>& changes);

/// Returns the number of values that the report wants to change.
std::size_t change_count(const WriteReport& report);

/// Ends the command, after it has printed what the board holds now, if writing failed. Without
/// `hint` the message is that of the library.
void check_outcome(const WriteReport& report, const std::string& hint = "");

}  // namespace sbgc::tools
