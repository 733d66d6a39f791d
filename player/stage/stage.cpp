#include "player/stage/stage.hpp"

#include "base/system/log.hpp"
#include "player/display/memory_target.hpp"
#include "player/layout/plan/plan.hpp"
#include "player/scene/panning_wall.hpp"
#include "player/scene/wall.hpp"
#include "player/stage/stage_settings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto idle_period = 100ms;       // from one look of the idle picture to the next: it moves slowly
constexpr auto still_period = 1s;         // a picture that a card lost in silence is back by then
constexpr auto source_patience = 10s;     // that a picture paced by its sources waits for one of them
constexpr int most_settling_steps = 100;  // each gives up on a file at least

std::unique_ptr<Show> make_show(const Settings& settings, Vec2 canvas, SourceId last_source) {
    if (settings.layout.mode == WallMode::pan) {
        PanSettings pan = pan_settings(settings);
        pan.last_source = last_source;
        return std::make_unique<PanningWall>(canvas, pan);
    }
    WallSettings wall = wall_settings(settings);
    wall.slots.last_source = last_source;
    return std::make_unique<Wall>(canvas, wall);
}

View view_on(const Settings& settings, const Screen& screen) {
    return view_of(settings, screen.width(), screen.height());
}

Vec2 canvas_of(const Settings& settings, const Screen& screen) {
    return canvas_size(screen.width(), screen.height(), view_on(settings, screen));
}

}  // namespace

Stage::Stage(const Settings& settings, StageOptions options, SourcePool& sources)
    : settings_(settings),
      options_(std::move(options)),
      sources_(sources),
      show_(make_show(settings, canvas_, sources_of(options_.number))),
      listener_(std::make_shared<const SourceListener>(
          SourceListener{.owner = options_.number,
                         .call = [this](const SourceEvent& event) { handle_source_event(event); }})) {
    sources_.listen(listener_);
}

void Stage::set_catalogue(const RecordList& records, const ShowHints& hints) {
    records_ = records.in_folder(options_.folder);
    hints_ = hints;
    show_folder(opened_);
    if (strip_) strip_->set_catalogue(records_);
}

void Stage::expect_screen(int width, int height) {
    set_canvas(canvas_size(width, height, view_of(settings_, width, height)));
    if (const std::optional<WallPlan> plan = show_->step(time_).plan) ask(*plan);
}

void Stage::set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now) {
    if (screens != screens_) shown_.clear();
    screens_ = std::move(screens);
    if (screens_.empty()) {
        if (!hidden_since_) hidden_since_ = now;
        return;
    }
    if (hidden_since_) hidden_ += now - *std::exchange(hidden_since_, std::nullopt);
    const auto area = [](const Screen* screen) { return screen->width() * screen->height(); };
    const Vec2 canvas = canvas_of(settings_, **std::ranges::max_element(screens_, {}, area));
    if (canvas == canvas_) return;
    set_canvas(canvas);
}

void Stage::set_canvas(Vec2 canvas) {
    canvas_ = canvas;
    gestures_.set_rules(gesture_rules(canvas));
    show_->set_canvas(canvas);
    if (strip_) strip_->set_canvas(canvas);
}

Vec2 Stage::canvas_point(const Screen& screen, Vec2 share) const {
    const View view = letterboxed(screen.width(), screen.height(), view_on(settings_, screen), canvas_);
    return vitrine::player::canvas_point(screen.width(), screen.height(), view, canvas_, share);
}

void Stage::handle_source_event(const SourceEvent& event) {
    if (!event.failure) {
        if (!event.unstored.empty())
            log::info("not in the store, played from the media folder: '{}'", event.unstored);
        if (strip_) strip_->source_ready(event.source);
        return show_->source_ready(event.source);
    }
    log::warning("not shown for now: {}", *event.failure);
    if (strip_) strip_->source_failed(event.source);
    show_->source_failed(event.source, time_);
}

void Stage::show(std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall) {
    time_ = now - hidden_ - away_;
    take_gestures(now);
    if (strip_ && strip_->is_over()) show_wall(renderer);
    WallStep step = next_step(renderer);
    if (!strip_) behind_ = step.frame;
    fade_in(step.frame);
    step.frame.time = now - hidden_;
    frame_ = std::move(step.frame);
    draw(frame_, now, renderer, waits_for_wall);
}

WallStep Stage::one_step(Renderer& renderer) {
    return strip_ ? strip_->step(time_, renderer) : show_->step(time_);
}

void Stage::forget_uploads() {
    uploaded_.clear();
    if (strip_) strip_->forget_uploads();
}

WallStep Stage::next_step(Renderer& renderer) {
    take_layout();
    WallStep step = one_step(renderer);
    carry_out(step, renderer);
    for (int i = 0;
         options_.awaits_sources && i < most_settling_steps && (step.plan || !step.requests.empty()); ++i) {
        // The clock stands still until the layout and the sources are there.
        sources_.wait_until_ready(source_patience);
        step = one_step(renderer);
        carry_out(step, renderer);
    }
    return step;
}

void Stage::carry_out(const WallStep& step, Renderer& renderer) {
    if (step.plan) ask(*step.plan);
    for (const ShotRequest& request : step.requests) {
        log::debug("source {}: '{}'", request.source, request.path);
        sources_.request(request);
        note_film(request);
    }
    for (const SourceId source : step.retired) {
        sources_.retire(source);
        renderer.forget(source);
        uploaded_.erase(source);
        films_.erase(source);
    }
}

void Stage::take_layout() {
    if (const std::optional<Layout> layout = planner_.pop_layout()) show_->set_layout(*layout);
}

/// Has a wall laid out: at once where the clock waits anyway, else by the planner's thread.
void Stage::ask(const WallPlan& wall) {
    PlanRequest request = plan_request(settings_, wall.canvas);
    request.items = wall.items;
    if (!options_.awaits_sources) return planner_.request_layout(std::move(request), wall.generation);
    Layout layout = plan(request);
    layout.generation = wall.generation;
    layout.is_final = true;
    show_->set_layout(layout);
}

Picture Stage::picture(int longest, Renderer& renderer) const {
    const double scale = longest / std::max(canvas_.x, canvas_.y);
    const auto pixels = [&](double side) { return std::max(1, static_cast<int>(std::lround(side * scale))); };
    MemoryTarget target(pixels(canvas_.x), pixels(canvas_.y));
    target.make_current();
    renderer.aim(target.width(), target.height(),
                 letterboxed(target.width(), target.height(), {}, frame_.canvas));
    renderer.draw(frame_);
    Picture picture{.width = target.width(), .height = target.height(), .pixels = {}};
    target.read(GL_RGBA, [&](std::span<const std::byte> row) {
        picture.pixels.insert(picture.pixels.end(), row.begin(), row.end());
    });
    return picture;
}

void Stage::draw(Frame& frame, std::chrono::nanoseconds now, Renderer& renderer, bool waits_for_wall) {
    if (options_.awaits_sources) sources_.wait_for(frame, source_patience);
    sources_.advance(frame);
    const bool is_new = upload(frame, renderer);
    const bool is_idle = frame.idle > 0 || std::ranges::any_of(frame.items, [&](const DrawItem& item) {
                             return !renderer.has(item.source);
                         });
    const auto longest = is_idle ? idle_period : still_period;
    if (is_new || !looks_alike(frame, drawn_) || frame.time - drawn_.time >= longest) {
        drawn_ = frame;
        ++picture_;
    }
    if (waits_for_wall && is_idle) return;
    for (Screen* screen : screens_) {
        std::uint64_t& shown = shown_[screen];
        if (!screen->is_ready() || (shown == picture_ && !screen->wants_picture())) continue;
        shown = picture_;
        screen->begin_frame();
        renderer.aim(
            screen->width(), screen->height(),
            letterboxed(screen->width(), screen->height(), view_on(settings_, *screen), frame.canvas));
        renderer.draw(frame);
        screen->present(now);
    }
}

/// Whether any picture is new.
bool Stage::upload(const Frame& frame, Renderer& renderer) {
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

}  // namespace vitrine::player
