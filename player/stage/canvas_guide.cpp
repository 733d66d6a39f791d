#include "player/stage/canvas_guide.hpp"

#include "player/words/stroke_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>

namespace vitrine::player {

namespace {

using Ink = std::array<int, 3>;

constexpr Ink white{255, 255, 255};
constexpr Ink yellow{255, 210, 0};
constexpr int shade = 120;            // opacity of the black below the lines, of 255
constexpr double name_share = 0.12;   // height of the name, as a share of the screen's shorter side
constexpr double place_share = 0.04;  // the same of its place
constexpr double tick_share = 0.015;  // length of a short mark of a ruler
constexpr double min_tick = 7;        // px between two marks
constexpr int marks_a_number = 10;
constexpr double max_units = 1e7;  // a longer ruler has no marks

/// A picture that lines are drawn on.
class Paper {
  public:
    explicit Paper(Vec2 size) {
        picture_.width = std::max(1, static_cast<int>(std::lround(size.x)));
        picture_.height = std::max(1, static_cast<int>(std::lround(size.y)));
        picture_.rgba.assign(static_cast<std::size_t>(picture_.width) *
                                 static_cast<std::size_t>(picture_.height) * 4,
                             std::byte{0});
        for (std::size_t i = 3; i < picture_.rgba.size(); i += 4)
            picture_.rgba[i] = std::byte{shade};
    }

    double shorter_side() const { return std::min(picture_.width, picture_.height); }

    /// @param width  px
    void draw(Vec2 from, Vec2 to, double width, const Ink& ink) {
        const Vec2 along = to - from;
        const int steps = std::max(1, static_cast<int>(std::ceil(length(along))));
        const double reach = width / 2 + 1;
        for (int k = 0; k <= steps; ++k) {
            const Vec2 at = from + along * (static_cast<double>(k) / steps);
            if (at.x < -reach || at.y < -reach || at.x > picture_.width + reach ||
                at.y > picture_.height + reach)
                continue;
            dot_at(at, width / 2, ink);
        }
    }

    /// @param at  the top left corner, px. @param height  of the letters, px
    void write(std::string_view text, Vec2 at, double height, const Ink& ink) {
        for (const Stroke& stroke : strokes_of(text))
            draw(at + stroke[0] * height, at + stroke[1] * height, std::max(1.5, height / 9), ink);
    }

    std::shared_ptr<const WordPicture> taken() {
        return std::make_shared<const WordPicture>(std::move(picture_));
    }

  private:
    void dot_at(Vec2 at, double radius, const Ink& ink) {
        const auto first = [&](double place) { return static_cast<int>(std::floor(place - radius)); };
        const auto last = [&](double place) { return static_cast<int>(std::ceil(place + radius)); };
        for (int y = std::max(0, first(at.y)); y < std::min(picture_.height, last(at.y)); ++y)
            for (int x = std::max(0, first(at.x)); x < std::min(picture_.width, last(at.x)); ++x) {
                const double away = length(Vec2{x + 0.5, y + 0.5} - at);
                const double cover = std::clamp(radius + 0.5 - away, 0.0, 1.0);
                if (cover > 0) put(x, y, cover, ink);
            }
    }

    void put(int x, int y, double cover, const Ink& ink) {
        const std::size_t first = (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_.width) +
                                   static_cast<std::size_t>(x)) *
                                  4;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto value = static_cast<int>(std::lround(ink[k] * cover));
            picture_.rgba[first + k] =
                static_cast<std::byte>(std::max(value, std::to_integer<int>(picture_.rgba[first + k])));
        }
        const auto opacity = static_cast<int>(std::lround(shade + (255 - shade) * cover));
        picture_.rgba[first + 3] =
            static_cast<std::byte>(std::max(opacity, std::to_integer<int>(picture_.rgba[first + 3])));
    }

    WordPicture picture_;
};

/// The smallest of 1, 2, 5, 10, 20 ... units that are at least so many px apart.
double step_of(double px_a_unit) {
    for (double ten = 1; ten < max_units; ten *= 10)
        for (const double step : {1.0, 2.0, 5.0})
            if (step * ten * px_a_unit >= min_tick) return step * ten;
    return max_units;
}

/// The marks of the rulers at both ends of an axis of a screen.
class Ruler {
  public:
    Ruler(Paper& paper, const GuideView& view, bool is_across)
        : paper_(paper), view_(view), is_across_(is_across) {}

    void draw() {
        const Vec2 scale = scale_of();
        const double from = coordinate(view_.part.min) / view_.unit + coordinate(view_.origin);
        const double to = coordinate(view_.part.max) / view_.unit + coordinate(view_.origin);
        const double px_a_unit = coordinate(scale) * view_.unit;
        const double step = step_of(px_a_unit);
        for (double mark = std::ceil(from / step); mark * step <= to; ++mark)
            draw_mark(static_cast<long>(mark), mark * step, (mark * step - from) * px_a_unit);
    }

  private:
    double coordinate(Vec2 point) const { return is_across_ ? point.x : point.y; }

    Vec2 scale_of() const { return {view_.size.x / view_.part.width(), view_.size.y / view_.part.height()}; }

    Vec2 point(double along, double inward) const {
        return is_across_ ? Vec2{along, inward} : Vec2{inward, along};
    }

    void draw_mark(long number, double units, double along) {
        const bool has_number = number % marks_a_number == 0;
        const double size = paper_.shorter_side() * tick_share *
                            (has_number                           ? 3
                             : number % (marks_a_number / 2) == 0 ? 2
                                                                  : 1);
        const double depth = is_across_ ? view_.size.y : view_.size.x;
        paper_.draw(point(along, 0), point(along, size), 1.5, white);
        paper_.draw(point(along, depth - size), point(along, depth), 1.5, white);
        if (!has_number) return;
        const double height = std::max(8.0, paper_.shorter_side() * tick_share);
        paper_.write(fmt::format("{:.0f}", units), point(along, size) + Vec2{3, 3}, height, white);
    }

    Paper& paper_;           // outlives this
    const GuideView& view_;  // outlives this
    bool is_across_;
};

void draw_diagonals(Paper& paper, const GuideView& view) {
    const auto on_paper = [&](Vec2 point) {
        return Vec2{(point.x - view.part.min.x) / view.part.width() * view.size.x,
                    (point.y - view.part.min.y) / view.part.height() * view.size.y};
    };
    const double width = std::max(2.0, paper.shorter_side() / 300);
    paper.draw(on_paper({0, 0}), on_paper(view.canvas), width, yellow);
    paper.draw(on_paper({0, view.canvas.y}), on_paper({view.canvas.x, 0}), width, yellow);
}

void write_in_middle(Paper& paper, const GuideView& view, std::string_view text, double height, double down) {
    const double fits = 0.8 * view.size.x / std::max(1e-9, stroke_length(text));
    const double size = std::min(height, fits);
    paper.write(text, {(view.size.x - stroke_length(text) * size) / 2, view.size.y / 2 + down}, size, white);
}

}  // namespace

std::shared_ptr<const WordPicture> canvas_guide(const GuideView& view) {
    Paper paper(view.size);
    draw_diagonals(paper, view);
    for (const bool is_across : {true, false})
        Ruler(paper, view, is_across).draw();
    const std::array<Vec2, 4> corners{
        Vec2{1, 1}, {view.size.x - 1, 1}, {view.size.x - 1, view.size.y - 1}, {1, view.size.y - 1}};
    for (std::size_t k = 0; k < corners.size(); ++k)
        paper.draw(corners[k], corners[(k + 1) % corners.size()], 2, yellow);
    const double name = paper.shorter_side() * name_share;
    write_in_middle(paper, view, view.name, name, -1.5 * name);
    const Vec2 at = view.part.min * (1 / view.unit) + view.origin;
    write_in_middle(paper, view,
                    fmt::format("{:.0f},{:.0f} {:.0f}x{:.0f}", at.x, at.y, view.part.width() / view.unit,
                                view.part.height() / view.unit),
                    paper.shorter_side() * place_share, 0);
    return paper.taken();
}

}  // namespace vitrine::player
