#include "player/stage/stage.hpp"

#include "base/state/tapestry.hpp"
#include "base/system/log.hpp"
#include "player/scene/crossfade.hpp"

#include <algorithm>
#include <exception>

// What a visitor does to a wall and the screens that show it, beside moving its shots: a folder is opened, or
// the strip of a film.

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr SourceId strip_bit = SourceId{1} << 47;  // of those of a strip
constexpr double parted = 1.25;                    // factor of a pinch that opens a strip

/// The folder below the media folder that a shot lies in; empty: none.
std::string top_folder(const std::optional<ShotKey>& shot) {
    const std::size_t slash = shot ? shot->path.find('/') : std::string::npos;
    return slash == std::string::npos ? "" : shot->path.substr(0, slash);
}

}  // namespace

/// A visitor looks into one of the folders that stand together; empty: at all of them.
void Stage::show_folder(const std::string& folder) {
    const RecordList within = records_.in_folder(folder);
    opened_ = within.is_empty() ? "" : folder;
    show_->set_catalogue(within.is_empty() ? records_ : within, hints_);
}

void Stage::take_gestures(std::chrono::nanoseconds now) {
    if (gestures_.is_touched()) touched_ = now;
    for (const Gesture& gesture : gestures_.meant(now)) {
        touched_ = now;
        if (strip_)
            strip_->take(gesture);
        else if (opens_strip(gesture))
            continue;
        else if (opens_folder(gesture))
            show_folder(opened_.empty() ? top_folder(show_->shot_at(gesture.at)) : "");
        else
            show_->handle_gesture(gesture);
    }
    if (!opened_.empty() && now - touched_ >= settings_.input.idle) show_folder("");
}

/// Two fingers that part on a film, or two taps on it, open its strip where there is one.
bool Stage::opens_strip(const Gesture& gesture) {
    pinched_ = gesture.kind == Gesture::Kind::pinch ? pinched_ * gesture.factor : 1;
    if (gesture.kind != Gesture::Kind::double_tap && pinched_ < parted) return false;
    const auto shot = show_->shot_at(gesture.at);
    if (!shot) return false;
    const RecordList::Record film = records_.find(shot->path);
    const auto directory = tapestry_folder(settings_.state.directory, shot->path);
    std::error_code error;
    if (!film || !std::filesystem::exists(directory / "index.json", error)) return false;
    try {
        if (!is_woven_from(read_tapestry(directory), *film)) {
            log::info("no strip of '{}': it has changed since it was woven", shot->path);
            return false;
        }
        const auto number = static_cast<std::size_t>(shot->shot);
        show_strip(directory, {.patience = settings_.input.idle,
                               .film = *film,
                               .first_seen = number < film->shots.size() ? film->shots[number].begin : 0ns});
    } catch (const std::exception& failure) {
        log::warning("no strip of '{}': {}", shot->path, failure.what());
        return false;
    }
    return true;
}

void Stage::show_strip(const std::filesystem::path& directory,
                       std::optional<std::chrono::nanoseconds> patience) {
    const Tapestry tapestry = read_tapestry(directory);
    const RecordList::Record film = records_.find(tapestry.path);
    const bool is_same = film && is_woven_from(tapestry, *film);
    show_strip(directory, {.patience = patience, .film = is_same ? std::optional(*film) : std::nullopt});
}

void Stage::show_strip(const std::filesystem::path& directory, StripStageOptions options) {
    options.first_source = sources_of(options_.number) | strip_bit;
    options.awaits_tiles = options_.awaits_sources;
    strip_ = std::make_unique<StripStage>(directory, canvas_, std::move(options));
    came_ = time_;
    fades_ = true;
    log::info("strip of '{}'", strip_->strip().tapestry().path);
}

/// The wall goes on where it was left.
void Stage::show_wall(Renderer& renderer) {
    carry_out({.retired = strip_->close()}, renderer);
    strip_.reset();
    behind_ = {};
    away_ += time_ - came_;
    time_ = came_;
    fades_ = true;
}

/// What has just come, over what was there before.
void Stage::fade_in(Frame& frame) const {
    if (!fades_ || time_ - came_ >= settings_.show.crossfade) return;
    const double shown = eased(std::chrono::duration<double>(time_ - came_) /
                               std::chrono::duration<double>(settings_.show.crossfade));
    for (DrawItem& item : frame.items)
        item.alpha *= shown;
    frame.idle = 1;
    if (!strip_) return;
    std::vector<DrawItem> items = behind_.items;
    for (DrawItem& item : items)
        item.alpha = std::min(item.alpha * (1 - shown), 0.999);
    items.insert(items.end(), frame.items.begin(), frame.items.end());
    frame.items = std::move(items);
}

/// A tap on a folder that stands together opens it, a tap or a key into it closes it.
bool Stage::opens_folder(const Gesture& gesture) const {
    if (settings_.layout.folders != FolderMode::nested) return false;
    return gesture.kind == Gesture::Kind::tap || (gesture.kind == Gesture::Kind::key && !opened_.empty());
}

}  // namespace vitrine::player
