#include "player/playback/reader/upload_readers.hpp"

#include "player/playback/film_loop.hpp"
#include "tests/player/playback/numbered_film.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr auto patience = 30s;
const std::string mp4 = "x264enc key-int-max=25 speed-preset=veryfast ! mp4mux";

struct Readers {
    std::shared_ptr<ReaderHost> host =
        std::make_shared<ReaderHost>(std::vector<std::string>{VITRINE_TEST_READER_HOST});
    Folder folder;

    std::string file(const std::string& name) const { return folder.path / name; }

    UploadFactories factories() const { return upload_readers(host, folder.path); }
};

/// All bytes that belong to a picture, row by row.
std::string bytes_of(const Sample& sample) {
    std::string bytes = fmt::format("{}x{} ", sample.width, sample.height);
    const auto add = [&](std::span<const std::byte> plane, std::size_t stride, std::size_t row, int rows) {
        for (int i = 0; i < rows; ++i)
            bytes.append(reinterpret_cast<const char*>(&plane[static_cast<std::size_t>(i) * stride]), row);
    };
    const auto width = static_cast<std::size_t>(sample.width);
    if (is_rgb(sample.layout)) {
        add(sample.pixels, sample.stride, 4 * width, sample.height);
        return bytes;
    }
    add(sample.pixels, sample.stride, width, sample.height);
    for (const Sample::Plane& plane : sample.chroma)
        if (!plane.bytes.empty()) add(plane.bytes, plane.stride, (width + 1) / 2, (sample.height + 1) / 2);
    return bytes;
}

struct Seen {
    std::string bytes;
    std::chrono::nanoseconds time{0};
    std::chrono::nanoseconds duration{0};
    std::uint64_t loop = 0;

    bool operator==(const Seen&) const = default;
};

std::vector<Seen> take(SampleQueue& queue, std::size_t count) {
    std::vector<Seen> seen;
    while (seen.size() < count && queue.wait(patience)) {
        const auto taken = queue.take_if([](const LoopedSample&) { return true; });
        seen.push_back({bytes_of(taken->sample), taken->sample.stream_time, taken->duration, taken->loop});
    }
    return seen;
}

/// True once the condition holds, within the patience.
template <typename Condition> bool comes_true(const Condition& condition) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
        if (condition()) return true;
        std::this_thread::sleep_for(2ms);
    }
    return false;
}

/// The processes that the host has started and that are not over yet.
std::vector<pid_t> readers_of(pid_t host) {
    std::ifstream list(fmt::format("/proc/{0}/task/{0}/children", host));
    std::vector<pid_t> readers;
    for (pid_t reader = 0; list >> reader;)
        readers.push_back(reader);
    return readers;
}

}  // namespace

TEST_CASE("a film of a reader has the very pictures and times of one that is decoded here, loop after loop") {
    const Readers readers;
    write_film(readers.file("film"), {.chain = mp4});
    for (const PictureForm form : {PictureForm::bgra, PictureForm::planes}) {
        const FilmPart part{.file = readers.file("film"),
                            .begin = 1s,
                            .end = 2s,
                            .width = numbered_width,
                            .height = numbered_height};
        SampleQueue here_queue(12);
        SampleQueue queue(12);
        const FilmLoop here(part, here_queue, {.form = form});
        const auto film = readers.factories().make_film(part, queue, {.form = form});
        const std::vector<Seen> seen = take(queue, 75);
        CHECK(seen.size() == 75);
        CHECK((seen == take(here_queue, 75)));
        CHECK(film->spent() > 0s);
        CHECK_FALSE(film->failure());
    }
}

TEST_CASE("a film of a reader follows its size and its place") {
    const Readers readers;
    write_film(readers.file("film"), {.chain = mp4});
    SampleQueue queue(4);
    const auto film = readers.factories().make_film(
        {.file = readers.file("film"), .begin = 0s, .end = 3s, .width = 80, .height = 48}, queue, {});
    CHECK(take(queue, 2).size() == 2);
    film->resize(160, 96);
    film->play_from(Detail::all, 2s);
    CHECK(comes_true([&] {
        const auto taken = queue.take_if([](const LoopedSample&) { return true; });
        return taken && taken->sample.width == 160 && number(taken->sample) >= 60;
    }));
}

TEST_CASE("a photo of a reader has the very pixels of one that is read here") {
    const Readers readers;
    write_photo(readers.file("photo"));
    SampleQueue queue(4);
    const PhotoWish wish{.file = readers.file("photo"), .width = 40, .height = 20};
    const auto photo = readers.factories().make_photo(wish, queue);
    const std::vector<Seen> seen = take(queue, 1);
    REQUIRE(seen.size() == 1);
    CHECK((seen.front().bytes == bytes_of(load_photo(wish))));
    CHECK(comes_true([&] { return photo->has_ended(); }));
    CHECK_FALSE(queue.is_closed());
    CHECK_FALSE(photo->failure());
}

TEST_CASE("what cannot be read is told in the same words as here") {
    const Readers readers;
    std::ofstream(readers.file("text")) << "hello, this is a text";
    fs::create_symlink("/etc/passwd", readers.file("link"));
    fs::create_directory(readers.file("folder"));
    const auto reason = [&](const std::string& name) {
        SampleQueue queue(4);
        const auto photo =
            readers.factories().make_photo({.file = readers.file(name), .width = 8, .height = 8}, queue);
        CHECK(comes_true([&] { return photo->has_ended(); }));
        CHECK(queue.is_closed());
        CHECK_FALSE(photo->has_crashed());
        return photo->failure().value_or("");
    };
    CHECK(reason("text") == "this is a text, not a picture or film");
    CHECK(reason("missing") == "the file cannot be opened: No such file or directory");
    CHECK(reason("link") == "this is a link; links are not followed");
    CHECK(reason("folder") == "this is not a regular file");
    CHECK(reason("../outside") == "this is a link; links are not followed");
}

TEST_CASE("a reader that dies leaves a reason, and the next one is started") {
    const Readers readers;
    write_film(readers.file("film"), {.chain = mp4});
    const FilmPart part{.file = readers.file("film"), .begin = 0s, .end = 3s, .width = 80, .height = 48};
    for (const int signal : {SIGKILL, SIGTRAP}) {
        CAPTURE(signal);
        SampleQueue queue(4);
        const auto film = readers.factories().make_film(part, queue, {});
        REQUIRE(queue.wait(patience));
        const std::vector<pid_t> started = readers_of(readers.host->process());
        REQUIRE(started.size() == 1);
        ::kill(started.front(), signal);
        CHECK(comes_true([&] {  // the pictures before come first
            (void)queue.take_if([](const LoopedSample&) { return true; });
            return film->has_ended();
        }));
        CHECK(queue.is_closed());
        REQUIRE(film->failure());
        CAPTURE(*film->failure());
        CHECK(film->has_crashed() == (signal == SIGTRAP));
        CHECK(comes_true([&] { return readers_of(readers.host->process()).empty(); }));
    }
}

TEST_CASE("the host is started again if it has ended") {
    const Readers readers;
    write_photo(readers.file("photo"));
    const pid_t first = readers.host->process();
    ::kill(first, SIGKILL);
    CHECK(comes_true([&] {
        SampleQueue queue(4);
        const auto photo =
            readers.factories().make_photo({.file = readers.file("photo"), .width = 40, .height = 20}, queue);
        return queue.wait(patience);
    }));
    CHECK(readers.host->process() != first);
}

TEST_CASE("a film that is stopped or destroyed ends its reader") {
    const Readers readers;
    write_film(readers.file("film"), {.chain = mp4});
    const FilmPart part{.file = readers.file("film"), .begin = 0s, .end = 3s, .width = 80, .height = 48};
    SampleQueue queue(4);
    auto film = readers.factories().make_film(part, queue, {});
    REQUIRE(queue.wait(patience));
    film->stop();
    CHECK(comes_true([&] { return film->has_ended(); }));
    CHECK_FALSE(film->failure());
    CHECK(comes_true([&] { return readers_of(readers.host->process()).empty(); }));
    SampleQueue other(4);
    film = readers.factories().make_film(part, other, {});
    REQUIRE(other.wait(patience));
    const auto last = other.take_if([](const LoopedSample&) { return true; });
    film.reset();
    CHECK(comes_true([&] { return readers_of(readers.host->process()).empty(); }));
    CHECK(number(last->sample) == 0);  // its memory is still there
}

TEST_CASE("the host has one thread, none of the player's descriptors, and ends with the player's end") {
    const Readers readers;
    write_film(readers.file("film"), {.chain = mp4});
    SampleQueue queue(4);
    const auto film = readers.factories().make_film(
        {.file = readers.file("film"), .begin = 0s, .end = 3s, .width = 80, .height = 48}, queue, {});
    REQUIRE(queue.wait(patience));
    const fs::path process = fmt::format("/proc/{}", readers.host->process());
    const auto count = [](const fs::path& folder) {
        return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
    };
#if !defined(__SANITIZE_ADDRESS__)
    CHECK(count(process / "task") == 1);
#endif
    CHECK(count(process / "fd") <= 3 + 1 + 2);  // the standard ones, the orders, and two for its reader
    // This process has nothing of the folder open, nor mapped.
    for (const auto& entry : fs::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        CHECK(fs::read_symlink(entry, gone).string().find(readers.folder.path.string()) == std::string::npos);
    }
}
