/// The parameters of a new board.
#pragma once

#include <cstdint>

#include <sbgc/messages.hpp>
#include <sbgc/parameters.hpp>

namespace sbgc::emulator {

void set_factory_values(msg::ReadParams3& out);
void set_factory_values(msg::ReadParamsExt& out);
void set_factory_values(msg::ReadParamsExt2& out);
void set_factory_values(msg::ReadParamsExt3& out);
void set_factory_values(msg::ReadProfileNames& out);
void set_factory_values(msg::ReadExternalData& out);
inline void set_factory_values(msg::ReadAdjVarsCfg&) {}

/// The ParameterMessages of a new board. All values are assumptions: the specification gives none.
/// They suit a typical gimbal with three axes and a battery of four lithium cells, are within all
/// ranges, and use only features of board version 3.0. Reserved bytes are 0.
template <class M>
M factory_parameters(std::uint8_t copy) {
  M out;
  if constexpr (ParametersOf<M>::copies > 1) ParametersOf<M>::copy(out) = copy;
  set_factory_values(out);
  return out;
}

}  // namespace sbgc::emulator
