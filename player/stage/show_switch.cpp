#include "player/stage/show_switch.hpp"

#include "base/state/tapestry.hpp"
#include "base/system/log.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/scene/change_pace.hpp"
#include "player/stage/show_modes.hpp"
#include "player/stage/stage_settings.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <iterator>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto complaint_period = 10min;
constexpr auto fades_alike = 100ms;  // a fade that begins later than the leader's begins by itself
constexpr SourceId tapestry_bit = SourceId{1} << (owner_shift - 1);  // set in a tapestry's sources

/// Tells if there is a tapestry that was woven from the present content of the film. Logs why there is none.
bool has_tapestry(const std::filesystem::path& directory, const MediaRecord& film) {
    std::error_code error;
    if (!std::filesystem::exists(directory / "index.json", error)) return false;
    try {
        const Tapestry tapestry = read_tapestry(directory);
        if (is_woven_from(tapestry, film)) return !tapestry.levels.empty();
        log::info("no tapestry of '{}': the film has changed since it was woven", film.path);
    } catch (const std::exception& failure) {
        log::warning("no tapestry of '{}': {}", film.path, failure.what());
    }
    return false;
}

/// Tells if the analyzer weaves this file's tapestry, sooner or later.
bool may_be_woven(const MediaRecord& record) {
    return record.kind == MediaKind::film && record.is_complete && !record.shots.empty() &&
           record.duration > 0ns;
}

/// Calls what shows a film's tapestry. False: it cannot be read; logs why.
bool can_show(const MediaRecord& film, const std::function<void()>& show_tapestry) {
    try {
        show_tapestry();
    } catch (const std::exception& failure) {
        log::warning("no tapestry of '{}': {}", film.path, failure.what());
        return false;
    }
    return true;
}

/// True for a wall of several boxes.
bool is_shared(Show& wall) {
    return wall.led() != nullptr || wall.followed() != nullptr;
}

}  // namespace

ShowSwitch::ShowSwitch(const Settings& settings, std::uint64_t owner, bool awaits_tiles)
    : settings_(settings),
      owner_(owner),
      awaits_tiles_(awaits_tiles),
      wall_(make_show(settings, canvas_, owner)) {}

void ShowSwitch::set_canvas(const Canvas& canvas) {
    const Placement way = place_on(canvas_, canvas);
    canvas_ = canvas;
    left_ = {};
    wall_->set_canvas(canvas);
    if (!tapestry_) return;
    const Vec2 stood_at = tapestry_->show().place().screen().centre();
    tapestry_->set_room(tapestry_room(canvas, stood_at * way.scale + way.offset));
}

void ShowSwitch::set_files(const StageFiles& files) {
    wall_->set_catalogue(files.all(), files.hints());
    if (tapestry_) tapestry_->set_catalogue(files.all());
}

void ShowSwitch::handle_source_event(const SourceEvent& event) {
    if (!event.failure) {
        if (!event.unstored.empty())
            log::info("not in the store, played from the media folder: '{}'", event.unstored);
        if (tapestry_) tapestry_->source_ready(event.source);
        return wall_->source_ready(event.source);
    }
    complain(event);
    if (tapestry_) tapestry_->source_failed(event.source);
    wall_->source_failed(event.source, time_);
}

/// Logs a source's failure once in ten minutes: a box that follows asks again for what it has not got.
void ShowSwitch::complain(const SourceEvent& event) {
    const std::chrono::nanoseconds now = time_ + away_;
    std::erase_if(complaints_,
                  [&](const auto& complaint) { return now - complaint.second >= complaint_period; });
    if (complaints_.try_emplace({event.source, *event.failure}, now).second)
        log::warning("not shown for now: {}", *event.failure);
}

WallStep ShowSwitch::step(Renderer* renderer) {
    std::optional<WallStep> step;
    if (tapestry_) step = tapestry_->step(time_, renderer);
    if (LedShow* const led = wall_->led())
        led->tell_tapestry(tapestry_ ? std::optional(tapestry_->seen()) : std::nullopt);
    if (step && !is_shared(*wall_)) return std::move(*step);
    WallStep wall = wall_->step(time_);
    if (!step) return wall;
    wall.frame = std::move(step->frame);
    std::ranges::move(step->requests, std::back_inserter(wall.requests));
    std::ranges::copy(step->retired, std::back_inserter(wall.retired));
    return wall;
}

void ShowSwitch::follow_tapestry(const TapestryMoment* seen, const RecordList::Record& film) {
    const bool is_same = tapestry_ && seen != nullptr && seen->path == tapestry_->show().film().path;
    if (tapestry_ && !is_same) tapestry_->end();
    if (seen == nullptr || !film) return;
    if (!tapestry_ && may_switch()) {
        const std::filesystem::path directory = tapestry_folder(settings_.state.directory, film->path);
        const bool has_index = has_tapestry(directory, *film);
        const TapestryPlaybackOptions options{
            .patience = {}, .film = film, .awaits_index = !has_index, .follows = true};
        if (!can_show(*film, [&] { show_tapestry(directory, options); })) return;
        if (time_ - seen->opened < fades_alike) switched_ = std::min(time_, seen->opened);
    } else if (!is_same) {
        return;
    }
    tapestry_->follow(*seen);
}

bool ShowSwitch::is_fading() const {
    return has_switched_ && time_ - switched_ < settings_.show.motion;
}

void ShowSwitch::fade(Frame& frame) {
    shown_ = {.items = frame.items, .idle = frame.idle};
    if (!is_fading()) return;
    const double progress = std::chrono::duration<double>(time_ - switched_) /
                            std::chrono::duration<double>(settings_.show.motion);
    fade_in(frame, left_, progress);
}

/// Lets the show of the last frame fade out from now on.
void ShowSwitch::note_switch() {
    left_ = std::exchange(shown_, {});
    switched_ = time_;
    has_switched_ = true;
}

/// True if wall and tapestry can replace one another without flashing.
bool ShowSwitch::may_switch() const {
    if (leaving_) return false;
    const ChangePace* const pace = wall_->pace();
    const bool may_change = !tapestry_ || is_shared(*wall_);  // the wall
    if (may_change && pace != nullptr && !pace->is_free(time_)) return false;
    return !has_switched_ || time_ - switched_ >= change_spacing(settings_);
}

Opening ShowSwitch::open_tapestry(const RecordList::Record& film, std::size_t shot, Vec2 at) {
    const std::filesystem::path directory = tapestry_folder(settings_.state.directory, film->path);
    if (!may_switch()) return Opening::later;
    const bool has_index = has_tapestry(directory, *film);
    if (!has_index && (settings_.tapestry.max_bytes == 0 || !may_be_woven(*film))) return Opening::never;
    const TapestryPlaybackOptions options{.patience = settings_.input.idle,
                                          .film = film,
                                          .first_seen =
                                              shot < film->shots.size() ? film->shots[shot].begin : 0ns,
                                          .awaits_index = !has_index,
                                          .wishes_in = settings_.state.directory,
                                          .edits_keyframes = settings_.input.edit_keyframes,
                                          .opened_at = at};
    const bool is_shown = can_show(*film, [&] { show_tapestry(directory, options); });
    return is_shown ? Opening::opened : Opening::never;
}

void ShowSwitch::show_tapestry(const std::filesystem::path& directory, TapestryPlaybackOptions options) {
    options.first_source = sources_of(owner_) | tapestry_bit;
    options.awaits_tiles = awaits_tiles_;
    options.rests = settings_.show.calm;
    const char* const when = options.awaits_index ? ", as soon as it is woven" : "";
    tapestry_ = std::make_unique<TapestryPlayback>(
        directory, tapestry_room(canvas_, options.opened_at.value_or(canvas_ * 0.5)), options);
    note_switch();
    log::info("tapestry of '{}'{}", tapestry_->show().tapestry().path, when);
}

std::vector<SourceId> ShowSwitch::leave_finished_tapestry() {
    if (leaving_ && !is_fading()) {
        left_ = {};
        return std::exchange(leaving_, nullptr)->close();
    }
    if (!tapestry_ || !tapestry_->is_over() || !may_switch()) return {};
    leaving_ = std::move(tapestry_);
    if (!is_shared(*wall_)) {
        away_ += time_ - switched_;
        time_ = switched_;
    }
    note_switch();
    if (ChangePace* const pace = wall_->pace()) pace->note_change(time_);
    return {};
}

void ShowSwitch::forget_uploads() {
    left_ = {};
    if (tapestry_) tapestry_->forget_uploads();
}

}  // namespace vitrine::player
