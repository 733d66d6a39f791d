#include "player/playback/film_loop.hpp"

#include "tests/player/playback/numbered_film.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <string>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr auto patience = 20s;
const std::string h264 = "x264enc bframes=2 b-adapt=false key-int-max=25 speed-preset=veryfast ! ";
const std::string h264_mp4 = h264 + "mp4mux";

constexpr std::size_t max_pictures = 300;  // taken of one film

struct Seen {
    int number = 0;
    std::chrono::nanoseconds time{0};
};

std::vector<Seen> take(SampleQueue& queue, std::size_t count) {
    std::vector<Seen> seen;
    while (seen.size() < count && queue.wait(patience)) {
        const auto taken = queue.take_if([](const LoopedSample&) { return true; });
        seen.push_back({number(taken->sample), taken->sample.stream_time});
    }
    return seen;
}

std::string take_numbers(SampleQueue& queue, std::size_t count) {
    std::vector<int> numbers;
    for (const Seen& seen : take(queue, count))
        numbers.push_back(seen.number);
    return fmt::format("{}", fmt::join(numbers, " "));
}

std::string loops(int first, int count, int times) {
    std::vector<int> numbers;
    for (int i = 0; i < count * times; ++i)
        numbers.push_back(first + i % count);
    return fmt::format("{}", fmt::join(numbers, " "));
}

/// The time of each picture in one pass from the begin, as the analyzer sees them.
std::map<int, std::chrono::nanoseconds> times(const std::string& file, int pictures) {
    SampleQueue queue(12);
    const FilmLoop loop({file, 0s, 1h, numbered_width, numbered_height}, queue);
    std::map<int, std::chrono::nanoseconds> times;
    for (const Seen& seen : take(queue, static_cast<std::size_t>(pictures))) {
        times.emplace(seen.number, seen.time);
    }
    return times;
}

std::uint64_t fingerprint(const Sample& sample) {
    std::uint64_t hash = 14695981039346656037U;
    for (const std::byte value : sample.pixels)
        hash = (hash ^ std::to_integer<unsigned>(value)) * 1099511628211U;
    return hash;
}

/// The pictures of a part as they come, with their times.
std::vector<std::pair<std::chrono::nanoseconds, std::uint64_t>> pictures(const std::string& file,
                                                                         std::chrono::nanoseconds begin,
                                                                         std::chrono::nanoseconds end,
                                                                         std::size_t count) {
    SampleQueue queue(12);
    const FilmLoop loop({file, begin, end, 64, 64}, queue);
    std::vector<std::pair<std::chrono::nanoseconds, std::uint64_t>> pictures;
    while (pictures.size() < count && queue.wait(patience)) {
        const auto taken = queue.take_if([](const LoopedSample&) { return true; });
        if (count == max_pictures && taken->loop > 0) break;
        pictures.emplace_back(taken->sample.stream_time, fingerprint(taken->sample));
    }
    return pictures;
}

struct Container {
    std::string name;
    std::string chain;
    int lost = 0;  // pictures at the end beyond the duration that the muxer declares
};

const std::vector<Container>& containers() {
    static const std::vector<Container> containers{
        {"mp4 with B-frames", h264_mp4},
        {"fragmented mp4", h264 + "mp4mux fragment-duration=500", 2},
        {"mov of pictures", "jpegenc ! qtmux"},
        {"matroska with B-frames", h264 + "matroskamux"},
        {"webm", "vp8enc deadline=1 keyframe-max-dist=25 ! webmmux"},
        {"mpeg-ts", h264 + "mpegtsmux"},
        {"avi", "avenc_mpeg4 gop-size=25 ! avimux"},
    };
    return containers;
}

/// Writes a turn of the picture into an mp4's track header: cosine, sine of the clockwise angle.
void turn(const std::string& file, int cosine, int sine) {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    const std::string content{std::istreambuf_iterator<char>(stream), {}};
    const std::array<int, 9> matrix{cosine << 16, sine << 16, 0, -sine << 16, cosine << 16, 0, 0, 0, 1 << 30};
    stream.seekp(static_cast<std::streamoff>(content.find("tkhd") + 44));
    for (const int value : matrix) {
        for (const int shift : {24, 16, 8, 0})
            stream.put(static_cast<char>(value >> shift));
    }
}

/// The picture turned by 180 degrees.
Sample turned(const Sample& sample) {
    const auto pixels = std::make_shared<std::vector<std::byte>>(sample.pixels.size());
    const auto pixel = [&](std::size_t x, std::size_t y) { return y * sample.stride + 4 * x; };
    const auto width = static_cast<std::size_t>(sample.width);
    const auto height = static_cast<std::size_t>(sample.height);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            std::copy_n(&sample.pixels[pixel(x, y)], 4, &(*pixels)[pixel(width - 1 - x, height - 1 - y)]);
        }
    }
    Sample result = sample;
    result.pixels = *pixels;
    result.owner = pixels;
    return result;
}

Sample first_picture(const std::string& file, int width, int height) {
    SampleQueue queue(3);
    const FilmLoop loop({file, 0s, 1s, width, height}, queue);
    REQUIRE(queue.wait(patience));
    return queue.take_if([](const LoopedSample&) { return true; })->sample;
}

}  // namespace

TEST_CASE("three loops of a part in mid film are its pictures in order and nothing else") {
    const Folder folder;
    const std::string file = folder.path / "film";
    for (const Container& container : containers()) {
        CAPTURE(container.name);
        write_film(file, {.chain = container.chain});
        const auto time = times(file, 100 - container.lost);
        SampleQueue queue(12);
        const FilmLoop loop({file, time.at(40), time.at(64), 160, 96}, queue);
        CHECK(take_numbers(queue, 72) == loops(40, 24, 3));
        CHECK_FALSE(loop.failure());
    }
}

TEST_CASE("three loops of a whole film are its pictures in order and nothing else") {
    const Folder folder;
    const std::string file = folder.path / "film";
    for (const Container& container : containers()) {
        CAPTURE(container.name);
        write_film(file, {.pictures = 30, .chain = container.chain});
        const int count = 30 - container.lost;
        const auto end = times(file, count).at(count - 1) + 33ms;
        SampleQueue queue(12);
        const FilmLoop loop({file, 0s, end, 160, 96}, queue);
        CHECK(take_numbers(queue, static_cast<std::size_t>(3 * count)) == loops(0, count, 3));
        CHECK_FALSE(loop.failure());
    }
}

TEST_CASE("a film of a single picture gives that picture again and again") {
    const Folder folder;
    write_film(folder.path / "film.mp4", {.pictures = 1, .chain = h264_mp4});
    for (int i = 0; i < 10; ++i) {
        SampleQueue queue(3);
        const FilmLoop loop({folder.path / "film.mp4", 0s, 33ms, 160, 96}, queue);
        CHECK(take_numbers(queue, 20) == loops(0, 1, 20));
    }
}

TEST_CASE("a part of a single picture gives that picture again and again") {
    const Folder folder;
    const std::string file = folder.path / "film";
    for (const Container& container : containers()) {
        CAPTURE(container.name);
        write_film(file, {.chain = container.chain});
        const auto time = times(file, 100 - container.lost);
        SampleQueue queue(3);
        const FilmLoop loop({file, time.at(51), time.at(52), 160, 96}, queue);
        CHECK(take_numbers(queue, 4) == loops(51, 1, 4));
    }
}

TEST_CASE("a film with a rotation flag comes upright and at the size asked for") {
    const Folder folder;
    const std::string file = folder.path / "film.mp4";
    write_film(file, {.pictures = 10, .chain = "x264enc ! mp4mux"});
    turn(file, -1, 0);
    const Sample sample = first_picture(file, 80, 48);
    CHECK(sample.width == 80);
    CHECK(sample.height == 48);
    CHECK(number(sample) == -1);  // it was upright as coded
    CHECK(number(turned(sample)) == 0);
}

TEST_CASE("a film turned by 90 degrees comes in the upright picture's size") {
    const Folder folder;
    const std::string file = folder.path / "film.mp4";
    write_film(file, {.pictures = 10, .chain = "x264enc ! mp4mux"});
    turn(file, 0, 1);
    const Sample sample = first_picture(file, 48, 80);
    CHECK(sample.width == 48);
    CHECK(sample.height == 80);
    const auto green = [&](std::size_t x, std::size_t y) {
        return std::to_integer<int>(sample.pixels[y * sample.stride + 4 * x + 1]);
    };
    CHECK(green(36, 40) > 180);  // the bright band above stands right after a turn clockwise
    CHECK(green(12, 40) < 80);
}

TEST_CASE("another size is taken up while the film plays, and no picture is lost") {
    const Folder folder;
    const std::string file = folder.path / "film.mp4";
    write_film(file, {.chain = h264_mp4});
    SampleQueue queue(4);
    FilmLoop loop({file, 0s, 1h, 160, 96}, queue);
    CHECK(take_numbers(queue, 20) == loops(0, 20, 1));
    loop.resize(80, 48);
    CHECK(take_numbers(queue, 40) == loops(20, 40, 1));
    REQUIRE(queue.wait(patience));
    CHECK(queue.take_if([](const LoopedSample& next) { return next.sample.width == 80; }).has_value());
}

TEST_CASE("a film deleted while it plays plays on") {
    const Folder folder;
    const std::string file = folder.path / "film.mp4";
    write_film(file, {.pictures = 30, .chain = h264_mp4});
    SampleQueue queue(4);
    const FilmLoop loop({file, 0s, 1s, 160, 96}, queue);
    CHECK(take_numbers(queue, 30) == loops(0, 30, 1));
    std::filesystem::remove(file);
    CHECK(take_numbers(queue, 60) == loops(0, 30, 2));
}

TEST_CASE("what is no film, or not there, or has no such part is a failure with a reason") {
    const Folder folder;
    const auto failure = [](const std::string& file, std::chrono::nanoseconds begin) {
        SampleQueue queue(4);
        const FilmLoop loop({file, begin, begin + 1s, 160, 96}, queue);
        CHECK_FALSE(queue.wait(patience));
        CHECK(queue.is_closed());
        return loop.failure().value_or("");
    };
    std::ofstream(folder.path / "text.mp4") << std::string(20000, 'x');
    std::ofstream(folder.path / "empty.mp4").flush();
    write_film(folder.path / "film.mp4", {.pictures = 30, .chain = h264_mp4});
    std::filesystem::copy(folder.path / "film.mp4", folder.path / "half.mp4");
    std::filesystem::resize_file(folder.path / "half.mp4", 2000);
    for (const char* name : {"text.mp4", "empty.mp4", "half.mp4", "missing.mp4"}) {
        CAPTURE(std::string(name));
        CHECK(failure(folder.path / name, 0s).size() > 10);
    }
    CHECK(failure(folder.path / "film.mp4", 30s).size() > 10);
}

TEST_CASE("a film that is stopped ends though nobody takes its pictures") {
    const Folder folder;
    write_film(folder.path / "film.mp4", {.chain = h264_mp4});
    for (int i = 0; i < 20; ++i) {
        SampleQueue queue(2);
        const FilmLoop loop({folder.path / "film.mp4", 0s, 3s, 160, 96}, queue);
        if (i % 2 == 0) queue.wait(patience);
    }
}

TEST_CASE("the middle of every real film loops through the pictures that one pass from the begin shows" *
          doctest::test_suite("real")) {
    const std::filesystem::path codecs = std::filesystem::path(VITRINE_MEDIA) / "codecs";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(codecs)) {
        const std::string file = entry.path();
        CAPTURE(file);
        const auto pass = pictures(file, 0s, 1h, max_pictures);
        if (pass.size() < 9) continue;
        const std::size_t first = pass.size() / 3;
        const std::size_t count = pass.size() / 3;
        const auto looped = pictures(file, pass[first].first, pass[first + count].first, 3 * count);
        REQUIRE(looped.size() == 3 * count);
        for (std::size_t i = 0; i < looped.size(); ++i) {
            CAPTURE(i);
            CHECK(looped[i].second == pass[first + i % count].second);
        }
    }
}
