#pragma once

#include "base/wall/wall_message.hpp"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::link {

/// The place of this box in its wall.
struct WallPlace {
    std::string wall;
    std::string box;
    bool is_leader = false;
};

/// The topics that a box listens to, as the broker has them.
std::vector<std::string> subscriptions_of(const WallPlace& place);

/// A topic as the broker has it, "vitrine/WALL/act".
std::string broker_topic(const WallPlace& place, const WallTopic& topic);

/// A message from the network, its payload not yet read.
/// @throws BrokenLine with a sentence: it is too large, or of another shape, or not for this box
WallMessage received(const WallPlace& place, std::string_view topic, std::string_view payload);

/// Reads the payload of a received message, and writes it anew.
/// @throws BrokenLine with a sentence: it is no JSON object, or of a version that this program does not know
WallMessage checked(WallMessage message);

/// Checks a message of the player on its way out. @throws BrokenLine with a sentence
void check_sent(const WallPlace& place, const WallMessage& message);

}  // namespace vitrine::link
