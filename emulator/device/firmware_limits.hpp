/// Limits messages to what the firmware of a board knows, as the model says for each field and
/// value.
#pragma once

#include <sbgc/availability.hpp>
#include <sbgc/internal/table.hpp>
#include <sbgc/message.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::emulator {

/// Limits the message with this table: removes optional fields that do not exist yet, and clears
/// fields that are still reserved and flags without a meaning. Keeps enum values, but returns true
/// if one does not exist yet.
bool limit_to(const Availability& versions, const sbgc::detail::StructTable& table, void* message);

template <Message M>
bool limit_to(const Availability& versions, M& message) {
  return limit_to(versions, sbgc::detail::table_of<M>(), &message);
}

}  // namespace sbgc::emulator
