#include "player/stage/screen_painter.hpp"

#include "base/system/log.hpp"
#include "player/stage/stage_settings.hpp"

#include <algorithm>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto idle_period = 100ms;  // between two frames with the idle picture, which moves slowly
constexpr auto still_period = 1s;    // between equal frames; restores a picture that a card lost silently

/// True: a part of the frame is the idle picture, because it is asked for or a source has no picture yet.
bool shows_idle(const Frame& frame, const Renderer& renderer) {
    return frame.idle > 0 ||
           std::ranges::any_of(frame.items, [&](const DrawItem& item) { return !renderer.has(item.source); });
}

}  // namespace

void ScreenPainter::set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now) {
    if (screens != screens_) shown_.clear();
    screens_ = std::move(screens);
    outputs_.follow(screens_, now);
}

std::optional<Canvas> ScreenPainter::canvas() const {
    if (outputs_.is_shared()) return outputs_.shared().canvas;
    if (screens_.empty()) return std::nullopt;
    const auto area = [](const Screen* screen) { return screen->width() * screen->height(); };
    const Screen& largest = **std::ranges::max_element(screens_, {}, area);
    Canvas canvas =
        canvas_size(largest.width(), largest.height(), view_of(settings_, largest.width(), largest.height()));
    canvas.finger = finger_on(largest.width(), largest.height(), largest.millimetres());
    return canvas;
}

Canvas ScreenPainter::expected_canvas(int width, int height) {
    outputs_.expect(width, height);
    if (outputs_.is_shared()) return outputs_.shared().canvas;
    return canvas_size(width, height, view_of(settings_, width, height));
}

Vec2 ScreenPainter::canvas_point(const Screen& screen, Vec2 canvas, Vec2 share) const {
    return vitrine::player::canvas_point(screen.width(), screen.height(), outputs_.view_on(screen, canvas),
                                         canvas, share);
}

void ScreenPainter::paint(const Frame& frame, std::chrono::nanoseconds now, Renderer* renderer,
                          bool waits_for_wall) {
    if (screens_.empty() || renderer == nullptr) return;
    const bool is_new = upload(frame, *renderer);
    const bool is_idle = shows_idle(frame, *renderer);
    const bool is_beyond = std::ranges::any_of(
        screens_, [&](const Screen* screen) { return outputs_.is_beyond(*screen, frame.canvas); });
    number(frame, is_new, is_idle || is_beyond);
    if (waits_for_wall && is_idle) return;
    for (Screen* screen : screens_) {
        std::uint64_t& shown = shown_[screen];
        if (!screen->is_ready() || (shown == number_ && !screen->wants_picture())) continue;
        shown = number_;
        screen->begin_frame();
        draw(frame, *screen, *renderer);
        screen->present(now);
    }
}

/// Uploads the newest pictures. True: at least one is new.
bool ScreenPainter::upload(const Frame& frame, Renderer& renderer) {
    bool is_new = false;
    for (const DrawItem& item : frame.items) {
        const std::optional<Sample> sample = sources_.sample(item.source);
        if (!sample || uploaded_[item.source] == sample->owner) continue;
        if (!uploaded_[item.source]) log::debug("source {} appears", item.source);
        if (const auto why = renderer.upload(item.source, *sample))
            log::warning("source {} is copied to the graphics card from now on: {}", item.source, *why);
        uploaded_[item.source] = sample->owner;
        is_new = true;
    }
    return is_new;
}

/// Gives the frame a new number if it does not look like the last one, or if the last one is long ago.
void ScreenPainter::number(const Frame& frame, bool is_new, bool is_idle) {
    const std::chrono::nanoseconds period = is_idle ? idle_period : still_period;
    if (!is_new && looks_alike(frame, drawn_) && frame.time - drawn_.time < period) return;
    drawn_ = frame;
    ++number_;
}

void ScreenPainter::show_guides(bool is_on) {
    if (has_guides_ == is_on) return;
    has_guides_ = is_on;
    guides_.clear();
    ++number_;
}

/// The guide of a screen, above its part of a canvas. @param origin  of the canvas in what is drawn, px
WordItem ScreenPainter::guide(const Screen& screen, Vec2 canvas, Vec2 origin) {
    Guide& guide = guides_[screen.name()];
    GuideView view = outputs_.guide_view(screen, canvas);
    if (!guide.picture || guide.view != view) guide.picture = canvas_guide(view);
    guide.view = std::move(view);
    return {.picture = guide.picture, .place = moved(guide.view.part, origin)};
}

void ScreenPainter::draw(const Frame& frame, Screen& screen, Renderer& renderer) {
    const bool is_beyond = outputs_.is_beyond(screen, frame.canvas);
    View view = outputs_.view_on(screen, frame.canvas);
    if (!is_beyond && !has_guides_) {
        renderer.aim(screen.width(), screen.height(), view);
        return renderer.draw(frame);
    }
    Frame own = frame;
    Vec2 origin = frame.view;
    if (is_beyond) {
        const ComingView coming = outputs_.coming_view(screen, frame.canvas);
        own = {.canvas = coming.canvas, .idle = 1, .time = frame.time};
        view = coming.view;
        origin = coming.origin * -1;
    }
    if (has_guides_) own.words.push_back(guide(screen, frame.canvas, origin));
    renderer.aim(screen.width(), screen.height(), view);
    renderer.draw(own);
}

void ScreenPainter::forget(SourceId source, Renderer* renderer) {
    if (renderer != nullptr) renderer->forget(source);
    uploaded_.erase(source);
}

}  // namespace vitrine::player
