#include "player/scene/touched_film.hpp"

#include "player/scene/lifted_shot.hpp"

#include <algorithm>
#include <memory>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto growing_time = 350ms;  // until a tapped photo is as large as the screen
constexpr auto fading_time = 200ms;   // of the film into its photo and back

double share_of(std::chrono::nanoseconds time) {
    return std::clamp(std::chrono::duration<double>(time) / std::chrono::duration<double>(fading_time), 0.0,
                      1.0);
}

std::shared_ptr<const Cell> cell_of(const Box& box) {
    Cell cell;
    cell.parts.push_back(to_polygon(box));
    const Polygon& corners = cell.parts.front();
    cell.triangles = {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
    return std::make_shared<const Cell>(std::move(cell));
}

}  // namespace

void TouchedFilm::begin(const PlacedShot& photo, SourceId source, std::chrono::nanoseconds now) {
    const Polygon room =
        transformed(to_polygon(whole_picture(photo.shot)), photo.placement.scale, photo.placement.offset);
    PlacedShot film{.shot = *photo.shot.film};
    film.shot.source = source;
    const Box screen = bounding_box(room);
    film.placement = fitting(film.shot, screen, 1, screen.centre());
    film.cell = cell_of(bounding_box(
        transformed(to_polygon(whole_picture(film.shot)), film.placement.scale, film.placement.offset)));
    film.began = never;
    film_ = std::move(film);
    is_ready_ = false;
    earliest_ = now + growing_time;
    ends_ = never;
}

void TouchedFilm::end(std::chrono::nanoseconds now) {
    if (film_ && film_->began == never) film_.reset();
    ends_ = std::min(ends_, now + fading_time);
}

void TouchedFilm::source_ready(SourceId source) {
    if (film_ && film_->shot.source == source) is_ready_ = true;
}

void TouchedFilm::source_failed(SourceId source) {
    if (film_ && film_->shot.source == source) film_.reset();
}

void TouchedFilm::advance(std::chrono::nanoseconds now) {
    if (!film_) return;
    if (film_->began == never && is_ready_ && now >= earliest_) {
        film_->began = now;
        ends_ = now + film_->shot.shot.duration();
    }
    if (now >= ends_) film_.reset();
}

std::span<const PlacedShot> TouchedFilm::shots() const {
    return film_ ? std::span<const PlacedShot>(&*film_, 1) : std::span<const PlacedShot>();
}

void TouchedFilm::draw(Frame& frame) const {
    if (!film_ || film_->began == never) return;
    const double alpha = std::min(share_of(frame.time - film_->began), share_of(ends_ - frame.time));
    if (alpha <= 0) return;
    frame.items.push_back({.source = film_->shot.source,
                           .cell = film_->cell,
                           .placement = film_->placement,
                           .picture = film_->shot.picture,
                           .active = film_->shot.active,
                           .local = frame.time - film_->began,
                           .alpha = alpha});
}

}  // namespace vitrine::player
