#pragma once

#include "base/geometry/box.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace vitrine::player {

/// The picture of a line of text on its plate.
struct WordPicture {
    int width = 0;  // px
    int height = 0;
    std::vector<std::byte> rgba;  // rows from the top, opacity not multiplied in
};

/// Words over the pictures of a frame.
struct WordItem {
    std::shared_ptr<const WordPicture> picture;  // shared by all frames that show it
    Box place;                                   // canvas px
    double alpha = 1;                            // opacity of the whole, [0, 1]
    bool is_sharp = false;                       // its pixels are drawn as squares

    bool operator==(const WordItem&) const = default;
};

}  // namespace vitrine::player
