/// Which types <sbgc/fmt.hpp> and <sbgc/ostream.hpp> print.
#pragma once

namespace sbgc {

/// True for the types that are printed as to_string() writes them. <sbgc/text.hpp> says so of what
/// the protocol consists of; other headers say so of their own types.
template <class T>
inline constexpr bool is_printable = false;

}  // namespace sbgc
