/// Moved to <sbgc/internal/own_json.hpp>.
#pragma once

#include <sbgc/internal/own_json.hpp>
