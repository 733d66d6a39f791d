#include "player/scene/folders/folder_stack.hpp"

#include "player/scene/change_pace.hpp"
#include "player/scene/crossfade.hpp"
#include "player/scene/folders/folder_zoom.hpp"
#include "player/scene/folders/opened_frame.hpp"

#include <memory>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto opening_patience = 12s;  // for the wall of a folder; then it is not opened
constexpr auto source_patience = 3s;    // for one of its sources, and for those of the wall behind

template <typename Item> void append(std::vector<Item>& to, const std::vector<Item>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

/// Adds the work of a step to another; the frame stays.
void append_work(WallStep& to, const WallStep& more) {
    append(to.requests, more.requests);
    append(to.retired, more.retired);
}

/// The settings of the wall of an opened folder. Its sources are numbered with those of all others.
WallSettings inner_settings(WallSettings settings) {
    settings.comes_at_once = true;
    settings.patience = source_patience;
    return settings;
}

WallSettings numbered(WallSettings settings) {
    settings.slots.numbers = std::make_shared<SourceId>(settings.slots.last_source);
    return settings;
}

}  // namespace

FolderStack::FolderStack(const Canvas& canvas, const WallSettings& settings)
    : settings_(numbered(settings)), canvas_(canvas) {
    levels_.emplace_back("", canvas, settings_);
}

void FolderStack::set_canvas(const Canvas& canvas) {
    canvas_ = canvas;
    for (OpenFolder& level : levels_)
        level.set_canvas(canvas);
}

void FolderStack::set_layout(const Layout& layout) {
    if (layout.generation != generation_) return;
    Layout inner = layout;
    inner.generation = inner_;
    top().set_layout(inner);
}

void FolderStack::open(const std::string& folder, const RecordList& files, const ShowHints& hints,
                       const ShowControls& controls) {
    top().hold(true);
    levels_.emplace_back(folder, canvas_, inner_settings(settings_));
    top().set_controls(controls);
    top().wall().set_catalogue(files, hints);
    zoom_ = Zoom{.is_opening = true, .asked = now_, .began = {}, .box = {}};
}

void FolderStack::close() {
    top().hold(true);
    outer().uncover(now_);
    if (levels_.size() > 2) append(requests_, levels_[levels_.size() - 3].ask_again());
    zoom_ = Zoom{.is_opening = false, .asked = now_, .began = {}, .box = {}};
}

WallStep FolderStack::step(std::chrono::nanoseconds now) {
    now_ = now;
    WallStep step{.requests = std::exchange(requests_, {})};
    if (levels_.size() > 1) append_work(step, outer().step(now));
    step_top(step);
    if (zoom_) advance_zoom(step);
    step.frame = composed_frame();
    return step;
}

/// Goes on with the wall on top, which is the only one that asks for plans.
void FolderStack::step_top(WallStep& step) {
    WallStep own = top().step(now_);
    append_work(step, own);
    if (!own.plan) return;
    if (levels_.size() > 1) top().keep_way_back_free(*own.plan);
    inner_ = own.plan->generation;
    own.plan->generation = ++generation_;
    step.plan = std::move(own.plan);
}

/// True if the wall that will be the one behind has its sources. A wall of several boxes waits for them: a
/// box that lacks one would not show the way. A box alone begins at once, as that wall is seen only at the
/// end.
bool FolderStack::has_outermost_sources() const {
    return levels_.size() < 3 || levels_[levels_.size() - 3].has_sources();
}

/// Begins the way once both walls can be seen, and ends it.
void FolderStack::advance_zoom(WallStep& step) {
    if (zoom_->began) {
        if (now_ - *zoom_->began >= settings_.transition.duration) end_zoom(step);
        return;
    }
    const bool is_late = now_ - zoom_->asked >= (zoom_->is_opening ? opening_patience : source_patience);
    const bool has_behind = outer().has_sources() && (settings_.lead.count() == 0 || has_outermost_sources());
    const bool is_ready = zoom_->is_opening ? !top().wall().shown().empty() : has_behind || is_late;
    if (!is_ready && is_late) {  // the folder has nothing that can be shown
        zoom_->is_opening = false;
        return end_zoom(step);
    }
    ChangePace& pace = *outer().wall().pace();
    const bool is_changing =
        is_in_change(outer().wall()) || (!zoom_->is_opening && is_in_change(top().wall()));
    if (!is_ready || is_changing || !pace.is_free(outer().local(now_))) return;
    pace.note_change(outer().local(now_));
    top().wall().pace()->note_change(top().local(now_));
    zoom_->began = now_ + settings_.touch_lead;
    const Vec2 canvas = outer().frame().canvas;
    zoom_->box = settings_.is_calm ? Box{{0, 0}, canvas}
                                   : box_of_folder(outer().wall().shown(), top().folder(), canvas);
}

/// The wall that is not seen any more goes, or rests.
void FolderStack::end_zoom(WallStep& step) {
    const bool has_opened = std::exchange(zoom_, std::nullopt)->is_opening;
    if (has_opened) {
        outer().cover(now_);
        if (levels_.size() > 2) append(step.retired, levels_[levels_.size() - 3].release_sources());
        return;
    }
    append(step.retired, top().release_sources());
    levels_.pop_back();
    top().uncover(now_);
    top().hold(false);
}

/// The share of the way from the wall behind to the one on top, in [0, 1].
double FolderStack::opened_share() const {
    if (!zoom_) return 1;
    if (!zoom_->began) return zoom_->is_opening ? 0 : 1;
    const double share = std::chrono::duration<double>(now_ - *zoom_->began) /
                         std::chrono::duration<double>(settings_.transition.duration);
    return zoom_->is_opening ? share : 1 - share;
}

Frame FolderStack::composed_frame() const {
    const std::size_t depth = levels_.size();
    if (depth < 2) return top().frame();
    const OpenFolder& behind = levels_[depth - 2];
    return opened_frame({.top = top().frame(),
                         .outer = behind.frame(),
                         .outermost = depth > 2 ? &levels_[depth - 3].frame() : nullptr,
                         .mark = top().way_back(),
                         .outer_mark = behind.way_back(),
                         .box = zoom_ && zoom_->began ? zoom_->box : Box{{0, 0}, behind.frame().canvas},
                         .share = opened_share()});
}

}  // namespace vitrine::player
