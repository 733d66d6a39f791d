#include "player/scene/wall.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace vitrine::player {

namespace {

constexpr double worth_all_anew = 0.2;  // of the canvas, that is wasted less

const PlacedShot* find_source(std::span<const PlacedShot> wall, SourceId source) {
    const auto found = std::find_if(wall.begin(), wall.end(),
                                    [&](const PlacedShot& placed) { return placed.shot.source == source; });
    return found == wall.end() ? nullptr : &*found;
}

const PlacedShot* find_slot(std::span<const PlacedShot> wall, int slot) {
    const auto found = std::find_if(wall.begin(), wall.end(),
                                    [&](const PlacedShot& placed) { return placed.shot.slot == slot; });
    return found == wall.end() ? nullptr : &*found;
}

bool is_same(std::span<const PlacedShot> wall, const std::vector<WallShot>& wanted) {
    return std::equal(wall.begin(), wall.end(), wanted.begin(), wanted.end(),
                      [](const PlacedShot& a, const WallShot& b) { return a.shot.source == b.source; });
}

/// Share of the canvas where nothing that matters is seen, and once more where nobody has pixels.
double wasted(std::span<const PlacedShot> wall, Vec2 canvas) {
    double regions = 0;
    double filler = 0;
    for (const PlacedShot& placed : wall) {
        regions += seat_of(placed.shot.item, placed.placement).area;
        for (const Polygon& polygon : placed.cell->filler)
            filler += signed_area(polygon);
    }
    return 1 + (filler - regions) / (canvas.x * canvas.y);
}

}  // namespace

int folder_number(const std::string& path, std::map<std::string, int>& folders) {
    const std::size_t slash = path.find('/');
    if (slash == std::string::npos) return PlanItem::no_group;
    return folders.emplace(path.substr(0, slash), static_cast<int>(folders.size())).first->second;
}

Wall::Wall(Vec2 canvas, const WallSettings& settings)
    : settings_(settings),
      canvas_(canvas),
      slots_(settings.slots),
      drag_(settings.touch),
      enlargement_(settings.touch, settings.idle) {}

void Wall::set_canvas(Vec2 canvas) {
    is_canvas_new_ = is_canvas_new_ || canvas != canvas_;
    canvas_ = canvas;
}

void Wall::set_catalogue(const RecordList& records, const ShowHints& hints) {
    const std::vector<WallShot> before = slots_.shots();
    slots_.set_catalogue(records, hints);
    if (!std::ranges::equal(slots_.shots(), before, {}, &WallShot::source, &WallShot::source))
        enlargement_.end();
    follow_store();
}

void Wall::follow_store() {
    const std::vector<WallShot> known = slots_.shots();
    const auto follow = [&](std::vector<PlacedShot>& wall, bool is_asked) {
        for (PlacedShot& placed : wall) {
            const auto now = std::ranges::find(known, placed.shot.source, &WallShot::source);
            if (now == known.end() || now->shot.stored == placed.shot.shot.stored) continue;
            placed.shot.shot.stored = now->shot.stored;
            if (is_asked) restored_.push_back(request_of(placed));
        }
    };
    follow(shown_, true);
    if (incoming_) follow(incoming_->wall, incoming_->waiting && !incoming_->wants_sources);
}

void Wall::set_layout(const Layout& layout) {
    if (!incoming_ || incoming_->generation != layout.generation || incoming_->fade_began) return;
    if (!layout.is_final && !shown_.empty()) return;
    std::vector<PlacedShot>& wall = incoming_->wall;
    assert(layout.placements.size() == wall.size());
    for (std::size_t i = 0; i < wall.size(); ++i)
        wall[i].placement = layout.placements[i];
    give_cells(wall, incoming_->canvas, settings_.transition.cells);
    incoming_->acts.clear();
    incoming_->has_layout = true;
    incoming_->is_final = layout.is_final;
    choose_layout();
    const bool is_asked = incoming_->waiting.has_value();
    incoming_->wants_sources = incoming_->has_layout && (layout.is_final || !is_asked);
}

/// Takes the layout that has come, or has the change laid out anew too and then takes the better of both.
void Wall::choose_layout() {
    Incoming& change = *incoming_;
    const bool is_fresh = change.is_anew || shown_.empty() || change.canvas != shown_canvas_;
    const double waste = wasted(change.wall, change.canvas);
    if (is_fresh) {
        usual_waste_ = waste;
        if (!change.calm.empty() && wasted(change.calm, change.canvas) < waste + worth_all_anew)
            change.wall = std::exchange(change.calm, {});
    } else if (!settings_.nests && waste > usual_waste_ + worth_all_anew) {
        change.calm = change.wall;
        change.has_layout = false;
    }
}

/// A plan of the change under way without regard to where things stand.
std::optional<WallPlan> Wall::ask_anew() {
    if (!incoming_ || incoming_->calm.empty() || incoming_->is_anew) return std::nullopt;
    incoming_->is_anew = true;
    incoming_->generation = ++generation_;
    WallPlan plan{.generation = generation_, .canvas = incoming_->canvas};
    for (const PlacedShot& placed : incoming_->calm)
        plan.items.push_back({.item = placed.shot.item});
    return plan;
}

std::vector<SlotShot> Wall::standing() const {
    std::vector<SlotShot> all;
    for (const PlacedShot& placed : shown_)
        all.push_back({.slot = placed.shot.slot, .key = placed.shot.key});
    return all;
}

void Wall::source_ready(SourceId source) {
    const auto found = sources_.find(source);
    if (found != sources_.end()) found->second = Source::ready;
}

void Wall::source_failed(SourceId source, std::chrono::nanoseconds now) {
    const auto found = sources_.find(source);
    if (found != sources_.end()) found->second = Source::failed;
    slots_.source_failed(source, now);
}

WallStep Wall::step(std::chrono::nanoseconds now) {
    WallStep step{.requests = std::exchange(restored_, {})};
    end_fade(now);
    const bool is_touched = drag_.is_wanted() || enlargement_.is_on() || dismissed_ != 0;
    if (is_touched && incoming_ && !is_fading() && !incoming_->is_by_hand && !shown_.empty())
        incoming_.reset();  // it waits
    if (!incoming_ && canvas_ == shown_canvas_) follow_hand(now);
    const bool is_left_alone = !is_touched && !(incoming_ && incoming_->is_by_hand);
    if (!incoming_ && is_left_alone) slots_.advance(now);
    if (!is_fading() && is_left_alone) step.plan = follow_assemblage();
    if (!step.plan) step.plan = ask_anew();
    if (incoming_ && incoming_->has_layout && !is_fading()) prepare(step, now);
    step.frame = picture(now);
    step.retired = retire();
    return step;
}

void Wall::end_fade(std::chrono::nanoseconds now) {
    if (!is_fading()) return;
    if (is_arriving()) let_arrive(now);
    if (is_arriving() ? !has_arrived(now) : now - *incoming_->fade_began < duration_of(incoming_->acts))
        return;
    shown_canvas_ = incoming_->canvas;
    shown_ = std::move(incoming_->wall);
    incoming_.reset();
    std::erase_if(left_seats_, [&](const auto& seat) { return find_slot(shown_, seat.first) != nullptr; });
}

/// What has got ready appears now; what does not in time gives way, once the others are there.
void Wall::let_arrive(std::chrono::nanoseconds now) {
    const bool is_too_late = now - *incoming_->waiting >= settings_.patience;
    for (PlacedShot& placed : incoming_->wall) {
        Source& source = sources_.at(placed.shot.source);
        if (placed.began != never || source == Source::failed) continue;
        if (source == Source::ready) {
            placed.began = now;
            slots_.shot_appeared(placed.shot.source, now);
        } else if (is_too_late) {
            source_failed(placed.shot.source, now);
        }
    }
}

bool Wall::has_arrived(std::chrono::nanoseconds now) const {
    return std::ranges::all_of(incoming_->wall, [&](const PlacedShot& placed) {
        if (placed.began == never) return sources_.at(placed.shot.source) == Source::failed;
        return now - placed.began >= settings_.transition.crossfade;
    });
}

/// A new plan where the slots wants something else than what stands or is on its way.
std::optional<WallPlan> Wall::follow_assemblage() {
    const std::vector<WallShot> wanted = slots_.shots();
    if (is_same(incoming_ ? incoming_->wall : shown_, wanted) && !is_canvas_new_) return std::nullopt;
    is_canvas_new_ = false;
    if (!incoming_ && wanted.empty() && shown_.empty()) return std::nullopt;
    WallPlan plan = begin_change(wanted);
    if (plan.items.empty()) return std::nullopt;
    return plan;
}

WallPlan Wall::begin_change(const std::vector<WallShot>& wanted) {
    WallPlan plan{.generation = ++generation_, .canvas = canvas_};
    const bool is_empty = wanted.empty();
    incoming_ =
        Incoming{.generation = generation_, .canvas = canvas_, .has_layout = is_empty, .is_final = is_empty};
    std::map<std::string, int> folders;
    for (const WallShot& shot : wanted) {
        const int group = settings_.nests ? folder_number(shot.key.path, folders) : PlanItem::no_group;
        incoming_->wall.push_back({.shot = shot, .group = group});
        plan.items.push_back(plan_item(shot));
        plan.items.back().group = group;
    }
    return plan;
}

/// A shot that stays keeps its place; one that is new takes over the seat of its slot's last shot.
/// Source: Dynamic Media Assemblage, chapter 4: the new shot in the same position.
PlanItem Wall::plan_item(const WallShot& shot) const {
    PlanItem item{.item = shot.item};
    if (const PlacedShot* same = find_source(shown_, shot.source))
        item.previous = same->placement;
    else if (const PlacedShot* before = find_slot(shown_, shot.slot))
        item.seat = seat_of(before->shot.item, before->placement);
    else if (const auto left = left_seats_.find(shot.slot); left != left_seats_.end())
        item.seat = left->second;
    return item;
}

void Wall::prepare(WallStep& step, std::chrono::nanoseconds now) {
    if (!incoming_->waiting) incoming_->waiting = now;
    if (std::exchange(incoming_->wants_sources, false)) {
        for (const PlacedShot& placed : incoming_->wall) {
            step.requests.push_back(request_of(placed));
            sources_.try_emplace(placed.shot.source, Source::asked);
        }
    }
    if (is_ready()) {
        if (incoming_->acts.empty()) incoming_->acts = acts();
        const bool is_turn = !incoming_->is_by_hand && incoming_->canvas == shown_canvas_;
        const auto due = is_turn ? slots_.due() : std::nullopt;
        if (!due || now >= *due - duration_of(incoming_->acts)) begin_fade(now);
    } else if (now - *incoming_->waiting >= settings_.patience) {
        give_up_waiting(now);
    }
}

bool Wall::is_ready() const {
    const auto is_there = [&](const PlacedShot& placed) {
        return sources_.at(placed.shot.source) == Source::ready;
    };
    if (!incoming_->is_final) return false;
    if (shown_.empty()) return std::ranges::any_of(incoming_->wall, is_there);
    return std::ranges::all_of(incoming_->wall, is_there);
}

void Wall::give_up_waiting(std::chrono::nanoseconds now) {
    for (const PlacedShot& placed : incoming_->wall) {
        if (sources_.at(placed.shot.source) == Source::asked) source_failed(placed.shot.source, now);
    }
}

std::vector<Act> Wall::acts() const {
    TransitionStyle style = settings_.transition;
    const bool is_other_canvas = !shown_.empty() && incoming_->canvas != shown_canvas_;
    if (is_other_canvas || settings_.nests) style.motion = {};  // hulls of groups might meet on the way
    if (is_other_canvas) style.crossfade = {};                  // the old wall fits no more
    if (incoming_->pace) {
        style.motion = style.crossfade = *incoming_->pace;
        style.is_even = true;
    }
    return transition(incoming_->canvas, shown_, incoming_->wall, style);
}

void Wall::begin_fade(std::chrono::nanoseconds now) {
    std::vector<Act>& acts = incoming_->acts;
    const std::chrono::nanoseconds appears = now + duration_of(acts) - acts.back().duration;
    incoming_->fade_began = now;
    if (shown_.empty()) {
        for (PlacedShot& placed : incoming_->wall)
            placed.began = never;
        return let_arrive(now);
    }
    for (PlacedShot& placed : incoming_->wall) {
        const PlacedShot* same = find_source(shown_, placed.shot.source);
        placed.began = same != nullptr ? same->began : appears;
        slots_.shot_appeared(placed.shot.source, placed.began);
    }
    if (!acts.back().motion) acts.back().to = incoming_->wall;
}

std::vector<SourceId> Wall::retire() {
    std::vector<SourceId> retired;
    const std::vector<WallShot> wanted = slots_.shots();
    for (const auto& [source, ready] : sources_) {
        const bool is_coming = incoming_ && find_source(incoming_->wall, source) != nullptr;
        const bool is_wanted = std::any_of(wanted.begin(), wanted.end(),
                                           [id = source](const WallShot& shot) { return shot.source == id; });
        if (!is_coming && !is_wanted && find_source(shown_, source) == nullptr) retired.push_back(source);
    }
    for (const SourceId source : retired)
        sources_.erase(source);
    return retired;
}

Frame Wall::picture(std::chrono::nanoseconds now) const {
    if (!is_fading()) return compose(shown_.empty() ? canvas_ : shown_canvas_, shown_, {}, 0, now);
    if (is_arriving())
        return arriving(incoming_->canvas, incoming_->wall, settings_.transition.crossfade, now);
    return picture_of(incoming_->acts, now - *incoming_->fade_began, incoming_->canvas,
                      settings_.transition.cells, now);
}

}  // namespace vitrine::player
