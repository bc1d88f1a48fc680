/// The parameters of a new board.
#pragma once

#include <cstdint>

#include <sbgc/messages.hpp>
#include <sbgc/parameters.hpp>

namespace sbgc::emulator {

/// The ParameterMessages of a new board. All values are assumptions: the specification gives none.
/// They suit a typical gimbal with three axes and a battery of four lithium cells, are within all
/// ranges, and use only features of board version 3.0. Reserved bytes are 0.
template <class M>
M factory_parameters(std::uint8_t copy);

template <>
msg::ReadParams3 factory_parameters(std::uint8_t copy);
template <>
msg::ReadParamsExt factory_parameters(std::uint8_t copy);
template <>
msg::ReadParamsExt2 factory_parameters(std::uint8_t copy);
template <>
msg::ReadParamsExt3 factory_parameters(std::uint8_t copy);
template <>
msg::ReadProfileNames factory_parameters(std::uint8_t copy);
template <>
msg::ReadAdjVarsCfg factory_parameters(std::uint8_t copy);
template <>
msg::ReadExternalData factory_parameters(std::uint8_t copy);

}  // namespace sbgc::emulator
