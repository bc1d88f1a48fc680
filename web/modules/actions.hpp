/// The actions of a page, as text.
///
///     move pitch=-30 yaw=20 speed=40    angles in degrees, speed in deg/s; both may be omitted
///     turn yaw=20 seconds=3             speeds in deg/s, for at most 60 seconds [0.5]
///     stop, release, motors on, motors off
///     menu NAME                         an action of the menu button, such as PROFILE2
#pragma once

#include <string>
#include <string_view>

#include <sbgc/time.hpp>

namespace sbgc::web {

class Client;

/// Begins the action; the client reports its end. Returns what is wrong with the text, or "".
std::string begin_action(Client& client, double id, std::string_view action, Instant now);

}  // namespace sbgc::web
