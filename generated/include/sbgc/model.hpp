// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The protocol that the generated headers describe, and the fingerprint of its model.
/// <sbgc/version.hpp> includes this header.
#pragma once

#include <cstdint>

namespace sbgc {

inline constexpr const char* protocol_name = "SimpleBGC Serial API";
/// The revision of the specification. The model also has the additions of later firmware, up to
/// `newest_firmware` of <sbgc/protocol.hpp>.
inline constexpr const char* protocol_revision = "0.15";
/// The date of that revision, such as 2016-07-09; "" if the specification has none.
inline constexpr const char* protocol_date = "2016-07-09";

/// Programs with equal fingerprints know the same messages, names, units and limits. Texts that
/// explain them have no effect on it. simplebgc.json has it as `fingerprint`.
inline constexpr std::uint64_t model_fingerprint = 0x501e0fbec4c8272e;

}  // namespace sbgc
