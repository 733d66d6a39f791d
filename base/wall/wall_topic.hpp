#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vitrine {

/// The subject of a message between the boxes of a wall.
struct WallTopic {
    enum class Kind {
        act,      // of the leader, kept for boxes that come later: which shots are where, from when on
        prepare,  // of the leader, kept: the files that the next act needs
        lifted,   // of the leader: the shots that hands hold above the wall
        ready,    // of a follower, kept: it has all files of a `prepare`
        touch,    // of a follower: a visitor's hand on it
        box,      // of each box about itself, kept; `gone` is added where it is gone
        link,     // of vitrine-link to its player: the state of the connection; it never travels
    };

    Kind kind = Kind::link;
    std::string box;  // of ready, touch and box: the name of the box that sends it; of the others empty
};

/// Reads "act", "prepare", "lifted", "ready/BOX", "touch/BOX", "box/BOX" or "link". None: the text is no
/// topic.
std::optional<WallTopic> wall_topic(std::string_view text);

std::string text_of(const WallTopic& topic);

/// True if only the leader sends messages of this kind.
bool is_of_leader(WallTopic::Kind kind);

}  // namespace vitrine
