/// Moved to <sbgc/error.hpp>.
#pragma once

#include <sbgc/error.hpp>
