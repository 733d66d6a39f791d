#include "player/scene/acts/led_wall.hpp"

namespace vitrine::player {

void LedWall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const auto before = stored_files(wall_.parts());
    LedShow::set_catalogue(records, hints);
    if (stored_files(wall_.parts()) != before) want_act();
}

/// Tells of the shots that come, once for each change, and makes an act once the change is decided.
void LedWall::make_news() {
    const WallParts parts = wall_.parts();
    const std::optional<WallChange>& change = parts.change;
    if (change && change->phase == WallChange::Phase::waiting && change->generation != prepared_change_) {
        prepared_change_ = change->generation;
        prepare(change->wall, change->canvas, style_.cells);
    }
    const bool is_seen = change && change->is_fading();
    const bool is_new = is_seen && change->generation != told_change_;
    if (!wants_act() && !is_new) return;
    if (is_seen) told_change_ = change->generation;
    tell(act_of(parts, style_));
}

}  // namespace vitrine::player
