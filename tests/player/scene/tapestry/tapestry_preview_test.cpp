#include "player/scene/tapestry/tapestry_preview.hpp"

#include <doctest/doctest.h>

#include <utility>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
using std::chrono::nanoseconds;

namespace {

constexpr double width = 160;  // px of the preview

std::vector<Shot> shots_of(const std::vector<std::pair<nanoseconds, nanoseconds>>& spans) {
    std::vector<Shot> shots;
    for (const auto& [begin, end] : spans)
        shots.push_back({.begin = begin, .end = end});
    return shots;
}

PreviewedFilm film_of(nanoseconds duration, std::vector<Shot> shots = {}) {
    return {.path = "film.mp4", .duration = duration, .picture = {640, 360}, .shots = std::move(shots)};
}

/// A preview with the spans that it asks for.
struct Previewed : FilmSpans, TapestryPreview {
    explicit Previewed(nanoseconds duration, std::vector<Shot> shots = {})
        : FilmSpans(film_of(duration, std::move(shots)), 100),
          TapestryPreview(*static_cast<FilmSpans*>(this)) {}
};

/// The source of the last request since the last call.
ShotRequest last_request(Previewed& preview) {
    const FilmSpans::Changes changes = preview.take_changes();
    REQUIRE_FALSE(changes.requests.empty());
    return changes.requests.back();
}

/// Plays from this time above the strip, begun at 0 s. @return the source
SourceId play_above(Previewed& preview, nanoseconds from) {
    preview.play(from, width);
    const SourceId source = last_request(preview).source;
    preview.source_ready(source);
    preview.start_ready(0s);
    return source;
}

}  // namespace

TEST_CASE("a preview asks for a minute of the film, in the shape of its picture") {
    Previewed preview(300s);
    preview.play(20s, width);
    const ShotRequest request = last_request(preview);
    CHECK(request.source == 101);
    CHECK(request.path == "film.mp4");
    CHECK(request.kind == MediaKind::film);
    CHECK(request.shot.begin == 20s);
    CHECK(request.shot.end == 80s);
    CHECK(request.width == 160);
    CHECK(request.height == 90);
    CHECK_FALSE(preview.above());  // not ready yet
}

TEST_CASE("a preview begins at the moment asked for, in a shot or between two, while there is film left") {
    const auto begin_of = [](std::vector<Shot> shots, nanoseconds from) {
        Previewed preview(30s, std::move(shots));
        preview.play(from, width);
        return last_request(preview).shot.begin;
    };
    CHECK(begin_of({}, -5s) == 0s);
    CHECK(begin_of({}, 29900ms) == 29600ms);
    const std::vector<Shot> shots = shots_of({{2s, 10s}, {12s, 12500ms}, {13s, 20s}});
    for (const nanoseconds from : {0ms, 9500ms, 11000ms, 12400ms, 28000ms})
        CHECK(begin_of(shots, from) == from);
}

TEST_CASE("between stored shots the film itself plays, up to one that is worth a source of its own") {
    std::vector<Shot> shots = shots_of({{0s, 10s}, {10500ms, 14s}, {16s, 30s}});
    for (Shot& shot : shots)
        shot.stored = StoredShot{.file = "id/clip"};
    Previewed preview(30s, shots);
    const auto part_from = [&](nanoseconds from) {
        preview.play(from, width);
        return last_request(preview).shot;
    };
    CHECK_FALSE(part_from(10100ms).stored);
    CHECK(part_from(10100ms).end == 16s);  // the shot half a second later would cost a gap
    CHECK_FALSE(part_from(14s).stored);
    CHECK(part_from(14s).end == 16s);
    CHECK_FALSE(part_from(9500ms).stored);
    CHECK(part_from(9500ms).end == 10500ms);
    CHECK(part_from(8s).stored);
}

TEST_CASE("a stored shot plays from the store, from the same moment to its end") {
    std::vector<Shot> shots = shots_of({{10s, 20s}, {20s, 40s}});
    shots[0].stored = StoredShot{.file = "id/clip", .begin = 3s, .width = 640, .height = 360};
    Previewed preview(40s, shots);
    preview.play(12s, width);
    const ShotRequest request = last_request(preview);
    REQUIRE(request.shot.stored);
    CHECK(request.shot.stored->begin == 5s);
    CHECK(request.shot.begin == 12s);
    CHECK(request.shot.end == 20s);
}

TEST_CASE("shots that came to the store later are played from there") {
    Previewed preview(40s, shots_of({{0s, 40s}}));
    preview.play(5s, width);
    CHECK_FALSE(last_request(preview).shot.stored);
    std::vector<Shot> shots = shots_of({{0s, 40s}});
    shots[0].stored = StoredShot{.file = "id/clip"};
    preview.set_film(film_of(40s, shots));
    preview.play(5s, width);
    CHECK(last_request(preview).shot.stored->begin == 5s);
}

TEST_CASE("the picture above the strip stays until the next one is ready") {
    Previewed preview(300s);
    const SourceId first = play_above(preview, 10s);
    preview.play(100s, width);
    const SourceId given_up = last_request(preview).source;
    preview.play(200s, width);
    const FilmSpans::Changes changes = preview.take_changes();
    CHECK(changes.retired == std::vector<SourceId>{given_up});
    CHECK(preview.above()->source == first);

    preview.source_ready(changes.requests.back().source);
    CHECK(preview.above()->span.begin == 200s);
    CHECK(preview.take_changes().retired == std::vector<SourceId>{first});
    preview.start_ready(7s);
    CHECK(preview.time_above(9s) == 2s);
}

TEST_CASE("the next span is asked for shortly before the end of one, and follows without a gap") {
    Previewed preview(100s);
    const SourceId first = play_above(preview, 0s);
    preview.play_on(58400ms, width);
    CHECK(preview.take_changes().requests.empty());
    preview.play_on(58500ms, width);
    const ShotRequest next = last_request(preview);
    CHECK(next.shot.begin == 60s);
    CHECK(next.shot.end == 100s);
    preview.play_on(59s, width);
    CHECK(preview.take_changes().requests.empty());

    // The span is over, and the next one is late: its last picture stays.
    preview.play_on(62s, width);
    CHECK(preview.above()->source == first);
    CHECK(preview.time_above(62s) == 60s - 2ms);

    preview.source_ready(next.source);
    CHECK(preview.above()->source == first);
    preview.play_on(63s, width);
    CHECK(preview.above()->source == next.source);
    CHECK(preview.take_changes().retired == std::vector<SourceId>{first});
    preview.start_ready(63s);
    CHECK(preview.time_above(63s) == 0s);
    CHECK(preview.time_above(64s) == 1s);
}

TEST_CASE("a span that is ready early waits for the end of the one before") {
    Previewed preview(100s);
    const SourceId first = play_above(preview, 0s);
    preview.play_on(59s, width);
    preview.source_ready(last_request(preview).source);
    preview.start_ready(59s);
    preview.play_on(59900ms, width);
    CHECK(preview.above()->source == first);
    preview.play_on(60s, width);
    CHECK(preview.above()->span.begin == 60s);
}

TEST_CASE("behind the film's end nothing is asked for: its last picture stands, and the end is told") {
    Previewed preview(100s);
    play_above(preview, 60s);
    preview.play_on(39900ms, width);
    CHECK_FALSE(preview.ended(39900ms));
    preview.play_on(45s, width);
    CHECK(preview.take_changes().requests.empty());
    CHECK(preview.time_above(45s) == 40s - 2ms);
    CHECK(preview.ended(45s) == 40s);
}

TEST_CASE("a closed preview drops what would have followed, and keeps what a visitor has asked for since") {
    Previewed following(100s);
    const SourceId first = play_above(following, 0s);
    following.play_on(59s, width);
    const SourceId next = last_request(following).source;
    following.stop_preview();
    CHECK_FALSE(following.above());
    CHECK(following.take_changes().retired == std::vector<SourceId>{first, next});

    Previewed asked(100s);
    const SourceId old = play_above(asked, 0s);
    asked.play(50s, width);
    const SourceId wanted = last_request(asked).source;
    asked.stop_preview();
    CHECK(asked.take_changes().retired == std::vector<SourceId>{old});
    asked.source_ready(wanted);
    REQUIRE(asked.above());
    CHECK(asked.above()->source == wanted);
}

TEST_CASE("a span in place begins at its moment and ends with its shot, but is no shorter than a second") {
    FilmSpans spans(film_of(60s, shots_of({{0s, 2s}, {3s, 20s}, {20s, 60s}})), 100);
    const auto span = [&](nanoseconds from) {
        const FilmSpan found = spans.span_in_place(from);
        return std::pair(found.begin, found.end);
    };
    CHECK(span(1s) == std::pair<nanoseconds, nanoseconds>(1s, 2s));
    CHECK(span(5s) == std::pair<nanoseconds, nanoseconds>(5s, 9s));
    CHECK(span(18s) == std::pair<nanoseconds, nanoseconds>(18s, 20s));
    CHECK(span(19500ms) == std::pair<nanoseconds, nanoseconds>(19500ms, 20500ms));
    CHECK(span(2500ms) == std::pair<nanoseconds, nanoseconds>(2500ms, 6500ms));
    CHECK(span(80s) == std::pair<nanoseconds, nanoseconds>(59600ms, 60s));
    spans.set_film(film_of(60s));
    CHECK(span(19s) == std::pair<nanoseconds, nanoseconds>(19s, 23s));
}

TEST_CASE("a span in place starts with the frame after its source is ready, and another one replaces it") {
    Previewed preview(60s);
    preview.play_in_place({10s, 14s}, width);
    const SourceId first = last_request(preview).source;
    REQUIRE(preview.in_place());
    preview.start_ready(1s);
    CHECK_FALSE(preview.in_place()->began);
    preview.source_ready(first);
    preview.start_ready(2s);
    CHECK(preview.in_place()->began == 2s);

    preview.play_in_place({30s, 34s}, width);
    CHECK(preview.take_changes().retired == std::vector<SourceId>{first});
    CHECK_FALSE(preview.in_place()->began);
    preview.stop_in_place();
    CHECK_FALSE(preview.in_place());
}

TEST_CASE("a source that fails closes its part alone") {
    Previewed preview(100s);
    const SourceId above = play_above(preview, 0s);
    preview.play_in_place({10s, 14s}, width);
    const SourceId in_place = last_request(preview).source;
    preview.source_failed(in_place);
    CHECK_FALSE(preview.in_place());
    CHECK(preview.above());
    preview.source_failed(above);
    CHECK_FALSE(preview.above());
    CHECK(preview.take_changes().retired == std::vector<SourceId>{in_place, above});
}

TEST_CASE("on another canvas the part above plays on, and what was asked for another size is dropped") {
    Previewed preview(100s);
    const SourceId above = play_above(preview, 0s);
    preview.play_on(59s, width);
    const SourceId next = last_request(preview).source;
    preview.play_in_place({10s, 14s}, width);
    const SourceId in_place = last_request(preview).source;
    preview.stop_outdated();
    CHECK(preview.take_changes().retired == std::vector<SourceId>{next, in_place});
    CHECK(preview.above()->source == above);
    preview.stop_all();
    CHECK(preview.take_changes().retired == std::vector<SourceId>{above});
}
