/// Texts of values that AnyMessage::assign() reads back.
#pragma once

#include <cstdint>
#include <string>

#include <sbgc/field_type.hpp>
#include <sbgc/text/leaves.hpp>

namespace sbgc::tools {

/// Returns the shortest text that encodes the value: "10", "MODE_ANGLE", "A|B", "raw:21000".
/// `present` has the bits that a new message has. Texts of list elements have no comma.
std::string settable_text(const FieldType& type, const Leaf& leaf, std::uint64_t present,
                          bool is_element = false);

/// Returns the text of one part of a packed value.
std::string settable_part(const PartInfo& part, std::uint64_t raw);

/// Returns the flags that are set, and the other bits as a number: "A|B|0x40", or "0".
std::string settable_flags(const EnumInfo& info, std::uint32_t bits);

}  // namespace sbgc::tools
