#include "player/stage/stage.hpp"

#include "base/settings/settings.hpp"
#include "base/settings/share_address.hpp"
#include "base/state/tapestry.hpp"
#include "base/system/log.hpp"
#include "player/playback/source_pool.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/stage/audible_films.hpp"
#include "player/stage/folder_words.hpp"
#include "player/stage/gesture_dispatch.hpp"
#include "player/stage/screen_painter.hpp"
#include "player/stage/show_switch.hpp"
#include "player/stage/stage_settings.hpp"
#include "player/stage/wall_planner.hpp"

#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto source_patience = 10s;    // longest wait of a frame for one source, if pictures set the pace
constexpr int max_settling_steps = 100;  // each gives up at least one file

WallWords words_of(const Settings& settings) {
    return {.captions = settings.show.captions, .code = settings.show.qr, .share = share_address(settings)};
}

/// The act of another box that a wall draws. nullptr: none.
const WallAct* followed_act(Show& wall) {
    const FollowedWall* const followed = wall.followed();
    return followed != nullptr ? followed->shown() : nullptr;
}

/// The parts that the outputs of all boxes show of a canvas. Empty: each box shows all of it.
std::map<std::string, ActPart> all_parts(Show& wall, const ScreenPainter& painter, Vec2 canvas) {
    if (const WallAct* const act = followed_act(wall)) return act->parts;
    if (wall.led() != nullptr)
        for (const ActParts& known : painter.parts())
            if (known.canvas == canvas) return known.parts;
    return {};
}

void set_canvas(const Canvas& canvas, GestureDispatch& gestures, ShowSwitch& shows) {
    gestures.set_canvas(canvas);
    shows.set_canvas(canvas);
}

}  // namespace

Stage::Stage(const Settings& settings, StageOptions options, SourcePool& sources)
    : settings_(settings),
      awaits_sources_(options.awaits_sources),
      sources_(sources),
      files_(std::move(options.folder)),
      shows_(std::make_unique<ShowSwitch>(settings, options.number, awaits_sources_)),
      gestures_(std::make_unique<GestureDispatch>(*shows_, files_)),
      planner_(std::make_unique<WallPlanner>(settings, awaits_sources_)),
      painter_(std::make_unique<ScreenPainter>(settings, sources, std::move(options.others))),
      films_(std::make_unique<AudibleFilms>()),
      words_(std::make_unique<FolderWords>(settings.state.directory, words_of(settings))),
      listener_(std::make_shared<const SourceListener>(
          SourceListener{.owner = options.number,
                         .call = [this](const SourceEvent& event) { shows_->handle_source_event(event); }})) {
    sources_.listen(listener_);
    if (settings.wall.role != WallRole::alone) hidden_since_.reset();  // shared time stands never still
    if (LedShow* const led = wall().led()) led->set_words(words_of(settings));
}

Stage::~Stage() = default;

Show& Stage::wall() const {
    return shows_->wall();
}

std::span<Screen* const> Stage::screens() const {
    return painter_->screens();
}

bool Stage::is_seen() const {
    return !screens().empty() || (wall().led() != nullptr && painter_->has_others());
}

void Stage::handle_input(const InputEvent& event) {
    if (FollowedWall* const followed = wall().followed()) return followed->touches().note(event);
    gestures_->handle_input(event);
}

void Stage::set_catalogue(const RecordList& records, const ShowHints& hints) {
    files_.set(records, hints);
    shows_->set_files(files_);
}

void Stage::expect_screen(int width, int height) {
    set_canvas(painter_->expected_canvas(width, height), *gestures_, *shows_);
    if (const std::optional<WallPlan> plan = shows_->wall().step(0ns).plan) planner_->request_layout(*plan);
}

void Stage::set_screens(std::vector<Screen*> screens, std::chrono::nanoseconds now) {
    painter_->set_screens(std::move(screens), now);
    if (!is_seen()) {
        if (!hidden_since_ && settings_.wall.role == WallRole::alone) hidden_since_ = now;
        return;
    }
    if (hidden_since_) hidden_ += now - *std::exchange(hidden_since_, std::nullopt);
    const Canvas canvas = painter_->canvas().value_or(shows_->canvas());
    if (canvas != shows_->canvas() || canvas.finger != shows_->canvas().finger)
        set_canvas(canvas, *gestures_, *shows_);
    if (LedShow* const led = wall().led()) led->set_parts(painter_->parts());
}

Vec2 Stage::canvas_point(const Screen& screen, Vec2 share) const {
    return painter_->canvas_point(screen, shows_->canvas(), share);
}

void Stage::show(std::chrono::nanoseconds now, Renderer* renderer, bool waits_for_wall) {
    shows_->set_time(now - hidden_);
    gestures_->dispatch(now);
    if (const FollowedWall* const followed = wall().followed()) {
        const TapestryMoment* const seen = followed->tapestry();
        shows_->follow_tapestry(seen, seen != nullptr ? files_.all().find(seen->path) : nullptr);
    }
    carry_out({.retired = shows_->leave_finished_tapestry()}, renderer);
    frame_ = next_step(renderer).frame;
    if (const WallAct* const act = followed_act(wall())) {
        painter_->show_parts(*act);
        words_->set_words(act->words);
    }
    shows_->fade(frame_);
    words_->draw(frame_, files_.hints(), files_.all());
    frame_.time = now - hidden_;
    if (awaits_sources_) sources_.wait_for(frame_, source_patience);
    sources_.advance(frame_);
    painter_->paint(frame_, now, renderer, waits_for_wall);
}

WallStep Stage::next_step(Renderer* renderer) {
    if (const std::optional<Layout> layout = planner_->pop_layout()) shows_->wall().set_layout(*layout);
    WallStep step = shows_->step(renderer);
    carry_out(step, renderer);
    for (int i = 0; awaits_sources_ && i < max_settling_steps && (step.plan || !step.requests.empty()); ++i) {
        // The clock stands still until the layout and the sources are ready.
        sources_.wait_until_ready(source_patience);
        step = shows_->step(renderer);
        carry_out(step, renderer);
    }
    return step;
}

void Stage::carry_out(const WallStep& step, Renderer* renderer) {
    if (step.plan) {
        planner_->request_layout(*step.plan);
        if (const std::optional<Layout> layout = planner_->pop_layout())  // made during the call above
            shows_->wall().set_layout(*layout);
    }
    for (const ShotRequest& request : step.requests) {
        log::debug("source {}: '{}'", request.source, request.path);
        sources_.request(request);
        films_->note(request, files_.all());
    }
    for (const SourceId source : step.retired) {
        sources_.retire(source);
        painter_->forget(source, renderer);
        films_->forget(source);
    }
}

void Stage::forget_uploads() {
    painter_->forget_uploads();
    shows_->forget_uploads();
}

void Stage::show_tapestry(const std::filesystem::path& directory,
                          std::optional<std::chrono::nanoseconds> patience) {
    const Tapestry tapestry = read_tapestry(directory);
    const RecordList::Record film = files_.all().find(tapestry.path);
    shows_->show_tapestry(
        directory, {.patience = patience, .film = film && is_woven_from(tapestry, *film) ? film : nullptr});
}

void Stage::show_guides(bool is_on) {
    painter_->show_guides(is_on);
}

void Stage::set_controls(const ShowControls& controls) {
    is_paused_ = controls.is_paused;
    shows_->wall().set_controls(controls);
}

std::vector<AudibleShot> Stage::audible() const {
    if (is_paused_ || painter_->screens().empty()) return {};
    if (const WallAct* const act = followed_act(wall()); act != nullptr && act->is_paused) return {};
    std::vector<AudibleShot> shots = films_->shots(frame_, files_.hints());
    if (shots.empty() || settings_.wall.role == WallRole::alone) return shots;
    const std::map<std::string, ActPart> parts = all_parts(wall(), *painter_, frame_.canvas);
    for (AudibleShot& shot : shots)
        shot.is_elsewhere = !has_point(box_name(settings_), parts, shot.middle);
    return shots;
}

}  // namespace vitrine::player
