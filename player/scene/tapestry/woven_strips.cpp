#include "player/scene/tapestry/woven_strips.hpp"

#include <utility>

namespace vitrine::player {

WovenStrips::WovenStrips(Tapestry tapestry, SourceId first_source, std::int64_t max_tile_bytes)
    : max_tile_bytes_(max_tile_bytes), shown_(std::move(tapestry), {.first = first_source}, max_tile_bytes) {}

const TapestryStrip* WovenStrips::find(unsigned generation) const {
    if (generation == shown_.sources().generation) return &shown_;
    const bool comes = coming_ && generation == coming_->strip().sources().generation;
    return comes ? &coming_->strip() : nullptr;
}

void WovenStrips::take_over(Tapestry newer) {
    drop_coming();
    generation_ = (generation_ + 1) % TapestrySources::generations;
    coming_.emplace(TapestryStrip(
        std::move(newer), {.first = shown_.sources().first, .generation = generation_}, max_tile_bytes_));
}

void WovenStrips::drop_coming() {
    if (coming_) retire(coming_->clear());
    coming_.reset();
}

void WovenStrips::add(unsigned generation, const TileId& tile, TileZooms zooms) {
    if (generation == shown_.sources().generation)
        retire(shown_.add(tile, std::move(zooms)));
    else if (find(generation) != nullptr)
        retire(coming_->add(tile, std::move(zooms)));
}

void WovenStrips::advance(std::chrono::nanoseconds now, const TapestryBoxes& boxes, TapestryMotion& motion) {
    if (!coming_) return;
    const TapestryPlace place = strip_place(shown_.tapestry(), boxes);
    coming_->advance(now, place, motion.view());
    if (!coming_->is_there(now)) return;
    motion.move_to(strip_place(coming_->strip().tapestry(), boxes), place);
    retire(shown_.clear());
    shown_ = coming_->take();
    coming_.reset();
}

void WovenStrips::forget_tiles() {
    shown_.clear();
    if (coming_) coming_->clear();
}

void WovenStrips::clear() {
    drop_coming();
    retire(shown_.clear());
}

void WovenStrips::retire(const std::vector<SourceId>& sources) {
    retired_.insert(retired_.end(), sources.begin(), sources.end());
}

}  // namespace vitrine::player
