#include "player/scene/acts/led_folder_wall.hpp"

#include "player/scene/acts/act_of_wall.hpp"

#include <memory>
#include <utility>

namespace vitrine::player {

void LedFolderWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const Wall& seen = level(told_.seen).wall();
    const auto before = stored_files(seen.parts());
    LedShow::set_catalogue(records, hints);
    if (stored_files(seen.parts()) != before) want_act();
}

/// While the wall of a folder is not ready, the one behind it is seen.
LedFolderWall::View LedFolderWall::view() const {
    const std::optional<FolderStack::Zoom>& zoom = wall_.folders().zoom();
    const std::size_t top = wall_.folders().depth() - 1;
    const bool is_hidden = zoom && zoom->is_opening && !zoom->began;
    View view{.seen = is_hidden ? top - 1 : top};
    view.folder = level(view.seen).folder();
    if (zoom && zoom->began) view.zoom = zoom;
    if (view.seen > 0) view.stands_at = level(view.seen - 1).stands_at();
    return view;
}

bool LedFolderWall::is_changing() const {
    return told_.zoom || is_in_change(level(told_.seen).wall());
}

/// Tells of the shots that come onto the wall on top, once for each change, and of those of a wall that will
/// be the one behind, once for each folder that is closed.
void LedFolderWall::prepare_walls() {
    const std::optional<FolderStack::Zoom>& zoom = wall_.folders().zoom();
    const std::size_t depth = wall_.folders().depth();
    if (depth != std::exchange(depth_, depth)) prepared_change_ = 0;
    if (zoom && !zoom->is_opening && depth > 2 && prepared_close_ != zoom->asked) {
        prepared_close_ = zoom->asked;
        const WallParts behind = level(depth - 3).wall().parts();
        prepare({behind.shown.begin(), behind.shown.end()}, behind.canvas, style_.cells);
    }
    const WallParts parts = wall_.folders().top().wall().parts();
    const std::optional<WallChange>& change = parts.change;
    if (!change || change->phase != WallChange::Phase::waiting || change->generation == prepared_change_)
        return;
    prepared_change_ = change->generation;
    prepare(change->wall, change->canvas, style_.cells);
}

/// The part of an act for the wall of an opened folder. @param number  of that wall
ActFolder LedFolderWall::folder_behind(std::size_t number) const {
    const OpenFolder& top = level(number);
    const OpenFolder& outer = level(number - 1);
    WallAct behind = act_of(outer.wall().parts(), style_);
    ActFolder folder{.lag = outer.local(now()) - top.local(now()), .mark = top.way_back()};
    folder.box = {{0, 0}, behind.canvas};
    if (outer.stands_at()) folder.stands_from = *outer.stands_at();
    const std::optional<FolderStack::Zoom>& zoom = wall_.folders().zoom();
    if (zoom && zoom->began && number + 1 == wall_.folders().depth()) {
        folder.box = zoom->box;
        folder.is_opening = zoom->is_opening;
        folder.began = top.local(*zoom->began);
        folder.duration = style_.duration;
        if (zoom->is_opening) folder.stands_from = *folder.began + folder.lag + folder.duration;
        if (number > 1) behind.folder = folder_behind(number - 1);
    }
    folder.outer = std::make_shared<const WallAct>(std::move(behind));
    return folder;
}

/// Makes an act once a change is decided, or a way into a folder or out of it.
void LedFolderWall::make_news() {
    prepare_walls();
    View seen = view();
    const Wall& wall = level(seen.seen).wall();
    const WallParts parts = wall.parts();
    if (seen.seen != told_.seen || seen.folder != told_.folder) told_change_ = 0;
    const bool is_new = is_in_change(wall) && parts.change->generation != told_change_;
    if (!wants_act() && !is_new && seen == told_) return;
    if (is_in_change(wall)) told_change_ = parts.change->generation;
    told_ = std::move(seen);
    WallAct act = act_of(parts, style_);
    if (told_.seen > 0) act.folder = folder_behind(told_.seen);
    tell(std::move(act));
}

LiftedMoment LedFolderWall::lifted() const {
    return lifted_moment(level(told_.seen).wall().parts(), local_time());
}

}  // namespace vitrine::player
