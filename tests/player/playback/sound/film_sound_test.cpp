#include "player/playback/sound/film_sound.hpp"

#include "tests/player/playback/numbered_film.hpp"
#include "tests/player/playback/sound/sounding_film.hpp"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <future>
#include <map>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
using std::chrono::nanoseconds;

namespace {

constexpr nanoseconds window = 40ms;
constexpr nanoseconds alignment = 20ms;  // from one piece to the next: some containers count roughly
constexpr nanoseconds tolerance = 100ms;
constexpr nanoseconds seam = 250ms;  // within it some decoders give nothing yet
constexpr int silence = -1;

nanoseconds now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

/// The samples in windows by running time: which second of the film is heard in each.
std::map<nanoseconds, int> seconds_heard(const std::vector<SoundRecorder::Piece>& pieces) {
    std::map<nanoseconds, int> heard;
    std::vector<float> samples;
    nanoseconds begin{0};
    const auto flush = [&](int rate) {
        const auto count = static_cast<std::size_t>(window.count() * rate / 1'000'000'000);
        for (std::size_t i = 0; i + count <= samples.size(); i += count)
            heard[begin + nanoseconds(1s) * static_cast<long>(i) / rate] =
                second_heard(samples.data() + i, count, rate);
        samples.clear();
    };
    for (const SoundRecorder::Piece& piece : pieces) {
        const nanoseconds so_far = nanoseconds(1s) * static_cast<long>(samples.size()) / piece.rate;
        if (samples.empty() || std::chrono::abs(piece.time - begin - so_far) > alignment) {
            flush(piece.rate);
            begin = piece.time;
        }
        samples.insert(samples.end(), piece.samples.begin(), piece.samples.end());
    }
    if (!pieces.empty()) flush(pieces.back().rate);
    return heard;
}

/// The place within the part at a moment of its shot's time.
nanoseconds in_part(const SoundPart& part, nanoseconds local) {
    return part.begin + local % part.duration();
}

bool is_near_a_change(const SoundPart& part, nanoseconds local) {
    const nanoseconds at = in_part(part, local);
    const nanoseconds in_second = at % nanoseconds(1s);
    const nanoseconds in_loop = local % part.duration();
    return in_second < tolerance || in_second + window > nanoseconds(1s) - tolerance || in_loop < tolerance ||
           in_loop + window > part.duration() - tolerance;
}

float loudest(const std::vector<SoundRecorder::Piece>& pieces, nanoseconds from, nanoseconds to) {
    float peak = 0;
    nanoseconds time{0};
    for (const SoundRecorder::Piece& piece : pieces)
        for (const float sample : piece.samples) {
            if (time >= from && time < to) peak = std::max(peak, std::abs(sample));
            time += nanoseconds(1s) / piece.rate;
        }
    return peak;
}

/// Waits for the sound to end; what it still gives is taken away.
bool ends(const FilmSound& sound, SoundRecorder& recorder) {
    for (int i = 0; i < 10'000 && !sound.has_ended(); ++i) {
        recorder.throw_away();
        std::this_thread::sleep_for(5ms);
    }
    return sound.has_ended();
}

}  // namespace

TEST_CASE("what is heard belongs to the picture's time, loop after loop") {
    for (const auto& [file, film] : {std::pair{std::string("a.mp4"), SoundingFilm{}},
                                     {"b.mkv", SoundingFilm{.muxer = "matroskamux", .encoder = "vorbisenc"}},
                                     {"c.mkv", SoundingFilm{.muxer = "matroskamux", .encoder = "opusenc"}},
                                     {"d.avi", SoundingFilm{.muxer = "avimux", .encoder = "lamemp3enc"}},
                                     {"e.mov", SoundingFilm{.muxer = "qtmux", .encoder = "identity"}}}) {
        const std::string& name = file;
        CAPTURE(name);
        const Folder folder;
        const SoundPart part{
            .file = folder.path / name, .begin = 1500ms, .end = 4700ms, .origin = now() - 900ms};
        write_sounding_film(part.file, film);
        SoundRecorder recorder;
        const FilmSound sound(part, recorder.sink());
        while (recorder.sinks() == 0 && !sound.has_ended())
            std::this_thread::yield();

        const std::map<nanoseconds, int> heard = seconds_heard(recorder.take(9s));

        CAPTURE(sound.failure().value_or(PlaybackFailure{}).text);
        REQUIRE_FALSE(heard.empty());
        CHECK(heard.begin()->first >= 900ms);
        int right = 0;
        for (const auto& [time, second] : heard) {
            const nanoseconds local = time;
            if (is_near_a_change(part, local) || local < heard.begin()->first + 200ms) continue;
            if (second == silence && local % part.duration() < seam) continue;
            CAPTURE(local.count());
            CHECK(second == in_part(part, local) / nanoseconds(1s));
            ++right;
        }
        CHECK(right * window > 5s);  // 9 s, less the windows next to a change
        CHECK_FALSE(sound.failure().has_value());
    }
}

TEST_CASE("a sound comes and goes softly") {
    const Folder folder;
    const SoundPart part{.file = folder.path / "a.mp4", .end = 6s, .origin = now()};
    write_sounding_film(part.file);
    SoundRecorder recorder;
    FilmSound sound(part, recorder.sink());
    while (recorder.sinks() == 0)
        std::this_thread::yield();
    const auto coming = recorder.take(500ms);
    CHECK(loudest(coming, 0ms, 20ms) < 0.15 * loudest(coming, 300ms, 400ms));
    CHECK(loudest(coming, 80ms, 120ms) > 0.3 * loudest(coming, 300ms, 400ms));
    CHECK(loudest(coming, 80ms, 120ms) < 0.8 * loudest(coming, 300ms, 400ms));

    sound.leave();

    CHECK(ends(sound, recorder));
    CHECK_FALSE(sound.failure().has_value());
}

TEST_CASE("a part in which nothing is to be heard ends by itself") {
    const Folder folder;
    const SoundPart part{.file = folder.path / "a.mkv", .begin = 20s, .end = 21s, .origin = now()};
    write_sounding_film(part.file, {.muxer = "matroskamux", .encoder = "vorbisenc", .seconds = 2});
    SoundRecorder recorder;
    const FilmSound sound(part, recorder.sink());
    while (recorder.sinks() == 0)
        std::this_thread::yield();
    CHECK(ends(sound, recorder));
}

TEST_CASE("a film without sound says so") {
    const Folder folder;
    const SoundPart part{.file = folder.path / "a.mp4", .end = 2s, .origin = now()};
    write_sounding_film(part.file, {.encoder = "", .seconds = 2});
    SoundRecorder recorder;
    const FilmSound sound(part, recorder.sink());
    while (!sound.has_ended())
        std::this_thread::yield();
    REQUIRE(sound.failure().has_value());
    CHECK(sound.failure()->is_of_film);
    CHECK(sound.failure()->text == "the film has no sound");
}

TEST_CASE("a device that is not there is not the film's fault") {
    const Folder folder;
    const SoundPart part{.file = folder.path / "a.mp4", .end = 2s, .origin = now()};
    write_sounding_film(part.file, {.seconds = 2});
    const FilmSound sound(part, alsa_sink("no-such-device"));
    while (!sound.has_ended())
        std::this_thread::yield();
    REQUIRE(sound.failure().has_value());
    CHECK_FALSE(sound.failure()->is_of_film);
}

TEST_CASE("a device that does not answer keeps nobody waiting") {
    struct Hanging {
        std::promise<void> let_go;
        std::shared_future<void> gate = let_go.get_future().share();
        std::atomic<bool> is_hanging{false};
        std::promise<void> gone;
    };

    const auto hanging = std::make_shared<Hanging>();
    const SoundSink sink = [hanging] {
        GstPtr<GstElement> element = make_element("appsink");
        GstAppSinkCallbacks callbacks{};
        callbacks.new_preroll = [](GstAppSink*, gpointer self) {
            auto& here = **static_cast<std::shared_ptr<Hanging>*>(self);
            if (!here.is_hanging.exchange(true)) here.gate.wait();
            return GST_FLOW_OK;
        };
        gst_app_sink_set_callbacks(GST_APP_SINK(element.get()), &callbacks,
                                   new std::shared_ptr<Hanging>(hanging), [](gpointer self) {
                                       auto* held = static_cast<std::shared_ptr<Hanging>*>(self);
                                       (*held)->gone.set_value();
                                       delete held;
                                   });
        return element;
    };
    const Folder folder;
    const SoundPart part{.file = folder.path / "a.mp4", .end = 2s, .origin = now()};
    write_sounding_film(part.file, {.seconds = 2});
    {
        FilmSound sound(part, sink);
        while (!hanging->is_hanging)
            std::this_thread::yield();
        sound.leave();
    }
    CHECK(hanging->gate.wait_for(0s) == std::future_status::timeout);  // it hangs still
    hanging->let_go.set_value();
    CHECK(hanging->gone.get_future().wait_for(60s) == std::future_status::ready);
}
