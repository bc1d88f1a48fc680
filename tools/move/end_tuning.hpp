/// The end of the automatic tuning, during which the board shakes the camera.
#pragma once

#include <sbgc/client/client.hpp>

namespace sbgc::tools {

/// True if live data say that the board tunes. Early firmware does not say it, and has no such
/// data.
Result<bool> is_tuning(Client& client);

/// Ends the tuning, and makes sure of it. Parameters that the board has stored already stay.
Result<void> end_tuning(Client& client);

}  // namespace sbgc::tools
