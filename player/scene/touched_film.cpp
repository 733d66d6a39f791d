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

void draw_film(Frame& frame, const FilmMoment& film) {
    if (film.began == never) return;
    const double alpha = std::min(share_of(frame.time - film.began), share_of(film.ends - frame.time));
    if (alpha <= 0) return;
    const Polygon whole =
        transformed(to_polygon(whole_picture(film.shot)), film.placement.scale, film.placement.offset);
    frame.items.push_back({.source = film.shot.source,
                           .cell = cell_of(bounding_box(whole)),
                           .placement = film.placement,
                           .picture = film.shot.picture,
                           .active = film.shot.active,
                           .local = frame.time - film.began,
                           .alpha = alpha,
                           .slide_share = 0});
}

void TouchedFilm::begin(const PlacedShot& photo, SourceId source, std::chrono::nanoseconds now) {
    const Polygon room =
        transformed(to_polygon(whole_picture(photo.shot)), photo.placement.scale, photo.placement.offset);
    film_ = FilmMoment{.shot = *photo.shot.film, .placement = {}};
    film_->shot.source = source;
    const Box screen = bounding_box(room);
    film_->placement = fitting(film_->shot, screen, 1, screen.centre());
    is_ready_ = false;
    earliest_ = now + growing_time;
}

void TouchedFilm::end(std::chrono::nanoseconds now) {
    if (film_ && film_->began == never) film_.reset();
    if (film_) film_->ends = std::min(film_->ends, now + fading_time);
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
        film_->ends = now + film_->shot.shot.duration();
    }
    if (now >= film_->ends) film_.reset();
}

std::vector<PlacedShot> TouchedFilm::shots() const {
    if (!film_) return {};
    return {{.shot = film_->shot, .placement = film_->placement, .cell = {}, .began = film_->began}};
}

}  // namespace vitrine::player
