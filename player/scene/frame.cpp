#include "player/scene/frame.hpp"

#include <algorithm>

namespace vitrine::player {

namespace {

bool is_alike(const DrawItem& a, const DrawItem& b) {
    return a.source == b.source && a.cell == b.cell && a.zoom == b.zoom && a.share == b.share &&
           a.placement == b.placement && a.picture == b.picture && a.alpha == b.alpha &&
           a.filler_light == b.filler_light && a.slide_share == b.slide_share;
}

}  // namespace

bool looks_alike(const Frame& a, const Frame& b) {
    return a.canvas == b.canvas && a.view == b.view && a.idle == b.idle && a.is_fade == b.is_fade &&
           a.plates == b.plates && a.words == b.words && a.names == b.names &&
           std::ranges::equal(a.items, b.items, is_alike);
}

}  // namespace vitrine::player
