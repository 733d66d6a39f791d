#include "player/stage/stages.hpp"

#include "base/settings/output_words.hpp"
#include "base/settings/settings.hpp"
#include "base/system/log.hpp"
#include "player/display/screen.hpp"
#include "player/scene/chosen_sound.hpp"
#include "player/scene/show.hpp"
#include "player/stage/output_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

namespace vitrine::player {

namespace {

constexpr auto guide_time = std::chrono::minutes(10);
constexpr auto renewal_patience = std::chrono::seconds(8);  // with a new wall that is not complete

}  // namespace

Stages::Stages(const Settings& settings, SourcePool& sources, bool awaits_sources,
               std::shared_ptr<const OtherOutputs> others)
    : settings_(settings), sources_(sources), awaits_sources_(awaits_sources), others_(std::move(others)) {
    make_anew();
}

bool Stages::claim_renewal(std::chrono::nanoseconds now) {
    if (!is_asked_anew_ || !pace_.is_free(now)) return false;
    is_asked_anew_ = false;
    pace_.note_change(now);
    picture_kept_until_ = now + renewal_patience;
    return true;
}

void Stages::make_anew() {
    const auto folders = output_folders_named(settings_.output.folders).value();
    std::map<std::string, std::size_t> number_of_folder{{"", 0}};
    for (const auto& [output, folder] : folders)
        number_of_[output] = number_of_folder.emplace(folder, number_of_folder.size()).first->second;
    stages_.resize(number_of_folder.size());
    for (const auto& [folder, i] : number_of_folder) {
        const StageOptions options{.number = i,
                                   .folder = folder,
                                   .awaits_sources = awaits_sources_,
                                   .others = i == 0 ? others_ : nullptr};
        stages_[i] = std::make_unique<Stage>(settings_, options, sources_);
        stages_[i]->set_controls(controls_);
    }
    arranged_.clear();
}

void Stages::set_catalogue(const RecordList& records, const ShowHints& hints) {
    for (const auto& stage : stages_)
        stage->set_catalogue(records, hints);
}

void Stages::set_controls(const ShowControls& controls) {
    controls_ = controls;
    for (const auto& stage : stages_) {
        ShowControls own = controls_;
        if (const auto wall = arranged_.find(stage->files().folder()); wall != arranged_.end())
            own.arranged = wall->second;
        stage->set_controls(own);
    }
}

void Stages::arrange(const ArrangedWalls& walls) {
    for (const auto& [folder, wall] : walls)
        arranged_[folder] = std::make_shared<const ArrangedWall>(wall);
    set_controls(ShowControls(controls_));
}

ArrangedWalls Stages::arrangement() const {
    ArrangedWalls walls;
    for (const auto& stage : stages_) {
        const Show& wall = stage->wall();
        if (!stage->is_seen() || !wall.opened_folder().empty()) continue;
        std::vector<SlotShot> shots = wall.standing();
        if (shots.empty() || shots.front().seat.area <= 0) continue;  // it keeps no places
        walls[stage->files().folder()] = {.canvas = stage->frame().canvas, .shots = std::move(shots)};
    }
    return walls;
}

Stage& Stages::stage_of(const Screen& screen) {
    const auto found = number_of_.find(screen.name());
    return *stages_[found == number_of_.end() ? 0 : found->second];
}

void Stages::set_screens(std::span<Screen* const> screens, std::chrono::nanoseconds now) {
    std::map<const Stage*, std::vector<Screen*>> given;
    for (Screen* screen : screens)
        given[&stage_of(*screen)].push_back(screen);
    for (const auto& stage : stages_)
        stage->set_screens(std::move(given[stage.get()]), now);
}

void Stages::handle_input(const Screen& screen, InputEvent event) {
    Stage& stage = stage_of(screen);
    const auto place = [&](auto& one) {
        if constexpr (requires { one.at; }) one.at = stage.canvas_point(screen, one.at);
    };
    std::visit(place, event);
    stage.handle_input(event);
}

bool Stages::toggle_guides() {
    has_guides_ = !has_guides_;
    guides_end_.reset();
    return has_guides_;
}

void Stages::show(std::chrono::nanoseconds now, Renderer* renderer, bool waits_for_wall) {
    if (has_guides_ && !guides_end_) guides_end_ = now + guide_time;
    if (has_guides_ && now >= *guides_end_) has_guides_ = false;
    const bool has_guides = has_guides_ || (others_ && others_->has_guides);
    for (const auto& stage : stages_) {
        if (!stage->is_seen()) continue;
        stage->show_guides(has_guides);
        stage->show(now, renderer, waits_for_wall || now < picture_kept_until_);
    }
    log_counts();
}

void Stages::forget_uploads() {
    for (const auto& stage : stages_)
        stage->forget_uploads();
}

std::vector<AudibleShot> Stages::audible() const {
    std::vector<AudibleShot> shots;
    for (const auto& stage : stages_)
        for (AudibleShot& shot : stage->audible())
            shots.push_back(std::move(shot));
    return shots;
}

std::vector<SlotShot> Stages::standing() const {
    std::vector<SlotShot> shots;
    for (const auto& stage : stages_)
        for (SlotShot& shot : stage->wall().standing())
            shots.push_back(std::move(shot));
    return shots;
}

void Stages::log_counts() {
    for (const auto& stage : stages_) {
        const auto [logged, is_new] = logged_.try_emplace(stage->files().folder(), 0);
        const std::size_t count = stage->wall().count();
        if (logged->second == count) continue;
        logged->second = count;
        log::info("wall of {} {}{}", logged->second, logged->second == 1 ? "item" : "items",
                  stage->files().folder().empty() ? "" : fmt::format(" of '{}'", stage->files().folder()));
    }
}

Stage& first_seen(Stages& stages) {
    const auto has_screen = [](const auto& stage) { return !stage->screens().empty(); };
    const auto seen = std::ranges::find_if(stages.all(), has_screen);
    return seen != stages.all().end() ? **seen : stages.first();
}

}  // namespace vitrine::player
