#pragma once

#include "base/wall/wall_topic.hpp"

#include <optional>
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

/// The "version" of a payload. None: it has none, or none that is a small whole number. @throws BrokenLine
std::optional<int> payload_version(std::string_view payload);

/// The tapestry that a payload of the kind `lifted` tells of: another text for each film, and each time that
/// more of it is woven. Empty: none. @throws BrokenLine
std::string told_tapestry(std::string_view payload);

/// The payload of a message of the kind `link`: the state of the connection.
std::string link_payload(bool is_connected, std::string_view says);

/// The state of the connection to the other boxes.
struct LinkState {
    bool is_connected = false;
    std::string says;  // a sentence for the operator
};

/// The state that a payload of the kind `link` tells. @throws BrokenLine
LinkState link_state(std::string_view payload);

}  // namespace vitrine
