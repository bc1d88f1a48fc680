/// Moved to <sbgc/io/internal/atomic_file.hpp>.
#pragma once

#include <sbgc/io/internal/atomic_file.hpp>
