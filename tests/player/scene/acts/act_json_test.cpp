#include "player/scene/acts/act_json.hpp"

#include "player/scene/acts/box_note.hpp"
#include "player/scene/acts/lifted_json.hpp"
#include "player/scene/acts/touch_json.hpp"
#include "player/scene/tapestry/tapestry_show.hpp"
#include "tests/player/scene/acts/shared_house.hpp"
#include "tests/player/scene/changing_wall.hpp"
#include "tests/player/scene/tapestry/drawn_tapestry.hpp"

#include <doctest/doctest.h>

#include <cstdlib>
#include <random>
#include <stdexcept>
#include <string>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

const std::string stored = store_id("a", 1, 2) + "/0.mkv";

/// An act with a transition in which shots move, come and leave.
WallAct act(std::uint64_t seed, const CellStyle& style = {}) {
    ChangingWall wall({1280, 720}, 6, seed, random_item, style);
    WallAct made{.name = {.run = 12, .generation = 7},
                 .epoch = 1'800'000'000s + 1ns,
                 .canvas = {1280, 720},
                 .parts = {{"a/HDMI-A-1", {.box = {{0, 0}, {640, 720}}}},
                           {"b/DP-1", {.box = {{660.1, 0}, {1280, 720}}, .turned = 90}}},
                 .cells = style,
                 .fade = 800ms,
                 .shown = wall.shown()};
    for (PlacedShot& placed : made.shown)
        placed.shot.picture = placed.shot.item.core.max;
    std::vector<PlacedShot> next = wall.turned();
    for (PlacedShot& placed : next)
        placed.shot.picture = placed.shot.item.core.max;
    WallChange& change = made.change.emplace(WallChange{.canvas = {1280, 720}, .wall = std::move(next)});
    begin_transition(change, made.shown, {.cells = style}, 5s);
    return made;
}

/// An act of a wall that pans.
WallAct panning_act(std::uint64_t seed) {
    WallAct made = act(seed);
    made.change.reset();
    made.pan = ActPan{.origin = 1e9,
                      .course = {.view = 1e9 + 0.1, .since = 33ns, .speed = 29.97, .last = 1e9 + 200}};
    made.words = {.captions = CaptionChoice::written, .code = "a", .share = "b"};
    return made;
}

/// An act on the way out of a folder that is opened in another.
WallAct folder_act(std::uint64_t seed) {
    const auto inside = [](WallAct made, WallAct outer) {
        made.folder = ActFolder{.outer = std::make_shared<const WallAct>(std::move(outer)),
                                .lag = -3s,
                                .mark = {{20, 600}, {160, 700}},
                                .box = {{300, 200}, {620, 380}},
                                .is_opening = false,
                                .began = 5s,
                                .duration = 800ms};
        return made;
    };
    WallAct middle = inside(act(seed + 1), act(seed + 2));
    middle.change.reset();
    middle.folder->stands_from = 4s;
    return inside(act(seed), std::move(middle));
}

bool is_same(const Frame& one, const Frame& other) {
    return std::ranges::equal(one.items, other.items, [](const DrawItem& a, const DrawItem& b) {
        return a.source == b.source && a.placement == b.placement && a.alpha == b.alpha &&
               a.local == b.local && a.picture == b.picture && a.cell->parts == b.cell->parts &&
               a.cell->filler == b.cell->filler && a.cell->triangles == b.cell->triangles &&
               a.cell->filler_triangles == b.cell->filler_triangles &&
               a.cell->edge_coverage == b.cell->edge_coverage;
    });
}

/// The number of changed acts that are tried. VITRINE_ACTS=100000: all.
int count(int usual) {
    const char* const wanted = std::getenv("VITRINE_ACTS");
    return wanted != nullptr ? std::atoi(wanted) : usual;
}

/// A text of which up to three numbers or bytes are others.
std::string changed(std::string text, std::mt19937_64& random) {
    static const std::vector<std::string> words{"-1",
                                                "0",
                                                "1e308",
                                                "1e-300",
                                                "null",
                                                "[]",
                                                "{}",
                                                "true",
                                                "\"\"",
                                                "1e9",
                                                "-1e6",
                                                "9223372036854775807",
                                                "1e-9",
                                                "0.5",
                                                "2305843009213693951",
                                                "10000000000000000"};
    const auto below = [&](std::size_t most) { return static_cast<std::size_t>(random() % most); };
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        const std::size_t begin = text.find_first_of("0123456789-", below(text.size()));
        if (begin == std::string::npos) continue;
        const std::size_t end = text.find_first_not_of("0123456789.e-+", begin);
        if (below(4) == 0)
            text[below(text.size())] = static_cast<char>(below(256));
        else
            text.replace(begin, end - begin, words[below(words.size())]);
    }
    return text;
}

}  // namespace

TEST_CASE("an act is read as it was written, and gives the same frames bit by bit") {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const WallAct before = act(seed, {.feather = seed == 2 ? 24.0 : 1.0});
        const std::string text = to_json(before);
        const WallAct after = act_from_json(text);
        CHECK(to_json(after) == text);
        CHECK(after.name == before.name);
        CHECK(after.parts == before.parts);
        CHECK(after.epoch == before.epoch);
        for (const auto now : {4s, 5s, 6s, 9s})
            for (const auto more : {0ms, 130ms, 400ms})
                CHECK(is_same(act_frame(before, now + more), act_frame(after, now + more)));
    }
}

TEST_CASE("an act of a folder is read as it was written, with the walls behind it") {
    const WallAct before = folder_act(3);
    const WallAct after = act_from_json(to_json(before));
    CHECK(to_json(after) == to_json(before));
    for (const auto now : {4s, 5s, 6s}) {
        const Frame frame = act_frame(after, now + 300ms);
        CHECK(is_same(frame, act_frame(before, now + 300ms)));
        CHECK(frame.plates.size() == 1);  // one way back goes before the other comes
    }
    WallAct far_away = before;
    far_away.folder->lag = 24h * 36500;
    CHECK_THROWS_AS(act_from_json(to_json(far_away)), std::runtime_error);
    WallAct too_deep = before;
    for (int k = 0; k < 2; ++k) {
        WallAct further = act(3);
        further.folder = before.folder;
        further.folder->outer = std::make_shared<const WallAct>(too_deep);
        too_deep = further;
    }
    CHECK_THROWS_AS(act_from_json(to_json(too_deep)), std::runtime_error);
}

TEST_CASE("the way of a panning wall is read as it was written") {
    WallAct written = panning_act(2);
    const WallAct read = act_from_json(to_json(written));
    CHECK(read.pan == written.pan);
    CHECK(act_frame(read, 2s).view.x == doctest::Approx(60.04));
    CHECK(act_frame(read, 1h).view.x == doctest::Approx(200));
    written.change = act(2).change;
    CHECK_THROWS_AS(act_from_json(to_json(written)), std::runtime_error);
}

TEST_CASE("the words of a wall are read as they were written, and bounded") {
    WallAct written = act(2);
    CHECK(act_from_json(to_json(written)).words == WallWords{});
    written.words = {
        .captions = CaptionChoice::names, .code = "https://example.org", .share = "\\\\box\\media"};
    CHECK(act_from_json(to_json(written)).words == written.words);
    CHECK_FALSE(act_from_json(to_json(written)).is_paused);
    written.is_paused = true;
    CHECK(act_from_json(to_json(written)).is_paused);
    written.words.code = std::string(5000, 'a');
    CHECK_THROWS_AS(act_from_json(to_json(written)), std::runtime_error);
    written.words = {.captions = static_cast<CaptionChoice>(7)};
    CHECK_THROWS_AS(act_from_json(to_json(written)), std::runtime_error);
}

TEST_CASE("a way of a touched wall is read as it was written") {
    WallAct before = act(4);
    WayRequest request{.wall = {.canvas = {1280, 720}}, .wishes = {}};
    WallKey key;
    for (const PlacedShot& placed : before.shown) {
        key.placements.push_back(placed.placement);
        key.cells.push_back(placed.cell);
        key.alphas.push_back(0.1 + 0.2);
    }
    before.change->transition.reset();
    before.change->wall = before.shown;
    before.change->way = std::make_shared<const WallWay>(WallWay{.keys = {key, key}, .homes = {}});
    before.change->duration = 300ms;
    const WallAct after = act_from_json(to_json(before));
    CHECK(to_json(after) == to_json(before));
    for (const auto passed : {-100ms, 0ms, 200ms, 400ms})
        CHECK(is_same(act_frame(before, 5s + passed), act_frame(after, 5s + passed)));
}

TEST_CASE("a shot is named by its file in the store, and by no other file") {
    WallAct before = act(5);
    for (PlacedShot& placed : before.shown)
        placed.shot.shot.stored = StoredShot{.file = stored, .begin = 2s, .width = 640, .height = 360};
    before.change.reset();
    const std::string text = to_json(before);
    const WallAct after = act_from_json(text);
    CHECK(after.shown[0].shot.shot.stored == before.shown[0].shot.shot.stored);
    for (const char* const bad : {"../../etc/passwd", "/etc/passwd", "a"}) {
        std::string hostile = text;
        hostile.replace(hostile.find(stored), stored.size(), bad);
        CHECK_THROWS_AS(act_from_json(hostile), std::runtime_error);
    }
}

TEST_CASE("an act of another version, and what is none, gives a sentence") {
    const std::string text = to_json(act(6));
    const auto fault = [](const std::string& of) -> std::string {
        try {
            (void)act_from_json(of);
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    std::string other = text;
    other.replace(other.find("\"version\":1"), 11, "\"version\":2");
    CHECK(fault(other) == "the leader of the wall sends acts of another version; both need the same Vitrine");
    CHECK_FALSE(fault("").empty());
    CHECK_FALSE(fault("[]").empty());
    CHECK_FALSE(fault(R"({"version":1})").empty());
    CHECK_FALSE(fault(std::string(200'000, '[')).empty());
    CHECK_FALSE(fault(std::string(2 << 20, ' ')).empty());
}

TEST_CASE("changed acts are refused, or can be drawn at any time") {
    std::mt19937_64 random(20);
    const std::vector<std::string> texts{to_json(act(7)), to_json(act(8, {.feather = 20})),
                                         to_json(panning_act(9)), to_json(folder_act(10))};
    int drawn = 0;
    for (int k = 0; k < count(400); ++k) {
        try {
            const WallAct read = act_from_json(changed(texts[random() % texts.size()], random));
            for (const auto now : {4s, 5s, 9s})
                (void)act_frame(read, now + 300ms);
            ++drawn;
        } catch (const std::runtime_error&) {
            continue;
        }
    }
    CHECK(drawn > 0);
}

TEST_CASE("what boxes tell of themselves is read as it was written, and bounded") {
    const BoxNote note{.leads = true,
                       .has_guides = true,
                       .is_awake = true,
                       .outputs = {{.name = "HDMI-A-1", .width = 1920, .height = 1080, .turned = 270}},
                       .shown = ActName{.run = 5, .generation = 6},
                       .lacking = {"a.jpg"},
                       .fetch_fault = "rsync: connection refused",
                       .has_right_clock = true,
                       .difference = -40us};
    CHECK(box_note_from_json(to_json(note)) == note);
    CHECK(box_note_from_json(R"({"gone":true})").is_gone);
    for (const char* const bad :
         {"", "[]", R"({"outputs":[{"name":"a","width":0,"height":1,"turned":0}]})", R"({"outputs":7})",
          R"({"lacking":[7]})", R"({"fetch_fault":7})", R"({"gone":"yes"})"})
        CHECK_THROWS_AS(box_note_from_json(bad), std::runtime_error);
    const ActName name{.run = 1, .generation = 2};
    CHECK(ready_from_json(ready_to_json(name)) == name);
    CHECK_THROWS_AS(ready_from_json("{}"), std::runtime_error);
}

TEST_CASE("lifted shots travel as they were seen") {
    const auto again = [](const LiftedMoment& moment) {
        return lifted_to_json(lifted_from_json(lifted_to_json({12, moment})));
    };
    LiftedMoment seen{.shots = {{.source = 3,
                                 .state = LiftedState::whole,
                                 .pose = {.at = {0.1, {-7.3, 1e-9}}, .open = 0.3, .alpha = 0.7, .dims = 0.2},
                                 .full_scale = 1.7,
                                 .seat = 0.9}},
                      .filler_light = 0.9};
    CHECK(lifted_from_json(lifted_to_json({12, seen})) == ToldHands{12, seen});
    WallShot film = act(1).shown.front().shot;
    film.kind = MediaKind::film;
    film.shot.end = 3s;
    seen.film = FilmMoment{.shot = film, .placement = {0.7, {1e-9, 3}}};
    CHECK(again(seen) == lifted_to_json({12, seen}));
    seen.film->began = 4s;
    CHECK_THROWS_AS(lifted_from_json(lifted_to_json({12, seen})), std::runtime_error);
    seen.film->ends = 6s + 1ns;
    CHECK(again(seen) == lifted_to_json({12, seen}));
    seen.view = 12345.678;
    CHECK(again(seen) == lifted_to_json({12, seen}));
    seen.film->shot.kind = MediaKind::photo;
    CHECK_THROWS_AS(lifted_from_json(lifted_to_json({12, seen})), std::runtime_error);
    std::string unknown_state = lifted_to_json({12, seen});
    unknown_state.replace(unknown_state.find(R"("state":2)"), 9, R"("state":99)");
    for (const std::string& bad : std::vector<std::string>{
             "", "7", "{}", unknown_state, R"({"version":1,"run":1,"filler_light":2,"shots":[]})",
             R"({"version":1,"run":1,"filler_light":1,"shots":[{}]})"})
        CHECK_THROWS_AS(lifted_from_json(bad), std::runtime_error);
}

TEST_CASE("a tapestry travels as it was seen") {
    ToldHands told{.run = 12,
                   .tapestry = TapestryMoment{.path = "a/Zürich.mp4",
                                              .folder = "f3",
                                              .levels = 2,
                                              .room = {{2000, 562.5}, {{1000, 0}, {2000, 562.5}}},
                                              .opened = 1795591329152378001ns,
                                              .view = {.centre = 1234567891ns, .level = 1.3},
                                              .width = 4321.1,
                                              .touched = {.time = 3s, .is_lower = true}}};
    CHECK(lifted_from_json(lifted_to_json(told)) == told);
    told.tapestry->above = SeenSpan{{1s + 1ns, 2s}, 1795591329152378002ns};
    told.tapestry->in_place = SeenSpan{{3s, 4s}, 1795591329152378003ns};
    told.tapestry->looked_for = 7s;
    told.tapestry->edited.emplace();
    CHECK(lifted_from_json(lifted_to_json(told)) == told);
    told.tapestry->edited = {.keyframes = {1s, 5s}, .struck = {3s}};
    CHECK(lifted_from_json(lifted_to_json(told)) == told);
    CHECK(lifted_from_json(lifted_to_json({.run = 12})) == ToldHands{.run = 12});
    const std::string text = lifted_to_json(told);
    for (const auto& [right, wrong] : std::vector<std::pair<std::string, std::string>>{
             {R"("canvas":[2000.0,562.5])", R"("canvas":[0,562.5])"},
             {R"("canvas":[2000.0,562.5])", R"("canvas":[2000,1e5])"},
             {R"("canvas":[2000.0,562.5])", R"("canvas":[])"},
             {R"("screen":[1000.0,0.0,2000.0,562.5])", R"("screen":[1000,0,1000,562.5])"},
             {R"("screen":[1000.0,0.0,2000.0,562.5])", R"("screen":[1000,0,2001,562.5])"},
             {R"("screen":)", R"("door":)"},
             {R"("level":1.3)", R"("level":-1)"},
             {R"("level":1.3)", R"("level":65)"},
             {R"("levels":2)", R"("levels":-2)"},
             {R"("width":4321.1)", R"("width":-1)"},
             {R"("centre_ns":1234567891)", R"("centre_ns":-1)"},
             {R"("centre_ns":1234567891)", R"("centre_ns":1e9)"},
             {R"("looked_for_ns":7000000000)", R"("looked_for_ns":20000000000000000)"},
             {R"("end_ns":2000000000)", R"("end_ns":1000000001)"},
             {R"("chosen_ns":[1000000000,)", R"("chosen_ns":[-1,)"},
             {R"("struck_ns":[3000000000])", R"("struck_ns":3000000000)"},
             {R"("struck_ns":)", R"("strikes":)"},
             {R"("is_lower":true)", R"("is_lower":1)"},
             {R"("path":"a/Zürich.mp4")", R"("path":7)"},
             {R"("path":)", R"("way":)"}}) {
        std::string bad = text;
        REQUIRE(bad.find(right) != std::string::npos);
        bad.replace(bad.find(right), right.size(), wrong);
        CHECK_THROWS_AS(lifted_from_json(bad), std::runtime_error);
    }
}

TEST_CASE("changed tapestries are refused, or can be drawn at any time") {
    std::mt19937_64 random(21);
    const ToldHands told{.run = 12,
                         .tapestry = TapestryMoment{.path = "film.mp4",
                                                    .folder = "tiles",
                                                    .levels = 4,
                                                    .room = {640, 360},
                                                    .opened = 2s,
                                                    .view = {.centre = 30s, .level = 1.5},
                                                    .width = 700,
                                                    .above = SeenSpan{{10s, 40s}, 3s},
                                                    .in_place = SeenSpan{{12s, 16s}, 4s},
                                                    .touched = {.time = 12s},
                                                    .looked_for = 20s,
                                                    .edited = {{.keyframes = {5s}, .struck = {30s}}}}};
    const std::string text = lifted_to_json(told);
    const Shot shot{.begin = 0s, .end = 60s, .stored = StoredShot{.file = "clip"}};
    TapestryShow strip(drawn_tapestry(), drawn_film({shot}), {640, 360}, {.patience = {}});
    std::chrono::nanoseconds now = 5s;
    int drawn = 0;
    for (int k = 0; k < count(400); ++k) {
        try {
            const auto read = lifted_from_json(changed(text, random)).tapestry;
            if (!read) continue;
            strip.set_room(read->room);
            const TapestryMoment seen = moved(*read, -now / 2);
            for (int frame = 0; frame < 3; ++frame)
                for (const ShotRequest& request : strip.step(now += 40ms, &seen).requests)
                    strip.source_ready(request.source);
            ++drawn;
        } catch (const std::runtime_error&) {
            continue;
        }
    }
    CHECK(drawn > 0);
}

TEST_CASE("touches travel as they were made, with their times") {
    const auto events = [](std::chrono::nanoseconds begin) {
        return std::vector<InputEvent>{
            Contact{.kind = Contact::Kind::move, .finger = 2, .at = {0.1, 700}, .time = begin},
            Wheel{.notches = -1.5, .at = {3, 4}, .time = begin + 7ms},
            KeyPress{.key = Key::back, .time = begin + 9ms}};
    };
    const std::string told = touches_to_json(events(3s), {.now = 3020ms, .epoch = 1000s});
    CHECK(touches_from_json(told, {.now = 53'050ms, .epoch = 950s}) == events(53s));
    CHECK(touches_from_json(told, {.now = 9s, .epoch = 2000s}) == events(8980ms));  // other clocks
    const BoxMoment now{.now = 3s};
    const auto first = [](const std::string& fields) {
        return R"({"sent_ns":0,"events":[{)" + fields + "}]}";
    };
    CHECK(touches_from_json(first(R"("key":1,"age_ns":5)"), now).size() == 1);
    for (const std::string& text :
         {first(R"("kind":9,"finger":0,"at":[0,0],"age_ns":5)"), first(R"("key":99,"age_ns":5)"),
          first(R"("key":1)"), first(R"("key":1,"age_ns":1e18)"), std::string(R"({"events":[]})"),
          std::string("7")})
        CHECK_THROWS_AS(touches_from_json(text, now), std::runtime_error);
}
