#include "player/wall_link/wall_link.hpp"

#include "base/system/log.hpp"
#include "player/display/screen.hpp"
#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/follower_talk.hpp"
#include "player/scene/acts/leader_talk.hpp"
#include "player/scene/acts/led_show.hpp"
#include "player/stage/show_modes.hpp"
#include "player/stage/stage.hpp"
#include "player/stage/stage_settings.hpp"
#include "player/stage/stages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t max_heard = 1000;  // messages between two frames

std::unique_ptr<BoxTalk> make_talk(const Settings& settings) {
    if (settings.wall.role == WallRole::alone) return nullptr;
    if (settings.wall.role == WallRole::follow) return std::make_unique<FollowerTalk>(box_name(settings));
    const std::int64_t run = std::chrono::system_clock::now().time_since_epoch().count();
    return std::make_unique<LeaderTalk>(box_name(settings), std::max<std::int64_t>(run, 1));
}

WallReport::Box report_of(const std::string& name, const BoxNote& note) {
    return {.name = name,
            .leads = note.leads,
            .is_gone = note.is_gone,
            .run = note.shown ? note.shown->run : 0,
            .generation = note.shown ? note.shown->generation : 0,
            .has_right_clock = note.has_right_clock,
            .difference = note.difference,
            .lacking = note.lacking,
            .fetch_fault = note.fetch_fault};
}

}  // namespace

WallLink::WallLink(EventLoop& loop, const Settings& settings)
    : settings_(settings),
      clock_(settings.wall.role),
      fetch_fault_(settings.wall.fetch_fault),
      wanted_(std::filesystem::path(settings.state.directory) / "wanted"),
      others_(std::make_shared<OtherOutputs>()),
      talk_(make_talk(settings)) {
    if (!talk_) return;
    log::info("wall: this box is '{}' and {}", talk_->box(),
              settings.wall.role == WallRole::lead ? "leads" : "follows");
    if (settings.wall.role == WallRole::lead && !can_lead(settings))
        log::error("wall: a wall of this layout.mode cannot lead others: they keep what they show");
    call(loop);
}

void WallLink::call(EventLoop& loop) {
    const auto begin = [this] {
        log::info("wall: connected to vitrine-link");
        talk_->say_again();
    };
    const auto end = [this](const std::string& why) {
        is_linked_ = false;
        link_says_ = "vitrine-link is not there: " + why;
        complain(link_says_);
    };
    caller_.emplace(loop, settings_.wall.socket,
                    LineCaller::Handlers{
                        .begin = begin, .line = [this](const std::string& line) { hear(line); }, .end = end});
}

void WallLink::follow_clocks(Show& show) {
    const LedShow* const led = show.led();
    const FollowedWall* const followed = show.followed();
    const bool is_changing = led != nullptr && led->is_changing();
    clock_.follow(followed != nullptr ? followed->is_between_acts() : !is_changing);
}

void WallLink::hear(const std::string& line) {
    WallMessage message = wall_message(line);
    if (message.topic.kind == WallTopic::Kind::link) {
        const LinkState state = link_state(message.payload);
        if (state.is_connected && !is_linked_) talk_->say_again();
        if (state.is_connected != is_linked_) log::info("wall: {}", state.says);
        is_linked_ = state.is_connected;
        link_says_ = state.says;
        return;
    }
    const std::string topic = text_of(message.topic);
    if (message.topic.kind != WallTopic::Kind::touch)  // the newest counts, however long no frame is drawn
        std::erase_if(heard_, [&](const WallMessage& old) { return text_of(old.topic) == topic; });
    if (heard_.size() < max_heard) heard_.push_back(std::move(message));
}

/// Logs each complaint once in a row.
void WallLink::complain(const std::string& why) {
    if (why == complaint_) return;
    complaint_ = why;
    log::warning("wall: {}", why);
}

BoxMoment WallLink::moment(std::chrono::nanoseconds now) const {
    const WallClock& shared = clock_.shared().value();
    return {
        .now = now,
        .epoch = shared.epoch(),
        .own = {.has_guides = has_guides_,
                .is_awake = is_awake_,
                .outputs = outputs_,
                .fetch_fault = fetch_fault_.text(),
                .has_right_clock = shared.is_right(),
                .difference = std::chrono::duration_cast<std::chrono::microseconds>(shared.difference())}};
}

void WallLink::direct(Stages& stages, std::span<Screen* const> screens, std::chrono::nanoseconds now) {
    if (!talk_) return;
    outputs_ = outputs_of(screens);
    has_guides_ = stages.has_guides();
    const bool waits = screens.empty() && settings_.wall.role == WallRole::follow;  // for a screen
    for (WallMessage& message : std::exchange(heard_, {})) {
        if (waits && message.topic.kind != WallTopic::Kind::box) {
            heard_.push_back(std::move(message));
            continue;
        }
        try {
            talk_->hear(message);
        } catch (const std::runtime_error& fault) {
            complain(fault.what());
        }
    }
    follow_others();
    if (settings_.wall.role == WallRole::follow) fetch_fault_.look(now);
    if (waits) return;
    const BoxMoment here = moment(now);
    talk_->direct(stages.first().wall(), here);
    touch(stages.first(), here);
}

/// Takes the outputs of the boxes that are there, the leader's guides, and if one was touched. Without the
/// network nobody tells when that ends.
void WallLink::follow_others() {
    *others_ = {};
    for (const auto& [box, note] : talk_->others()) {
        if (note.is_gone) continue;
        others_->has_guides |= note.leads && note.has_guides;
        others_->are_awake |= note.is_awake && is_linked_;
        for (const BoxOutput& output : note.outputs)
            others_->outputs.push_back({.name = box + "/" + output.name,
                                        .width = output.width,
                                        .height = output.height,
                                        .view = {.rotation = rotation_of(output.turned)}});
    }
}

void WallLink::speak(Show& show, std::chrono::nanoseconds now) {
    if (!talk_) return;
    for (const WallMessage& message : talk_->speak(show, moment(now)))
        caller_->send(line_of(message));
    if (const std::string complaint = talk_->complaint(); !complaint.empty()) complain(complaint);
    if (const FollowedWall* followed = show.followed(); followed != nullptr && wanted_.is_due(now))
        wanted_.tell(followed->state().wanted, now);
}

std::vector<BoxOutput> WallLink::outputs_of(std::span<Screen* const> screens) const {
    std::vector<BoxOutput> outputs;
    for (const Screen* screen : screens) {
        const View view = view_of(settings_, screen->width(), screen->height());
        outputs.push_back({.name = screen->name(),
                           .width = screen->width(),
                           .height = screen->height(),
                           .turned = degrees_of(view.rotation)});
    }
    return outputs;
}

/// Touches the stage as other boxes were touched.
void WallLink::touch(Stage& stage, const BoxMoment& here) {
    try {
        for (const InputEvent& event : talk_->take_touches(here))
            stage.handle_input(event);
    } catch (const std::runtime_error& fault) {
        complain(fault.what());
    }
}

std::optional<WallReport> WallLink::report() const {
    if (!talk_) return std::nullopt;
    WallReport report{.name = settings_.wall.name, .own = talk_->box(), .link = link_says_, .boxes = {}};
    BoxNote own = talk_->told().value_or(BoxNote{});
    own.has_right_clock = clock_.shared()->is_right();
    report.boxes.push_back(report_of(talk_->box(), own));
    for (const auto& [box, note] : talk_->others())
        report.boxes.push_back(report_of(box, note));
    return report;
}

}  // namespace vitrine::player
