#include "player/scene/folders/opened_frame.hpp"

#include "player/scene/crossfade.hpp"
#include "player/scene/folders/back_mark.hpp"
#include "player/scene/folders/folder_zoom.hpp"

namespace vitrine::player {

namespace {

constexpr double mark_from = 0.3;  // share of the way from which on the way back appears on the inner wall
constexpr double mark_time = 0.3;  // share of the way in which it appears

}  // namespace

Frame opened_frame(const OpenedFrames& walls) {
    const double progress = eased(walls.share);
    Frame frame = zoom_frame(walls.outer, walls.top, walls.box, progress);
    if (walls.outermost != nullptr)
        draw_back_mark(frame, walls.outer_mark, *walls.outermost, eased(1 - progress / mark_from));
    const Placement at = inner_placement(walls.outer.canvas, walls.box, progress);
    draw_back_mark(frame, {walls.mark.min * at.scale + at.offset, walls.mark.max * at.scale + at.offset},
                   walls.outer, eased((progress - mark_from) / mark_time));
    return frame;
}

}  // namespace vitrine::player
