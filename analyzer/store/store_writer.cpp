#include "analyzer/store/store_writer.hpp"

#include "analyzer/store/clip_writer.hpp"
#include "analyzer/store/stored_copy.hpp"
#include "analyzer/store/stored_sound.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::analyzer {

StoreWriter::StoreWriter(std::string file, const MediaInfo& media, StorePlace place)
    : file_(std::move(file)), media_(media), place_(std::move(place)) {
    if (media.kind == MediaKind::photo || !ClipWriter::has_encoder()) return;
    if (const auto form = clip_form(media, place_.clip_side))
        clips_ = std::make_unique<FilmClips>(file_, *form, place_);
}

StoreWriter::~StoreWriter() = default;

void StoreWriter::add_shot(const Shot& shot) {
    if (clips_) clips_->request_clip(shot);
}

std::vector<Shot> StoreWriter::take_placed_shots() {
    std::vector<Shot> made = clips_ ? clips_->take_made() : std::vector<Shot>{};
    known_.insert(known_.end(), made.begin(), made.end());
    return made;
}

void StoreWriter::finish(MediaRecord& record) {
    if (clips_) clips_->finish();
    take_placed_shots();
    fill_in_places(record);
    if (place_.wants_sound && record.kind == MediaKind::film) record.sound = store_sound(file_, place_);
    const auto is_placed = [](const Shot& shot) { return shot.stored.has_value(); };
    if (std::all_of(record.shots.begin(), record.shots.end(), is_placed)) return;
    const bool is_photo = record.kind == MediaKind::photo;
    const auto copy = is_photo ? store_photo(file_, media_, place_) : store_film(file_, media_, place_);
    for (Shot& shot : record.shots) {
        if (shot.stored) continue;
        shot.stored = copy;
        if (copy) shot.stored->begin = shot.begin;
    }
}

void StoreWriter::fill_in_places(MediaRecord& record) {
    for (Shot& shot : record.shots) {
        const auto found = std::find_if(known_.begin(), known_.end(),
                                        [&](const Shot& known) { return known.begin == shot.begin; });
        if (found != known_.end()) shot.stored = found->stored;
    }
}

}  // namespace vitrine::analyzer
