// The library takes one path in constant expressions, without copies of memory and vectors, and
// another at run time. The files *_paths.cpp are compiled for both, see fuzz/CMakeLists.txt: the
// second time, `sbgc` is another namespace, whose functions take the path of constant expressions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

/// Each returns all results of the library for an input.
std::vector<std::uint8_t> results_at_run_time(std::span<const std::uint8_t> input);
std::vector<std::uint8_t> results_as_constant(std::span<const std::uint8_t> input);
