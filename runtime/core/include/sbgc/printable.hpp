/// The types that <sbgc/fmt.hpp> and <sbgc/ostream.hpp> print.
#pragma once

namespace sbgc {

/// True for types that are printed with to_string(). <sbgc/text.hpp> specializes it for the types
/// of the protocol; other headers specialize it for their own types.
template <class T>
inline constexpr bool is_printable = false;

}  // namespace sbgc
