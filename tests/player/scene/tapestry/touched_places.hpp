#pragma once

#include "player/scene/tapestry/tapestry_show.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace vitrine::player {

/// Touches random places of random tapestries, and checks what plays against the brickwork itself: the films
/// have shots of which half are stored, with gaps between them; strips of 1 to 40 keyframes, of even and odd
/// numbers, are moved and zoomed before.
class TouchedPlaces {
  public:
    explicit TouchedPlaces(unsigned seed) : random_(seed) {}

    void check(int places) {
        for (int i = 0; i < places; ++i) {
            CAPTURE(i);
            check_one(i % 2 == 0);
        }
    }

  private:
    static constexpr Vec2 canvas{640, 360};

    double at_random(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }

    int number(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

    std::chrono::nanoseconds seconds(double number) {
        return std::chrono::nanoseconds(static_cast<std::int64_t>(number * 1e9));
    }

    /// Keyframes at random times; the first one or the last one may be the film's end.
    Tapestry tapestry() {
        Tapestry made{.path = "film.mp4",
                      .duration = seconds(at_random(3, 600)),
                      .is_complete = true,
                      .folder = "tiles",
                      .height = 90,
                      .tile_width = 200,
                      .brick_width = 2 * number(20, 60),
                      .levels = {}};
        int count = number(1, 10);
        for (int level = 0; level < 3; ++level, count *= 2) {
            TapestryLevel one{.width = (std::max(2, count) + 1) * made.brick_width / 2, .keyframes = {}};
            const double length = std::chrono::duration<double>(made.duration).count();
            for (int k = 0; k < count; ++k)
                one.keyframes.push_back(seconds((k + at_random(0.05, 0.95)) * length / count));
            if (number(0, 3) == 0) one.keyframes.front() = seconds(0);
            if (number(0, 3) == 0) one.keyframes.back() = made.duration;
            made.levels.push_back(std::move(one));
        }
        return made;
    }

    PreviewedFilm film_of(const Tapestry& tapestry) {
        PreviewedFilm film{
            .path = "film.mp4", .duration = tapestry.duration, .picture = {160, 90}, .shots = {}};
        for (std::chrono::nanoseconds begin = seconds(at_random(0, 3)); begin < tapestry.duration;) {
            Shot shot{.begin = begin,
                      .end = std::min(tapestry.duration, begin + seconds(at_random(0.2, 12))),
                      .stored = {}};
            if (number(0, 1) == 0) shot.stored = StoredShot{.file = "id/clip", .width = 160, .height = 90};
            film.shots.push_back(shot);
            begin = shot.end + seconds(std::max(0.0, at_random(-3, 3)));
        }
        return film;
    }

    /// The brick below a place of the brickwork, strip px. None: it lies on a border.
    static std::optional<int> brick_at(const Tapestry& tapestry, std::size_t level, double x, bool is_lower) {
        const int count = std::max(2, static_cast<int>(tapestry.levels[level].keyframes.size()));
        const double width = tapestry.brick_width;
        int nearest = -1;
        double least = 1e9;
        for (int brick = is_lower ? 1 : 0; brick < count; brick += 2) {
            const double left = brick * width / 2;
            if (std::abs(x - left) < 0.01 || std::abs(x - left - width) < 0.01) return std::nullopt;
            const double away = std::max({0.0, left - x, x - left - width});
            if (away >= least) continue;
            least = away;
            nearest = brick;
        }
        return nearest;
    }

    void run(TapestryShow& strip, std::chrono::nanoseconds duration) {
        for (const auto end = now_ + duration; now_ < end; now_ += std::chrono::milliseconds(20)) {
            TapestryStep step = strip.step(now_);
            for (const ShotRequest& request : step.requests) {
                requests_.push_back(request);
                strip.source_ready(request.source);
            }
            frame_ = std::move(step.frame);
        }
    }

    void move_at_random(TapestryShow& strip) {
        run(strip, seconds(0.1));
        for (int level = number(0, 2); level > 0; --level) {
            strip.handle_gesture({.kind = Gesture::Kind::key, .key = Key::nearer});
            run(strip, seconds(1));
        }
        strip.handle_gesture({.kind = Gesture::Kind::drag,
                              .at = {300, 100},
                              .from = {300, 100},
                              .moved = {at_random(-2000, 200), 0}});
        strip.handle_gesture({.kind = Gesture::Kind::drop, .at = {300, 100}, .from = {300, 100}});
        run(strip, seconds(0.1));
    }

    void check_one(bool is_tap) {
        const Tapestry drawn = tapestry();
        const PreviewedFilm film = film_of(drawn);
        TapestryShow strip(drawn, film, canvas, {.first_source = 1000});
        requests_.clear();
        now_ = {};
        move_at_random(strip);
        const Box box = strip.place().box();
        const double left = std::max(box.min.x, strip.place().canvas_x(strip.view(), seconds(0)));
        const double right = std::min(box.max.x, strip.place().canvas_x(strip.view(), drawn.duration));
        const Vec2 at{at_random(left, right), at_random(box.min.y, box.max.y)};
        const bool is_lower = at.y > (box.min.y + box.max.y) / 2;
        const auto level = static_cast<std::size_t>(std::lround(strip.view().level));
        const double scale = box.height() / drawn.height;
        const double origin = strip.place().canvas_x(strip.view(), seconds(0));
        const std::optional<int> brick = brick_at(drawn, level, (at.x - origin) / scale, is_lower);
        if (!brick) return;
        const auto& keyframes = drawn.levels[level].keyframes;
        const auto shown = keyframes[std::min(static_cast<std::size_t>(*brick), keyframes.size() - 1)];
        requests_.clear();
        strip.handle_gesture(
            {.kind = is_tap ? Gesture::Kind::tap : Gesture::Kind::hold, .at = at, .from = at});
        run(strip, seconds(0.1));
        const std::size_t begun = is_tap ? 2 : 1;  // what follows a short part may have been asked for, too
        REQUIRE(requests_.size() >= begun);
        requests_.resize(begun);
        for (const ShotRequest& request : requests_) {
            CHECK(std::chrono::abs(request.shot.begin - shown) <= std::chrono::milliseconds(500));
            CHECK(request.shot.end > request.shot.begin);
        }
        const auto item = std::ranges::find(frame_.items, requests_.back().source, &DrawItem::source);
        REQUIRE(item != frame_.items.end());
        const Box seen = bounding_box(item->cell->parts[0]);
        if (is_tap) return;  // the strip may have gone along with the film since
        CHECK((seen.min.x + seen.max.x) / 2 ==
              doctest::Approx(origin + scale * (*brick + 1) * drawn.brick_width / 2).epsilon(0.01));
        CHECK((seen.min.y + seen.max.y) / 2 < box.max.y - (is_lower ? 0 : box.height() / 2));
        CHECK((seen.min.y + seen.max.y) / 2 > box.min.y + (is_lower ? box.height() / 2 : 0));
    }

    std::mt19937 random_;
    std::vector<ShotRequest> requests_;
    Frame frame_;
    std::chrono::nanoseconds now_{0};
};

}  // namespace vitrine::player
