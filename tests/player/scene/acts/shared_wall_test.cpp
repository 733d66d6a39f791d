// Boxes of one wall show the same frames at the same time, whatever the network does.

#include "tests/player/scene/acts/shared_house.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <set>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

/// Seconds of virtual time. VITRINE_SHARED=1800: half an hour.
Ns duration(Ns usual) {
    const char* const wanted = std::getenv("VITRINE_SHARED");
    return wanted != nullptr ? std::chrono::seconds(std::atoi(wanted)) : usual;
}

Ns percentile(const std::vector<Ns>& sorted, double share) {
    return sorted.empty() ? 1h
                          : sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

/// A photo with a short film inside its file.
MediaRecord moving_photo(const std::string& path) {
    MediaRecord record = photo(path);
    Shot shot = film("x", 1, 3s).shots[0];
    shot.stored = StoredShot{.file = store_id("x", 1, 2) + "/0.mkv", .width = 64, .height = 36};
    record.film = InnerFilm{.shot = shot, .width = 1920, .height = 1080};
    return record;
}

/// A leader and a follower whose wall stands.
SharedHouse resting_house(int slots = 3, std::vector<MediaRecord> records = {}) {
    SharedHouse::Options options{.seed = 4, .followers = 1};
    options.wall = {
        .slots = {.count = slots, .order = ShotOrder::name, .dwell = 1h}, .lead = 500ms, .touch_lead = 60ms};
    if (slots > 5) options.records = photos(slots);
    if (!records.empty()) options.records = std::move(records);
    SharedHouse house(options);
    house.run(6s);
    return house;
}

/// A hand on the first shot of the leader's wall.
class Hand {
  public:
    explicit Hand(SharedHouse& house)
        : house_(house), source_(house.led().parts().shown.front().shot.source) {}

    /// Moves by a way, within a frame.
    void drag(Vec2 way) {
        at_ = at_ + way;
        touch(Gesture::Kind::drag, way);
        house_.run(33ms);
    }

    void drop() { touch(Gesture::Kind::drop, {}); }

  private:
    void touch(Gesture::Kind kind, Vec2 way) {
        house_.led().handle_gesture(
            {.kind = kind, .touch = 1, .subject = source_, .at = at_, .from = from_, .moved = way});
    }

    SharedHouse& house_;  // outlives this
    SourceId source_;
    Vec2 from_{200, 360};
    Vec2 at_ = from_;
};

}  // namespace

TEST_CASE("three boxes with clocks of their own show the same frames, and changes begin together") {
    SharedHouse house({.seed = 3, .cuts = 0.01});
    house.run(duration(60s));
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        const double same = share_in_step(house.boxes[0], house.boxes[i], 10s);
        const std::vector<Ns> apart = begins_apart(house.boxes[0], house.boxes[i]);
        INFO("box ", i, ": ", same, " in step, ", apart.size(), " changes, p99 ",
             percentile(apart, 0.99).count());
        CHECK(same >= 0.999);
        CHECK(apart.size() >= 10);
        CHECK(percentile(apart, 0.99) <= 16'700us);
        CHECK(house.boxes[i].back == 0);
        CHECK(house.boxes[i].gaps == 0);
    }
    CHECK(house.faults == 0);
}

TEST_CASE("changes that take no time are followed, too") {
    SharedHouse::Options options{.seed = 3, .followers = 1};
    options.wall.transition.duration = 0ns;
    SharedHouse house(options);
    house.run(30s);
    REQUIRE(house.followed(1).shown() != nullptr);
    CHECK(house.followed(1).shown()->name.generation >= 5);
    CHECK(share_in_step(house.boxes[0], house.boxes[1], 10s) >= 0.999);
    CHECK(house.boxes[1].gaps == 0);
    CHECK(house.faults == 0);
}

TEST_CASE("a cut of a second delays no change") {
    SharedHouse house({.seed = 6, .cuts = 0.3});
    house.run(90s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        const std::vector<Ns> apart = begins_apart(house.boxes[0], house.boxes[i]);
        REQUIRE(apart.size() >= 8);
        CHECK(apart.back() <= 16'700us);
    }
}

TEST_CASE("boxes whose clocks nobody keeps right are not in step") {
    SharedHouse house({.seed = 3, .is_disciplined = false});
    house.run(30s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i)
        CHECK(share_in_step(house.boxes[0], house.boxes[i], 10s) < 0.9);
}

TEST_CASE("a box that comes late is in step with its first picture") {
    SharedHouse house({.seed = 5});
    bring_late_box(house);
    const Ns started = house.truth;
    house.boxes[2].frames.clear();
    house.run(6s);
    const ShownFrame* const first = first_picture(house.boxes[2]);
    REQUIRE(first != nullptr);
    CHECK(first->is_whole);
    CHECK(first->truth - started < 2s);
    CHECK(share_in_step(house.boxes[0], house.boxes[2], first->truth) >= 0.999);
}

TEST_CASE("a box that joins says at once that it shows the wall") {
    SharedHouse house({.seed = 5});
    bring_late_box(house);
    while (house.followed(2).shown() == nullptr && house.truth < 20s)
        house.run(10ms);
    house.run(100ms);
    CHECK(house.boxes[0].talk->others().at("f1").shown.has_value());
}

TEST_CASE("a box whose clock is not right yet waits with its first picture, and then does not jump") {
    SharedHouse house({.seed = 9});
    house.run(7s);
    house.kill(2);
    house.run(2500ms);
    TestBox& box = house.boxes[2];
    box.clock.correction.reset();  // it has just booted; its first answer comes half a second later
    box.clock.answers.clear();
    house.start_follower(2);
    box.frames.clear();
    house.run(6s);
    const auto first = std::ranges::find_if(box.frames, &ShownFrame::is_whole);
    REQUIRE(first != box.frames.end());
    CHECK(box.back == 0);
    CHECK(share_in_step(house.boxes[0], box, first->truth) >= 0.999);
}

TEST_CASE("leader and followers are killed and connections cut: nothing is dark, goes back or is lost") {
    SharedHouse house({.seed = 11, .cuts = 0.05, .heals = 0.4});
    std::mt19937_64 random(7);
    const Ns end = duration(60s);
    while (house.truth < end) {
        house.run(std::chrono::milliseconds(std::uniform_int_distribution(500, 9000)(random)));
        const std::size_t victim = random() % house.boxes.size();
        house.kill(victim);
        house.run(std::chrono::milliseconds(std::uniform_int_distribution(100, 4000)(random)));
        if (victim == 0)
            house.start_leader();
        else
            house.start_follower(victim);
    }
    house.run(3s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i)
        if (!house.boxes[i].is_linked) house.heal(i);
    house.run(12s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        CHECK(house.boxes[i].gaps == 0);
        CHECK(house.boxes[i].back == 0);
        CHECK(share_in_step(house.boxes[0], house.boxes[i], house.truth - 4s) >= 0.99);
    }
    CHECK(house.faults == 0);
}

TEST_CASE("a box that has not got a shot shows the last act, says so, and comes as soon as it has it") {
    SharedHouse house({.seed = 2});
    house.run(6s);
    TestBox& box = house.boxes[1];
    box.missing = {"e", "d"};
    bool has_said = false;
    for (int second = 0; second < 8; ++second) {
        house.run(1s);
        REQUIRE(box.talk->told());
        has_said |= !box.talk->told()->lacking.empty();
    }
    CHECK(has_said);
    CHECK(box.gaps == 0);
    CHECK(share_in_step(house.boxes[0], house.boxes[2], house.truth - 5s) >= 0.99);
    box.missing.clear();
    house.run(10s);
    CHECK(share_in_step(house.boxes[0], box, house.truth - 3s) >= 0.99);
}

TEST_CASE("a box that has not got a shot tells its file in the store until it has it") {
    MediaRecord record = photo("a");
    record.shots[0].stored = StoredShot{.file = store_id("a", 1, 2) + "/photo", .width = 64, .height = 36};
    SharedHouse house({.seed = 4, .followers = 1, .records = {record}});
    house.boxes[1].missing = {"a"};
    house.run(3s);
    CHECK(house.followed(1).state().wanted == std::set{record.shots[0].stored->file});
    house.boxes[1].missing.clear();
    house.run(15s);
    CHECK(house.followed(1).state().wanted.empty());
}

TEST_CASE("a box whose screens were dark shows the last act until it has the shots of the newest") {
    SharedHouse house({.seed = 6});
    house.run(8s);
    TestBox& box = house.boxes[2];
    box.is_dark = true;
    house.run(30s);
    box.is_dark = false;
    box.slower = 500ms;
    house.run(4s);
    CHECK(box.gaps == 0);
    CHECK(box.frames.back().content == house.boxes[0].frames.back().content);
}

TEST_CASE("boxes that follow hear that the wall is paused, and that it goes on") {
    SharedHouse house({.seed = 6});
    house.run(8s);
    for (const bool is_paused : {true, false}) {
        house.led().set_controls({.is_paused = is_paused});
        house.run(2s);
        for (const std::size_t i : {1U, 2U})
            CHECK(house.followed(i).shown()->is_paused == is_paused);
    }
    CHECK(house.boxes[1].gaps == 0);
}

TEST_CASE("a leader whose settings were read again is followed: its new wall comes at once, in step") {
    SharedHouse::Options options{.seed = 4, .followers = 2};
    SharedHouse house(options);
    house.run(20s);
    const std::size_t faults = house.faults;
    WallSettings settings = options.wall;
    settings.slots.count = 2;
    house.renew_leader(settings);
    house.run(5s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i) {
        CHECK(house.followed(i).standing().size() == 2);
        CHECK(house.boxes[i].gaps == 0);
    }
    const Ns renewed = house.truth;
    house.run(20s);
    for (std::size_t i = 1; i < house.boxes.size(); ++i)
        CHECK(share_in_step(house.boxes[0], house.boxes[i], renewed) >= 0.999);
    CHECK(house.faults == faults);
}

TEST_CASE("an act that is too long for the others is not told, and the leader says so") {
    SharedHouse house({.seed = 5, .followers = 1});
    house.run(6s);
    CHECK(house.boxes[0].talk->complaint() == "");
    CHECK(house.boxes[1].frames.back().is_whole);

    SharedHouse silent({.seed = 5, .followers = 1, .max_act_bytes = 100});
    silent.run(6s);
    CHECK(silent.boxes[0].talk->complaint().find("more than 100 bytes") != std::string::npos);
    CHECK_FALSE(silent.boxes[1].frames.back().is_whole);
}

TEST_CASE("a notice that is in the store a moment after it was found comes to all boxes at once") {
    SharedHouse house({});
    house.run(5s);
    MediaRecord notice = photo("!NOW fire.jpg");
    for (std::size_t i = 1; i < house.boxes.size(); ++i)
        house.boxes[i].awaited = {notice.path};
    house.led().set_catalogue(RecordList({std::make_shared<const MediaRecord>(notice)}), {});
    house.run(600ms);
    notice.shots.front().stored =
        StoredShot{.file = "0123456789abcdef/photo", .begin = 0s, .width = 640, .height = 360};
    house.led().set_catalogue(RecordList({std::make_shared<const MediaRecord>(notice)}), {});
    house.run(3500ms);
    for (const TestBox& box : house.boxes) {
        REQUIRE_FALSE(box.last.items.empty());
        for (const DrawItem& item : box.last.items)
            CHECK(box.playing.at(item.source).path == notice.path);
    }
}

TEST_CASE("if the way of a change is too long to be told, the others fade to its end as it begins") {
    SharedHouse::Options options{.seed = 5, .followers = 1, .max_act_bytes = 3000};
    options.wall.slots.dwell = 6s;
    SharedHouse house(options);
    int faded = 0;
    for (int second = 0; second < 40; ++second) {
        house.run(1s);
        faded += house.boxes[0].talk->complaint().find("fade to its end") != std::string::npos ? 1 : 0;
    }
    CHECK(faded >= 30);
    CHECK(share_in_step(house.boxes[0], house.boxes[1], 10s) >= 0.7);  // but while it fades
    CHECK(house.boxes[1].gaps == 0);
    CHECK(house.boxes[1].back == 0);
    CHECK(house.faults == 0);
}

TEST_CASE("a shot in a hand is seen above the wall on all boxes, where the hand was a moment ago") {
    SharedHouse house = resting_house();
    TestBox& lead = house.boxes[0];
    TestBox& follower = house.boxes[1];
    const std::size_t shots = lead.last.items.size();
    Hand hand(house);
    std::vector<Vec2> places;
    for (int k = 0; k < 12; ++k) {
        hand.drag({20, 10});
        places.push_back(lead.last.items.back().placement.offset);
        if (k < 4) continue;
        const Vec2 seen = follower.last.items.back().placement.offset;
        CHECK(std::find(places.end() - 4, places.end(), seen) != places.end());  // 33 ms each
    }
    house.run(2s);  // the hand rests
    CHECK(lead.last.items.size() > shots);
    CHECK(lead.frames.back().content == follower.frames.back().content);
    hand.drop();
    house.run(1200ms);
    CHECK(lead.last.items.size() == shots);
    CHECK(lead.frames.back().content == follower.frames.back().content);
}

TEST_CASE("a shot in a hand goes back to its place on boxes that hear no more of it") {
    SharedHouse house = resting_house();
    const std::size_t shots = house.boxes[1].last.items.size();
    Hand hand(house);
    hand.drag({20, 10});
    hand.drag({20, 10});
    house.run(300ms);
    CHECK(house.boxes[1].last.items.size() > shots);
    house.cut(1);
    house.run(2500ms);
    CHECK(house.boxes[1].last.items.size() > shots);  // a slow leader draws a picture a second
    house.run(1s);
    CHECK(house.boxes[1].last.items.size() == shots);
    CHECK(house.boxes[1].gaps == 0);
}

TEST_CASE("a shot that is as large as the screen is asked for in that size on all boxes") {
    SharedHouse house = resting_house(9);
    const WallShot shot = house.led().parts().shown.front().shot;
    const int before = house.boxes[0].playing.at(shot.source).width;
    house.led().handle_gesture({.kind = Gesture::Kind::tap,
                                .touch = 1,
                                .subject = shot.source,
                                .at = {200, 360},
                                .from = {200, 360}});
    house.run(2s);
    const auto width_on = [&](TestBox& box) { return box.playing.at(box.last.items.back().source).width; };
    CHECK(width_on(house.boxes[0]) > before);
    CHECK(width_on(house.boxes[1]) == width_on(house.boxes[0]));
    CHECK(house.boxes[0].frames.back().content == house.boxes[1].frames.back().content);
}

TEST_CASE("the film of a tapped photo plays on all boxes in step") {
    SharedHouse house = resting_house(3, {moving_photo("a"), photo("b"), photo("c")});
    TestBox& lead = house.boxes[0];
    TestBox& follower = house.boxes[1];
    const std::size_t shots = follower.last.items.size();
    const std::size_t sources = follower.playing.size();
    const PlacedShot& photo = house.led().parts().shown.front();
    const Gesture tap{.kind = Gesture::Kind::tap, .touch = 1, .subject = photo.shot.source, .at = {200, 360}};
    house.led().handle_gesture(tap);
    house.run(1500ms);
    const DrawItem& film = follower.last.items.back();
    CHECK(follower.playing.at(film.source).kind == MediaKind::film);
    CHECK(follower.ready.contains(film.source));
    CHECK(film.alpha == 1);
    CHECK(std::chrono::abs(film.local - lead.last.items.back().local) <= 34ms);  // a frame
    CHECK(film.placement == lead.last.items.back().placement);
    CHECK(share_in_step(lead, follower, house.truth - 500ms) >= 0.95);
    SUBCASE("until it has played once, and its photo is put back") {
        house.run(3s);
        CHECK(follower.last.items.size() == shots + 1);
        house.led().handle_gesture(tap);
    }
    SUBCASE("until its photo is put back") {
        house.led().handle_gesture(tap);
    }
    SUBCASE("and goes from boxes that hear no more of it") {
        house.cut(1);
        house.run(2s);
    }
    house.run(1500ms);
    CHECK(follower.last.items.size() == shots);
    CHECK(follower.playing.size() == sources);
    CHECK(follower.gaps == 0);
}

TEST_CASE("a box that has not got the film of a tapped photo shows the photo") {
    SharedHouse house = resting_house(3, {moving_photo("a"), photo("b"), photo("c")});
    house.boxes[1].missing = {"a"};  // the film is in the file of the photo, which is there already
    const PlacedShot& photo = house.led().parts().shown.front();
    house.led().handle_gesture(
        {.kind = Gesture::Kind::tap, .touch = 1, .subject = photo.shot.source, .at = {200, 360}});
    house.run(1500ms);
    CHECK(house.boxes[0].last.items.size() == house.boxes[1].last.items.size() + 1);
    CHECK(house.boxes[1].playing.at(house.boxes[1].last.items.back().source).kind == MediaKind::photo);
    CHECK(house.boxes[1].gaps == 0);
}

TEST_CASE("a tapestry in place of the wall is told to all boxes, and the wall comes back") {
    SharedHouse house = resting_house();
    TestBox& lead = house.boxes[0];
    TestBox& follower = house.boxes[1];
    CHECK(house.followed(1).tapestry() == nullptr);
    const Ns began = lead.time->now();
    house.led().tell_tapestry(TapestryMoment{.path = "a",
                                             .folder = "f",
                                             .room = {1280, 720},
                                             .opened = began,
                                             .view = {.centre = 7s, .level = 0.3},
                                             .above = SeenSpan{{3s, 9s}, began + 100ms}});
    house.run(200ms);
    REQUIRE(house.followed(1).tapestry() != nullptr);
    const TapestryMoment seen = *house.followed(1).tapestry();
    CHECK(seen.view == TapestryView{.centre = 7s, .level = 0.3});
    const Ns off = seen.opened + follower.time->epoch() - (began + lead.time->epoch());
    CHECK(std::chrono::abs(off) <= 1us);
    CHECK(seen.above->began == seen.opened + 100ms);
    house.run(30s);
    CHECK(house.followed(1).tapestry() != nullptr);
    SUBCASE("once the leader shows it again") {
        house.led().tell_tapestry({});
    }
    SUBCASE("on a box that hears no more of it, after a while") {
        house.cut(1);
        house.run(9s);
        CHECK(house.followed(1).tapestry() != nullptr);
        house.run(1s);
    }
    SUBCASE("with the first wall of a leader that was started anew") {
        house.kill(0);
        house.run(2s);
        CHECK(house.followed(1).tapestry() != nullptr);
        house.start_leader();
        house.run(4s);
    }
    house.run(200ms);
    CHECK(house.followed(1).tapestry() == nullptr);
}

TEST_CASE("a tapestry on a canvas to come is shown where it was, or not before the wall is on that canvas") {
    SharedHouse house = resting_house();
    const auto tell = [&](Vec2 canvas) {
        house.led().tell_tapestry(
            TapestryMoment{.path = "a", .folder = "f", .room = canvas, .view = {.centre = 7s}});
        house.run(300ms);
        return house.followed(1).tapestry();
    };
    const Canvas wider = canvas_of({1280, 1480}, {{{0, 0}, {1280, 720}}, {{0, 760}, {1280, 1480}}});
    CHECK(tell(wider) == nullptr);
    REQUIRE(tell({1280, 720}) != nullptr);
    REQUIRE(tell(wider) != nullptr);
    CHECK(tell(wider)->room == TapestryRoom(1280, 720));
    house.led().set_canvas(wider);
    house.run(5s);
    REQUIRE(house.followed(1).shown()->canvas == Vec2(wider));
    REQUIRE(house.followed(1).tapestry() != nullptr);
    CHECK(house.followed(1).tapestry()->room == TapestryRoom(1280, 1480));
}

TEST_CASE("until a wall is laid out for a canvas that has grown, all boxes keep their parts of the old one") {
    SharedHouse house({.seed = 12, .followers = 1});
    house.run(3s);
    const Vec2 canvas = house.led().parts().canvas;
    const Box half{{canvas.x / 2, 0}, canvas};
    const ActParts before{.canvas = canvas, .parts = {{"f0/a", {.box = half}}}};
    const ActParts now{.canvas = canvas * 2, .parts = {{"f0/a", {.box = moved(half, canvas)}}}};
    house.led().set_parts({now, before});
    house.run(1s);
    REQUIRE(house.followed(1).shown() != nullptr);
    CHECK(house.followed(1).shown()->canvas == canvas);
    CHECK(house.followed(1).shown()->parts == before.parts);
}

TEST_CASE("until a change to another canvas begins, all boxes show the wall on the canvas before") {
    SharedHouse house = resting_house();
    const Vec2 before = house.led().parts().canvas;
    const Vec2 other{1280, 1480};
    house.led().set_canvas(other);
    int seen = 0;  // moments between the decision and the begin
    for (int moment = 0; moment < 100; ++moment) {
        house.run(30ms);
        const std::optional<WallChange>& change = house.led().parts().change;
        if (!change || !change->is_fading()) continue;
        const Ns passed = house.boxes[0].last.time - change->began;
        if (passed > -60ms && passed < 60ms) continue;
        seen += passed < 0ns;
        for (const TestBox& box : house.boxes)
            CHECK(box.last.canvas == (passed < 0ns ? before : other));
    }
    CHECK(seen > 10);
    CHECK(house.followed(1).shown()->canvas == other);
}

TEST_CASE("captions have the same rooms on all boxes, beside bezels, and some stay while the wall changes") {
    SharedHouse house({.seed = 8, .followers = 1});
    const Box left{{0, 0}, {630, 720}};
    const Box right{{650, 0}, {1280, 720}};
    house.led().set_canvas(canvas_of({1280, 720}, {left, right}));
    house.led().set_parts(
        {{.canvas = {1280, 720}, .parts = {{"lead/a", {.box = left}}, {"f0/a", {.box = right}}}}});
    house.run(6s);
    int late = 0;  // frames after which the follower hears of a change
    int told = 0;
    int standing = 0;
    int changing = 0;
    for (int k = 0; k < 300; ++k) {
        house.run(33ms);
        const Frame& lead = house.boxes[0].last;
        const Frame& follower = house.boxes[1].last;
        const WallParts parts = house.led().parts();
        if (parts.change && lead.time < parts.change->began) {
            CHECK(lead.captions.size() == parts.shown.size());
            ++told;
        }
        if (house.boxes[0].frames.back().content != house.boxes[1].frames.back().content) continue;
        if (lead.captions.size() != follower.captions.size()) {
            ++late;
            continue;
        }
        for (std::size_t i = 0; i < lead.captions.size(); ++i) {
            CHECK(lead.captions[i].path == follower.captions[i].path);
            CHECK(lead.captions[i].region == follower.captions[i].region);
            CHECK(lead.captions[i].avoided == follower.captions[i].avoided);
            CHECK_FALSE(follower.captions[i].avoided.empty());
            ++(lead.captions[i].next == nullptr ? standing : changing);
        }
    }
    CHECK(late < 15);
    CHECK(told > 30);  // a second passes until a change begins that the others were told of
    CHECK(standing > 100);
    CHECK(changing > 10);
}

TEST_CASE("a touch on a box that follows moves the wall of all") {
    SharedHouse house = resting_house();
    const WallClock& leader = *house.boxes[0].time;
    const WallClock& follower = *house.boxes[1].time;
    const auto touched = follower.epoch() + follower.now();
    house.followed(1).touches().note(
        Contact{.kind = Contact::Kind::down, .finger = 0, .at = {200, 300}, .time = follower.now()});
    house.run(100ms);
    const std::vector<InputEvent> touches =
        house.boxes[0].talk->take_touches({.now = leader.now(), .epoch = leader.epoch()});
    REQUIRE(touches.size() > 1);  // the finger rests after it
    const auto& contact = std::get<Contact>(touches[0]);
    CHECK(contact.at == Vec2{200, 300});
    CHECK(contact.finger >= 1000);
    CHECK(contact.is_told);
    CHECK(leader.epoch() + contact.time == touched);
}
