// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Requests for the messages of data streams, for firmware that has no streams.
#pragma once

#include <sbgc/messages/realtime.hpp>

namespace sbgc::roles {

/// The request with an empty body that M answers; void if there is none.
template <class M>
struct Poll {
  using type = void;
};
template <>
struct Poll<msg::RealtimeData3> {
  using type = msg::RealtimeData;
};
template <>
struct Poll<msg::RealtimeData4> {
  using type = msg::RealtimeData4Request;
};

}  // namespace sbgc::roles
