#pragma once

#include "player/scene/acts/followed_wall.hpp"
#include "player/scene/acts/follower_talk.hpp"
#include "player/scene/acts/leader_talk.hpp"
#include "player/scene/acts/led_folder_wall.hpp"
#include "player/scene/acts/led_panning_wall.hpp"
#include "player/scene/acts/led_wall.hpp"
#include "player/scene/acts/wall_clock.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

using Ns = std::chrono::nanoseconds;

/// A box's own clock, and what it believes of the leader's, as chrony would tell it: from questions that
/// travel as slowly as all else. No box sees the true time.
struct TestClock {
    Ns offset{0};
    double ppm = 0;
    bool is_disciplined = true;
    std::optional<Ns> correction = {};            // real = steady + correction
    std::vector<std::pair<Ns, Ns>> answers = {};  // (round trip, correction) of the last questions

    Ns steady(Ns truth) const {
        return offset + truth +
               Ns(static_cast<std::int64_t>(static_cast<double>(truth.count()) * ppm * 1e-6));
    }

    ClockReading read(Ns truth) const {
        return {.steady = steady(truth),
                .real = steady(truth) + correction.value_or(Ns(0)),
                .is_right = correction.has_value() && is_disciplined};
    }

    /// The answer of the leader to a question, whose two ways took so long.
    void take_answer(Ns truth, Ns there, Ns back, Ns leaders_real) {
        const Ns asked = steady(truth - there - back);
        const Ns middle = asked + (steady(truth) - asked) / 2;
        answers.emplace_back(there + back, leaders_real - middle);
        if (answers.size() > 4) answers.erase(answers.begin());
        correction = std::ranges::min_element(answers)->second;
    }
};

/// A frame that a box has shown.
struct ShownFrame {
    Ns truth{0};
    std::size_t content = 0;  // of which picture of which file is where
    bool is_whole = false;    // something is shown, and all of it has pictures
};

/// A box of the wall: its show, its half of the talk, its clock and its sources.
struct TestBox {
    std::string name;
    TestClock clock;
    std::unique_ptr<Show> show;
    std::unique_ptr<BoxTalk> talk;
    std::optional<WallClock> time = {};
    bool is_linked = true;
    bool is_dark = false;  // none of its screens shows the wall
    std::int64_t next_frame = 0;
    std::map<SourceId, ShotRequest> playing = {};
    std::map<SourceId, Ns> ready_at = {};
    std::set<SourceId> ready = {};
    std::set<std::string> missing = {};  // files that do not come
    std::set<std::string> awaited = {};  // files that come once they are in the store
    Ns slower{0};                        // by which it reads files more slowly
    std::map<SourceId, Ns> seen = {};    // how far each film was seen
    std::vector<ShownFrame> frames = {};
    std::map<Ns, Ns> began = {};  // by its own time, when each change was first seen, in true time
    std::size_t back = 0;         // jumps back in time
    std::size_t gaps = 0;         // frames that were not whole, after the first that was
    Frame last = {};
};

/// The boxes of one wall and all that travels between them, in virtual time.
class SharedHouse {
  public:
    static constexpr int rate = 30;                               // frames a second
    static constexpr Ns rounding = std::chrono::microseconds(1);  // of the times of frames

    struct Options {
        std::uint64_t seed = 1;
        int followers = 2;
        bool is_disciplined = true;
        double cuts = 0;   // chance of a cut of a box's connection, a second
        double heals = 1;  // chance that a cut ends, a second
        std::size_t max_act_bytes = LeaderTalk::max_told_bytes;
        std::function<Layout(const WallPlan&)> lay_out = side_by_side;
        std::vector<MediaRecord> records = {film("a", 2), photo("b"), film("c", 1), photo("d"), film("e", 3)};
        WallSettings wall = {
            .slots = {.count = 3, .order = ShotOrder::name, .dwell = std::chrono::seconds(2)},
            .photos_drift = true,
            .lead = LedWall::lead,
            .touch_lead = LedWall::touch_lead};
        std::optional<PanSettings> pan = {};  // the leader's wall pans
    };

    explicit SharedHouse(Options options) : options_(std::move(options)), random_(options_.seed) {
        boxes.push_back(box("lead"));
        start_leader();
        for (int i = 0; i < options_.followers; ++i) {
            boxes.push_back(box("f" + std::to_string(i)));
            if (options_.is_disciplined) ask_for_time(boxes.back());
            start_follower(boxes.size() - 1);
        }
    }

    Ns truth{0};
    std::vector<TestBox> boxes;  // the leader first
    std::size_t faults = 0;      // messages that were not understood

    LedWall& led() { return dynamic_cast<LedWall&>(*boxes[0].show); }

    FollowedWall& followed(std::size_t i) { return *boxes[i].show->followed(); }

    void start_leader() {
        TestBox& lead = boxes[0];
        forget(lead);
        lead.show = leading_show();
        lead.talk = std::make_unique<LeaderTalk>(lead.name, ++runs_, options_.max_act_bytes);
        lead.clock.correction = Ns(0);
        begin(lead);
    }

    /// Replaces the leader's show, as new settings do.
    void renew_leader(WallSettings settings) {
        options_.wall = std::move(settings);
        forget(boxes[0]);
        boxes[0].show = leading_show();
        boxes[0].talk->begin_anew();
    }

    /// Starts the leader anew with a wall that pans.
    void pan(const PanSettings& settings, std::function<Layout(const WallPlan&)> lay_out) {
        kill(0);
        options_.pan = settings;
        options_.lay_out = std::move(lay_out);
        start_leader();
    }

    void start_follower(std::size_t i) {
        TestBox& box = boxes[i];
        forget(box);
        box.show = std::make_unique<FollowedWall>(Canvas{1280, 720}, SourceId{0});
        box.talk = std::make_unique<FollowerTalk>(box.name);
        begin(box);
    }

    /// Ends a box without a word; the others hear that it is gone.
    void kill(std::size_t i) {
        boxes[i].show.reset();
        boxes[i].talk.reset();
        publish({.topic = {.kind = WallTopic::Kind::box, .box = boxes[i].name},
                 .is_retained = true,
                 .payload = i == 0 ? R"({"gone":true,"leads":true})" : R"({"gone":true})"});
    }

    void cut(std::size_t i) { boxes[i].is_linked = false; }

    void heal(std::size_t i) {
        boxes[i].is_linked = true;
        join(boxes[i]);
    }

    void run(Ns duration) {
        for (const Ns end = truth + duration; truth < end; truth += std::chrono::milliseconds(1))
            step();
    }

  private:
    struct Travelling {
        Ns arrives{0};
        std::size_t box = 0;
        WallMessage message;
    };

    TestBox box(std::string name) {
        const auto spread = [&](double most) { return std::uniform_real_distribution(-most, most)(random_); };
        const double offset = boxes.empty() ? 0 : spread(60);
        return {.name = std::move(name),
                .clock = {.offset =
                              std::chrono::hours(24 * 365 * 50) + Ns(static_cast<std::int64_t>(offset * 1e9)),
                          .ppm = spread(100),
                          .is_disciplined = options_.is_disciplined},
                .show = {},
                .talk = {}};
    }

    std::unique_ptr<Show> leading_show() const {
        const Canvas canvas{1280, 720};
        std::unique_ptr<Show> show;
        if (options_.pan)
            show = std::make_unique<LedPanningWall>(canvas, *options_.pan);
        else if (options_.wall.nests)
            show = std::make_unique<LedFolderWall>(canvas, options_.wall);
        else
            show = std::make_unique<LedWall>(canvas, options_.wall);
        show->set_catalogue(options_.records);
        return show;
    }

    void forget(TestBox& box) {
        box.playing.clear();
        box.ready_at.clear();
        box.ready.clear();
        box.seen.clear();
        box.last = {};
        was_whole_[&box - boxes.data()] = false;
    }

    void begin(TestBox& box) {
        box.time.emplace(box.clock.read(truth));
        box.next_frame = 0;
        if (box.is_linked) join(box);
    }

    /// The broker gives a box all that it has kept.
    void join(TestBox& box) {
        if (box.talk) box.talk->say_again();
        const std::size_t i = static_cast<std::size_t>(&box - boxes.data());
        for (const auto& [topic, message] : kept_)
            if (i != 0 || !is_of_leader(message.topic.kind)) send(i, message);
    }

    Ns way() { return std::chrono::microseconds(std::uniform_int_distribution(15'000, 25'000)(random_)); }

    void send(std::size_t i, const WallMessage& message) {
        Ns& last = last_arrival_[i];  // nothing overtakes
        last = std::max(last, truth + way());
        travelling_.push_back({.arrives = last, .box = i, .message = message});
    }

    void publish(const WallMessage& message) {
        if (message.is_retained) kept_[text_of(message.topic)] = message;
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].name != message.topic.box && !(i == 0 && is_of_leader(message.topic.kind)))
                send(i, message);
    }

    void step() {
        for (std::size_t k = 0; k < travelling_.size();) {
            if (travelling_[k].arrives > truth) {
                ++k;
                continue;
            }
            Travelling arrived = std::move(travelling_[k]);
            travelling_.erase(travelling_.begin() + static_cast<std::ptrdiff_t>(k));
            TestBox& box = boxes[arrived.box];
            if (box.talk && box.is_linked) hear(box, arrived.message);
        }
        if (truth.count() % 1'000'000'000 == 0) ask_for_time();
        for (std::size_t i = 0; i < boxes.size(); ++i)
            if (boxes[i].show && !boxes[i].is_dark) follow(boxes[i], i);
    }

    void hear(TestBox& box, const WallMessage& message) {
        try {
            box.talk->hear(message);
        } catch (const std::runtime_error&) {
            ++faults;
        }
    }

    void ask_for_time() {
        for (std::size_t i = 1; i < boxes.size(); ++i) {
            if (options_.cuts > 0 && boxes[i].is_linked &&
                std::uniform_real_distribution(0.0, 1.0)(random_) < options_.cuts)
                cut(i);
            else if (!boxes[i].is_linked && options_.cuts > 0 &&
                     std::uniform_real_distribution(0.0, 1.0)(random_) < options_.heals)
                heal(i);
            if (boxes[i].is_linked && options_.is_disciplined) ask_for_time(boxes[i]);
        }
    }

    void ask_for_time(TestBox& box) {
        const Ns there = way();
        const Ns back = way();
        box.clock.take_answer(truth, there, back, boxes[0].clock.read(truth - back).real);
    }

    bool is_leader_changing() { return boxes[0].show->led()->is_changing(); }

    void follow(TestBox& box, std::size_t i) {
        const bool may_jump = i == 0 ? !is_leader_changing() : box.show->followed()->is_between_acts();
        box.time->follow(box.clock.read(truth), may_jump);
        for (const auto& [source, at] : std::map(box.ready_at))
            if (at <= truth) {
                box.ready_at.erase(source);
                const ShotRequest& request = box.playing[source];
                const bool is_stored = request.shot.stored.has_value();
                if (box.missing.contains(request.path) ||
                    (box.awaited.contains(request.path) && !is_stored)) {
                    box.show->source_failed(source, box.time->now());
                    continue;
                }
                box.ready.insert(source);
                box.show->source_ready(source);
            }
        const std::int64_t frame = box.time->now().count() * rate / 1'000'000'000;
        if (frame < box.next_frame) return;
        box.next_frame = frame + 1;
        draw(box, i, Ns(frame * 1'000'000'000 / rate));
    }

    void draw(TestBox& box, std::size_t i, Ns now) {
        const BoxMoment moment{
            .now = now, .epoch = box.time->epoch(), .own = {.has_right_clock = box.time->is_right()}};
        box.talk->direct(*box.show, moment);
        WallStep step = box.show->step(now);
        for (const ShotRequest& request : step.requests) {
            if (box.playing.emplace(request.source, request).second || !box.ready.contains(request.source))
                box.ready_at[request.source] =
                    truth + box.slower +
                    std::chrono::milliseconds(std::uniform_int_distribution(20, 300)(random_));
            box.playing[request.source] = request;
        }
        if (step.plan && !step.plan->way) box.show->set_layout(options_.lay_out(*step.plan));
        if (step.plan && step.plan->way) {
            Layout layout{.canvas = step.plan->canvas, .generation = step.plan->generation, .is_final = true};
            layout.way = std::make_shared<const WallWay>(way_to(*step.plan->way));
            box.show->set_layout(layout);
        }
        note(box, i, step.frame);
        for (const WallMessage& message : box.talk->speak(*box.show, moment))
            if (box.is_linked) publish(message);
        for (const SourceId source : step.retired) {
            box.playing.erase(source);
            box.ready.erase(source);
            box.ready_at.erase(source);
            box.seen.erase(source);
        }
        note_begins(box, i, now);
        box.last = std::move(step.frame);
    }

    /// The frame as it was seen: each film's picture at 25 a second.
    void note(TestBox& box, std::size_t i, const Frame& frame) {
        std::size_t content = 0;
        bool is_whole = !frame.items.empty();
        const auto add = [&](std::size_t value) { content = content * 1'000'003 + value; };
        for (const DrawItem& item : frame.items) {
            const ShotRequest& request = box.playing[item.source];
            is_whole &= box.ready.contains(item.source);
            add(std::hash<std::string>()(request.path) +
                static_cast<std::size_t>(request.shot.begin.count()));
            if (request.kind == MediaKind::film)
                add(static_cast<std::size_t>(item.local.count() / 40'000'000));
            add(std::hash<double>()(item.placement.scale));
            add(std::hash<double>()(item.placement.offset.y));
            const double x = item.placement.offset.x - frame.view.x;
            if (options_.pan)  // the leader adds the way up, frame by frame
                add(static_cast<std::size_t>(std::lround(x * 1e3)));
            else
                add(std::hash<double>()(x));
            add(static_cast<std::size_t>(std::lround(item.alpha * 1e6)));
            add(static_cast<std::size_t>(std::lround(item.filler_light * 1e6)));
            Ns& seen = box.seen[item.source];
            if (item.local + rounding < seen) ++box.back;
            seen = std::max(seen, item.local);
        }
        box.frames.push_back({.truth = truth, .content = content, .is_whole = is_whole});
        if (was_whole_[static_cast<std::ptrdiff_t>(i)] && !is_whole) ++box.gaps;
        if (is_whole) was_whole_[static_cast<std::ptrdiff_t>(i)] = true;
    }

    void note_begins(TestBox& box, std::size_t i, Ns now) {
        if (options_.pan || options_.wall.nests) return;
        if (i == 0) {
            const std::optional<WallChange>& change = led().parts().change;
            if (is_leader_changing() && now >= change->began) box.began.try_emplace(change->began, truth);
            return;
        }
        const WallAct* const act = box.show->followed()->shown();
        if (act == nullptr || !act->change) return;
        if (now + box.time->epoch() - act->epoch >= act->change->began)
            box.began.try_emplace(act->change->began, truth);
    }

    Options options_;
    std::mt19937_64 random_;
    std::int64_t runs_ = 0;
    std::map<std::string, WallMessage> kept_;
    std::deque<Travelling> travelling_;
    std::map<std::size_t, Ns> last_arrival_;
    std::map<std::ptrdiff_t, bool> was_whole_;
};

/// Starts the second follower anew after the others have gone on for some seconds.
inline void bring_late_box(SharedHouse& house) {
    house.run(std::chrono::seconds(7));
    house.kill(2);
    house.run(std::chrono::seconds(9));
    house.start_follower(2);
}

/// The first frame with a picture that a box has shown. nullptr: none.
inline const ShownFrame* first_picture(const TestBox& box) {
    const auto first =
        std::ranges::find_if(box.frames, [](const ShownFrame& frame) { return frame.content != 0; });
    return first == box.frames.end() ? nullptr : &*first;
}

/// The share of the leader's frames that a box has shown at the same time, from some time on.
inline double share_in_step(const TestBox& lead, const TestBox& box, Ns from) {
    std::size_t same = 0;
    std::size_t all = 0;
    auto near = box.frames.begin();
    for (const ShownFrame& frame : lead.frames) {
        if (frame.truth < from) continue;
        while (std::next(near) != box.frames.end() &&
               std::chrono::abs(std::next(near)->truth - frame.truth) <=
                   std::chrono::abs(near->truth - frame.truth))
            ++near;
        ++all;
        if (near->content == frame.content) ++same;
    }
    return all == 0 ? 0 : static_cast<double>(same) / static_cast<double>(all);
}

/// The times by which the changes of acts began apart on two boxes, sorted.
inline std::vector<Ns> begins_apart(const TestBox& lead, const TestBox& box) {
    std::vector<Ns> apart;
    for (const auto& [change, at] : box.began)
        if (const auto same = lead.began.find(change); same != lead.began.end())
            apart.push_back(std::chrono::abs(same->second - at));
    std::ranges::sort(apart);
    return apart;
}

}  // namespace vitrine::player
