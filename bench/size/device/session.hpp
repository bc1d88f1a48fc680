// A small session: one request at a time, one framing.
#pragma once

#include <cstddef>

#include <sbgc/session.hpp>

using Formats = sbgc::FrameFormats<sbgc::CrcTable::nibbles, sbgc::Framing::v1>;
template <std::size_t largest_request>
using SmallSession = sbgc::BasicSession<{.requests = 1,
                                         .late_replies = 1,
                                         .streams = 0,
                                         .body = largest_request,
                                         .optimize = sbgc::Optimize::size},
                                        Formats>;
