#include "analyzer/watch/folder_follower.hpp"

#include "base/state/path_text.hpp"
#include "base/system/unique_fd.hpp"

#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <random>

using namespace vitrine;
using namespace vitrine::analyzer;
using namespace std::chrono_literals;

namespace {

constexpr int folders = 100;
constexpr int files_a_folder = 500;

double processor_seconds() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e9;
}

long max_resident_mebibytes() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

}  // namespace

TEST_CASE("of 50,000 files none is missed, though the kernel's queue of events overflowed") {
    const TemporaryDirectory home;
    for (int i = 0; i < folders; ++i)
        std::filesystem::create_directory(home.path / std::to_string(i));
    Schedule schedule(Pace{});
    FolderFollower follower(MediaFolder(home.path), schedule);
    Schedule::Time now{1h};
    follower.rescan(now);
    const long resident_before = max_resident_mebibytes();

    for (int i = 0; i < folders; ++i)
        for (int j = 0; j < files_a_folder; ++j)
            ::close(::open(fmt::format("{}/{}/photo {}.jpg", home.path.string(), i, j).c_str(),
                           O_WRONLY | O_CREAT, 0644));
    const double begin = processor_seconds();
    bool is_lost = false;
    while (!is_lost && schedule.paths_below("").size() < 50'000)
        is_lost = follower.read_events(now);
    CHECK(is_lost);  // it happens with the kernel's usual 16,384 events
    follower.rescan(now);
    const double end = processor_seconds();

    CHECK(schedule.paths_below("").size() == 50'000);
    now += 10s;
    follower.look_at(schedule.files_to_look_at(now), now);
    int due = 0;
    schedule.visit_files([&](const auto&, Schedule::Progress progress, auto) {
        due += progress == Schedule::Progress::due ? 1 : 0;
    });
    CHECK(due == 50'000);
    MESSAGE("events and rescan: ", end - begin, " s of the processor; ",
            max_resident_mebibytes() - resident_before, " MiB more resident");
}

TEST_CASE("in 3,000 orders of events no file of the inbox is ever noticed, and one that leaves it is") {
    namespace fs = std::filesystem;
    const TemporaryDirectory home;
    const std::array<std::string, 4> folders_of{"_INBOX", "_INBOX/new", "hall", "hall/deep"};
    for (const std::string& folder : folders_of)
        fs::create_directories(home.path / folder);
    home.write("first.jpg", "1");
    Schedule schedule(Pace{});
    FolderFollower follower(MediaFolder(home.path), schedule);
    Schedule::Time now{1h};
    follower.rescan(now);
    std::mt19937 random(21);
    const auto chance = [&](std::size_t of) {
        return std::uniform_int_distribution<std::size_t>(0, of - 1)(random);
    };
    const auto place = [&] {
        return home.path / folders_of.at(chance(4)) / fmt::format("{}.jpg", chance(6));
    };
    std::error_code ignored;
    std::size_t noticed = 0;
    for (int order = 0; order < 3000; ++order) {
        for (std::size_t events = 1 + chance(4); events > 0; --events) {
            const std::size_t kind = chance(6);
            if (kind < 2) std::ofstream(place()) << order;
            if (kind == 2 || kind == 3) fs::rename(place(), place(), ignored);
            if (kind == 4) fs::remove(place(), ignored);
            if (kind == 5 && chance(2) == 0) fs::rename(home.path / "_INBOX", home.path / "taken", ignored);
            if (kind == 5) fs::rename(home.path / "taken", home.path / "_INBOX", ignored);
        }
        now += 1s;
        if (follower.read_events(now) || chance(20) == 0) follower.rescan(now);
        follower.look_at(schedule.files_to_look_at(now), now);
        const std::vector<std::string> known = schedule.paths_below("");
        REQUIRE(std::ranges::none_of(known, is_in_inbox));
        noticed += known.size();
        for (const std::string& path : known)
            REQUIRE_MESSAGE((fs::exists(home.path / path) || !follower.is_online()), path);
    }
    CHECK(noticed > 6000);
}

TEST_CASE("a folder whose path is too long to be watched is read now and then, and ends nothing") {
    const TemporaryDirectory home;
    const std::string name(200, 'n');
    UniqueFd below(::open(home.path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    std::string path;
    for (int depth = 0; depth < 30; ++depth) {  // 6000 bytes; the system takes 4096
        REQUIRE(::mkdirat(below.get(), name.c_str(), 0755) == 0);
        below.reset(::openat(below.get(), name.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
        path += name + '/';
    }
    UniqueFd(::openat(below.get(), "photo.jpg", O_WRONLY | O_CREAT | O_CLOEXEC, 0644)).reset();
    Schedule schedule(Pace{});
    FolderFollower follower(MediaFolder(home.path), schedule);

    follower.rescan(Schedule::Time{1h});

    CHECK(schedule.paths_below("") == std::vector{path + "photo.jpg"});
    REQUIRE(follower.remarks().size() == 1);
    CHECK(follower.remarks().front().find("are not watched") != std::string::npos);
}
