#pragma once

#include "base/wall/wall_topic.hpp"

#include <string>
#include <string_view>

namespace vitrine {

/// A message between the boxes of a wall, as vitrine-link and its player exchange it: one JSON object in one
/// line.
struct WallMessage {
    WallTopic topic;
    bool is_retained = false;  // towards the link: the broker keeps it for boxes that come later
    std::string payload;       // one JSON object, UTF-8, without a newline
};

constexpr std::size_t max_wall_line = std::size_t{1} << 20;  // bytes of a line, and of a payload

/// The line of a message, without its newline. The payload is taken as it is.
std::string line_of(const WallMessage& message);

/// Reads a line, with all bounds. Doubles in the payload keep their value exactly.
/// @throws BrokenLine with a sentence
WallMessage wall_message(std::string_view line);

/// Checks that a payload from outside is one JSON object within the bounds, and writes it anew in one line.
/// @throws BrokenLine with a sentence
std::string checked_payload(std::string_view text);

/// The payload of a message of the kind `link`: the state of the connection.
std::string link_payload(bool is_connected, std::string_view says);

/// The state that such a payload tells. @throws BrokenLine
struct LinkState {
    bool is_connected = false;
    std::string says;  // a sentence for the operator
};

LinkState link_state(std::string_view payload);

}  // namespace vitrine
