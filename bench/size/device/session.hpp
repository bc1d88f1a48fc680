// A small session: one request at a time, one framing.
#pragma once

#include <sbgc/session.hpp>

using Formats = sbgc::FrameFormats<sbgc::CrcTable::nibbles, sbgc::Framing::v1>;
using SmallSession = sbgc::BasicSession<{.requests = 1, .late_replies = 1, .streams = 1}, Formats>;
