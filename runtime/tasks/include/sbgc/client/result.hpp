/// Moved to <sbgc/result.hpp>.
#pragma once

#include <sbgc/result.hpp>
