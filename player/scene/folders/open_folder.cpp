#include "player/scene/folders/open_folder.hpp"

#include <utility>

namespace vitrine::player {

OpenFolder::OpenFolder(std::string folder, const Canvas& canvas, const WallSettings& settings)
    : folder_(std::move(folder)), canvas_(canvas), wall_(std::make_unique<Wall>(canvas, settings)) {}

void OpenFolder::hold(bool is_held) {
    is_held_ = is_held;
    set_controls(controls_);
}

void OpenFolder::set_controls(const ShowControls& controls) {
    controls_ = controls;
    controls_.is_held = is_held_;
    wall_->set_controls(controls_);
}

void OpenFolder::cover(std::chrono::nanoseconds now) {
    if (!covered_) covered_ = now;
}

void OpenFolder::uncover(std::chrono::nanoseconds now) {
    if (covered_) away_ += now - *std::exchange(covered_, std::nullopt);
}

WallStep OpenFolder::step(std::chrono::nanoseconds now) {
    if (covered_) return {.frame = frame_};
    WallStep step = wall_->step(local(now));
    if (wall_->is_touched() || is_in_change(*wall_) || wall_->shown().empty())
        names_.hide();
    else
        names_.stand(wall_->shown(), step.frame.canvas, folder_.empty() ? Box{} : way_back(), local(now));
    step.frame.names = names_.at(local(now));
    frame_ = step.frame;
    for (const ShotRequest& request : step.requests)
        sources_.insert(request.source);
    for (const SourceId source : step.retired) {
        sources_.erase(source);
        missing_.erase(source);
    }
    return step;
}

void OpenFolder::keep_way_back_free(WallPlan& plan) const {
    const PlanItem mark = back_mark_item(canvas_, way_back_);
    if (!plan.way) return plan.items.push_back(mark);
    WayRequest request = *plan.way;
    request.wall.items.push_back(mark.item);
    request.wall.placements.push_back(way_back_);
    request.wall.homes.push_back(way_back_);
    request.wall.pinned.push_back(request.wall.items.size() - 1);
    request.pictures.push_back(mark.item.core.max);
    plan.way = std::make_shared<const WayRequest>(std::move(request));
}

void OpenFolder::set_layout(const Layout& layout) {
    if (!layout.way && !folder_.empty() && layout.is_final) way_back_ = layout.placements.back();
    wall_->set_layout(layout);
}

std::vector<SourceId> OpenFolder::release_sources() {
    missing_.clear();
    const std::set<SourceId> released = std::exchange(sources_, {});
    return {released.begin(), released.end()};
}

std::vector<ShotRequest> OpenFolder::ask_again() {
    std::vector<ShotRequest> requests;
    for (const PlacedShot& placed : wall_->shown()) {
        requests.push_back(request_of(placed));
        sources_.insert(placed.shot.source);
        missing_.insert(placed.shot.source);
    }
    return requests;
}

}  // namespace vitrine::player
