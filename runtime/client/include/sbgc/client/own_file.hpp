/// Moved to <sbgc/io/internal/own_file.hpp>.
#pragma once

#include <sbgc/io/internal/own_file.hpp>
