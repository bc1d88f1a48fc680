/// The order of a conversation's tasks, for a held speed.
#pragma once

#include "conversation/state.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc::detail {

inline HeldSpeed::Order order_of(const Conversation& conversation) {
  return {.begin = [conversation] { return conversation.state()->calls()->order().begin(); },
          .is_superseded =
              [conversation](TaskNumber task) {
                return conversation.state()->calls()->order().is_superseded(task);
              }};
}

}  // namespace sbgc::detail
