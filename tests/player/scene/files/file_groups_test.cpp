#include "player/scene/files/file_groups.hpp"

#include "player/scene/files/near_copies.hpp"
#include "player/scene/wall_slots.hpp"
#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;

namespace {

constexpr std::chrono::sys_days day = std::chrono::year(2023) / 5 / 1;

/// A scene of blobs, seen through a window.
struct Scene {
    explicit Scene(unsigned seed) : engine(seed) {
        for (int i = 0; i < 8; ++i)
            blobs.push_back({{share(), share()}, {share() * 200 - 100, 0.05 + 0.15 * share()}});
    }

    double share() { return static_cast<double>(engine() % 1000) / 1000; }

    double shade(Vec2 at) const {
        double shade = 128;
        for (const auto& [middle, form] : blobs) {
            const Vec2 away = at - middle;
            shade += form.x * std::exp(-(away.x * away.x + away.y * away.y) / (form.y * form.y));
        }
        return shade;
    }

    /// The hash of a look of a window.
    std::uint64_t hash(Vec2 corner, double size) const {
        std::uint64_t hash = 0;
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 8; ++x) {
                const auto at = [&](int column) {
                    return shade(corner + Vec2{(column + 0.5) / 9, (y + 0.5) / 8} * size);
                };
                hash = hash << 1U | static_cast<unsigned>(at(x) > at(x + 1));
            }
        return hash;
    }

    PicturePrint print(Vec2 corner = {0, 0}, double size = 1, double gain = 1) const {
        PicturePrint print{.shades = {}, .sharpness = 1};
        for (int y = 0; y < PicturePrint::side; ++y)
            for (int x = 0; x < PicturePrint::side; ++x) {
                const Vec2 at =
                    corner + Vec2{(x + 0.5) / PicturePrint::side, (y + 0.5) / PicturePrint::side} * size;
                print.shades.push_back(static_cast<std::uint8_t>(std::clamp(shade(at) * gain, 0.0, 255.0)));
            }
        return print;
    }

    std::mt19937 engine;
    std::vector<std::pair<Vec2, Vec2>> blobs;
};

MediaRecord taken(MediaRecord record, std::chrono::milliseconds at, TimeSource source = TimeSource::camera) {
    record.origin.taken = TimeTaken{.at = day + at, .zone = {}, .source = source};
    return record;
}

MediaRecord seen(const std::string& path, const PicturePrint& print, double sharpness = 1) {
    MediaRecord record = photo(path);
    record.shots.front().print = print;
    record.shots.front().print->sharpness = sharpness;
    record.shots.front().look = ShotLook{};
    return record;
}

std::vector<std::string> group_with(const std::vector<MediaRecord>& records, const std::string& path) {
    FileGroups groups;
    groups.set_files(records);
    const auto entry = groups.groups().find(path);
    return entry ? entry->group->photos : std::vector<std::string>{};
}

/// The folder: 16 photos, 8 frames of one burst, and one Live Photo.
std::vector<MediaRecord> folder() {
    std::vector<MediaRecord> records;
    for (unsigned i = 0; i < 16; ++i)
        records.push_back(taken(seen("photo" + std::to_string(100 + i) + ".jpg", Scene(100 + i).print()),
                                std::chrono::hours(i)));
    const Scene take(7);
    for (int i = 0; i < 8; ++i)
        records.push_back(
            taken(seen("burst" + std::to_string(i) + ".jpg",
                       take.print({0.004 * i, 0.003 * i}, 0.95, 0.9 + 0.02 * i), i == 5 ? 9 : 1),
                  48h + i * 200ms));
    records.push_back(taken(seen("IMG_0001.HEIC", Scene(9).print()), 60h));
    records.push_back(taken(film("IMG_0001.MOV", 1, 3s), 60h + 1s));
    return records;
}

ShowHints hints_of(const std::vector<MediaRecord>& records) {
    FileGroups groups;
    groups.set_files(records);
    ShowHints hints;
    hints.groups = groups.groups();
    return hints;
}

/// The most frames of the burst, and of halves of the Live Photo, beside each other.
struct Crowd {
    long burst = 0;
    long live = 0;
    std::set<std::string> seen;

    void look(const std::vector<WallShot>& shots) {
        const auto count = [&](const char* begin) {
            return std::ranges::count_if(
                shots, [&](const WallShot& shot) { return shot.key.path.starts_with(begin); });
        };
        burst = std::max<long>(burst, count("burst"));
        live = std::max<long>(live, count("IMG"));
        for (const WallShot& shot : shots)
            seen.insert(shot.key.path);
    }
};

Crowd crowd_of(unsigned seed, const std::vector<MediaRecord>& records, const ShowHints& hints) {
    WallSlots slots({.count = 12, .seed = seed, .dwell = 20s, .lead = 0s});
    slots.set_catalogue(records, hints);
    Crowd crowd;
    for (std::chrono::nanoseconds now{0}; now < 20min; now += 1s) {
        for (const WallShot& shot : slots.shots())
            slots.shot_appeared(shot.source, now);
        slots.advance(now);
        crowd.look(slots.shots());
    }
    return crowd;
}

void check_crowds(unsigned seeds) {
    const std::vector<MediaRecord> records = folder();
    const ShowHints hints = hints_of(records);
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        CAPTURE(seed);
        const Crowd crowd = crowd_of(seed, records, hints);
        CHECK(crowd.burst == 1);
        CHECK(crowd.live <= 1);
        CHECK(crowd.seen.contains("IMG_0001.HEIC"));
    }
}

}  // namespace

TEST_CASE("a crop is near to a part of the whole photo, however far from the photo itself") {
    int far = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        const Scene scene(seed);
        Shot whole, crop;
        whole.print = scene.print();
        whole.look = ShotLook{.hash = scene.hash({0, 0}, 1)};
        crop.print = scene.print({0.2, 0.2}, 0.8);
        crop.look = ShotLook{.hash = scene.hash({0.2, 0.2}, 0.8)};
        const int distance = distance_between(hashes_of(whole), hashes_of(crop));
        CHECK(distance <= 22);
        CHECK(distance == distance_between(hashes_of(crop), hashes_of(whole)));
        if (std::popcount(whole.look->hash ^ crop.look->hash) > 22) ++far;
    }
    CHECK(far > 3);
}

TEST_CASE("two skies that were taken at once are two, and with the same clouds they are one") {
    const auto sky = [](const char* path, double cloud) {
        PicturePrint print{.shades = {}, .sharpness = 1};
        for (int y = 0; y < PicturePrint::side; ++y)
            for (int x = 0; x < PicturePrint::side; ++x) {
                const double away = (x - cloud) * (x - cloud) + (y - 8.0) * (y - 8.0);
                print.shades.push_back(static_cast<std::uint8_t>(50 + 8 * y + 40 * std::exp(-away / 6)));
            }
        return seen(path, print);
    };
    const MediaRecord first = taken(sky("a.jpg", 4), 0s);
    CHECK(group_with({first, taken(sky("b.jpg", 12), 1s)}, "a.jpg").empty());
    CHECK(group_with({first, taken(sky("b.jpg", 4.2), 1s)}, "a.jpg").size() == 2);
}

TEST_CASE("frames of a burst are one group, the sharpest first, and other photos are none") {
    const std::vector<MediaRecord> records = folder();
    const std::vector<std::string> burst = group_with(records, "burst3.jpg");
    CHECK(burst.size() == 8);
    CHECK(burst.front() == "burst5.jpg");
    CHECK(group_with(records, "photo103.jpg").empty());
}

TEST_CASE("the same room a month later is another picture, however alike") {
    const Scene room(3);
    const std::vector<MediaRecord> apart{taken(seen("a.jpg", room.print()), 0h),
                                         taken(seen("b.jpg", room.print()), 24h * 30)};
    CHECK(group_with(apart, "a.jpg").empty());
    const std::vector<MediaRecord> by_files{taken(seen("a.jpg", room.print()), 0h, TimeSource::file),
                                            taken(seen("b.jpg", room.print()), 24h * 30, TimeSource::file)};
    CHECK(group_with(by_files, "a.jpg").empty());
}

TEST_CASE("a crop, another exposure and a copy are one with their photo, the whole one first") {
    const Scene scene(4);
    MediaRecord crop = seen("b.jpg", scene.print({0.08, 0.05}, 0.85), 50);
    crop.width = 400;
    crop.height = 225;
    const std::vector<MediaRecord> records{seen("c.jpg", scene.print()), crop,
                                           seen("d.jpg", scene.print({0, 0}, 1, 0.7), 0.5)};
    CHECK(group_with(records, "b.jpg") == std::vector<std::string>{"c.jpg", "d.jpg", "b.jpg"});
}

TEST_CASE("a picture of another shape is no crop, and one thing in another colour makes two") {
    const Scene scene(4);
    MediaRecord ribbon = seen("ribbon.jpg", scene.print());
    ribbon.width = 4000;
    ribbon.height = 100;
    CHECK(group_with({seen("a.jpg", scene.print()), ribbon}, "a.jpg").empty());
    MediaRecord red = seen("red.jpg", scene.print());
    MediaRecord blue = seen("blue.jpg", scene.print());
    for (MediaRecord* record : {&red, &blue})
        record->shots.front().look = ShotLook{};
    CHECK(group_with({red, blue}, "red.jpg").size() == 2);
    red.shots.front().look->colours[12] = 200;  // the field in the middle
    blue.shots.front().look->colours[14] = 200;
    CHECK(group_with({red, blue}, "red.jpg").empty());
}

TEST_CASE("two photos taken within a second that show different things are two") {
    const std::vector<MediaRecord> records{taken(seen("a.jpg", Scene(1).print()), 0s),
                                           taken(seen("b.jpg", Scene(2).print()), 1s)};
    CHECK(group_with(records, "a.jpg").empty());
}

TEST_CASE("a photo and its film are a Live Photo by their identifier, or by name and time") {
    const MediaRecord still = taken(seen("a/IMG_1.HEIC", Scene(1).print()), 0s);
    const auto is_pair = [&](MediaRecord moving) { return are_live_pair(still, moving); };
    CHECK(is_pair(taken(film("a/IMG_1.mov", 1, 3s), 1s)));
    CHECK_FALSE(is_pair(taken(film("a/IMG_1.mov", 1, 3s), 2h)));
    CHECK_FALSE(is_pair(taken(film("a/IMG_1.mov", 9, 3s), 1s)));
    CHECK_FALSE(is_pair(taken(film("a/IMG_2.mov", 1, 3s), 1s)));
    CHECK_FALSE(is_pair(taken(film("b/IMG_1.mov", 1, 3s), 1s)));
    MediaRecord named = still;
    named.origin.content_id = "A";
    MediaRecord other = taken(film("b/x.mov", 1, 3s), 9h);
    other.origin.content_id = "A";
    CHECK(are_live_pair(named, other));
    other.origin.content_id = "B";
    other.path = "a/IMG_1.mov";
    CHECK_FALSE(are_live_pair(named, other));
}

TEST_CASE("a camera that wrote no zone may be whole quarters of an hour off its film") {
    const MediaRecord still = taken(seen("IMG_1.JPG", Scene(1).print()), 2h, TimeSource::camera_clock);
    CHECK(are_live_pair(still, taken(film("IMG_1.MOV", 1, 3s), 1s)));
    CHECK_FALSE(are_live_pair(still, taken(film("IMG_1.MOV", 1, 3s), 7min)));
}

TEST_CASE("pictures that change slowly are no chain: each is near to the best of its group") {
    const Scene scene(7);
    std::vector<MediaRecord> records;
    for (int i = 0; i < 7; ++i)
        records.push_back(
            taken(seen("pan" + std::to_string(i) + ".jpg", scene.print({0.06 * i, 0}, 0.6), i == 0 ? 9 : 1),
                  i * 200ms));
    FileGroups groups;
    groups.set_files(records);
    const auto first = groups.groups().find("pan0.jpg");
    REQUIRE(first);
    CHECK(first->group->photos.size() > 1);
    for (const MediaRecord& record : records) {
        const auto entry = groups.groups().find(record.path);
        if (!entry) continue;
        for (const std::string& photo : entry->group->photos) {
            const auto& best = *std::ranges::find(records, entry->group->photos.front(), &MediaRecord::path);
            const auto& member = *std::ranges::find(records, photo, &MediaRecord::path);
            CHECK(are_near_copies(best, member));
        }
    }
    const auto last = groups.groups().find("pan6.jpg");
    CHECK((!last || last->group != first->group));
}

TEST_CASE("groups follow files that come and go") {
    std::vector<MediaRecord> records = folder();
    FileGroups groups;
    groups.set_files(records);
    std::erase_if(records, [](const MediaRecord& record) { return record.path == "burst5.jpg"; });
    groups.set_files(records);
    CHECK_FALSE(groups.groups().contains("burst5.jpg"));
    CHECK(groups.groups().find("burst3.jpg")->group->photos.size() == 7);
    std::erase_if(records, [](const MediaRecord& record) { return record.path.ends_with(".MOV"); });
    groups.set_files(records);
    CHECK_FALSE(groups.groups().contains("IMG_0001.HEIC"));
}

TEST_CASE("never two of a burst nor both halves of a Live Photo are on the wall") {
    const char* given = std::getenv("VITRINE_SEEDS");
    check_crowds(given == nullptr ? 6 : static_cast<unsigned>(std::strtoul(given, nullptr, 10)));
}

TEST_CASE("the others of a burst take its place in turn, also where all files fit on the wall") {
    const std::vector<MediaRecord> all = folder();
    const std::vector<MediaRecord> burst(all.begin() + 16, all.begin() + 24);
    const Crowd crowd = crowd_of(1, burst, hints_of(burst));
    CHECK(crowd.burst == 1);
    CHECK(crowd.seen.size() == 8);
}

TEST_CASE("what turns out to be one is not left twice on the wall") {
    const std::vector<MediaRecord> all = folder();
    const std::vector<MediaRecord> burst(all.begin() + 16, all.begin() + 24);
    WallSlots slots({.count = 12, .seed = 1, .lead = 0s});
    slots.set_catalogue(burst);
    CHECK(slots.shots().size() == 8);
    slots.set_catalogue(burst, hints_of(burst));
    CHECK(slots.shots().size() == 1);
}

TEST_CASE("the film of a Live Photo plays once when it comes, then the photo takes its place") {
    const std::vector<MediaRecord> all = folder();
    const std::vector<MediaRecord> pair(all.begin() + 24, all.end());
    WallSlots slots({.count = 12, .seed = 1, .dwell = 20s, .lead = 0s});
    slots.set_catalogue(pair, hints_of(pair));
    std::vector<std::string> seen;
    for (std::chrono::nanoseconds now{0}; now < 60s; now += 1s) {
        for (const WallShot& shot : slots.shots())
            slots.shot_appeared(shot.source, now);
        slots.advance(now);
        REQUIRE(slots.shots().size() == 1);
        seen.push_back(slots.shots().front().key.path);
    }
    CHECK(std::ranges::count(seen, "IMG_0001.MOV") == 3);
    CHECK(seen.front() == "IMG_0001.MOV");
    CHECK(seen.back() == "IMG_0001.HEIC");
}

TEST_CASE("the film inside a motion photo plays once when it comes, if the store has it") {
    MediaRecord moving = photo("moving.jpg");
    Shot shot = film("x", 1, 3s).shots[0];
    shot.stored = StoredShot{.file = "0123/clip.mp4", .width = 64, .height = 36};
    moving.film = InnerFilm{.shot = shot, .width = 1920, .height = 1080};
    WallSlots slots({.count = 12, .seed = 1, .dwell = 20s, .lead = 0s});
    slots.set_catalogue(std::vector{moving, photo("other.jpg")});
    const auto kinds = [&] {
        std::vector<MediaKind> found;
        for (const WallShot& each : slots.shots()) {
            slots.shot_appeared(each.source, 0s);
            if (each.key.path == "moving.jpg") found.push_back(each.kind);
        }
        return found;
    };
    CHECK(kinds() == std::vector{MediaKind::film});
    slots.advance(2s);
    CHECK(kinds() == std::vector{MediaKind::film});
    slots.advance(4s);
    CHECK(kinds() == std::vector{MediaKind::photo});
    slots.advance(15s);
    CHECK(kinds() == std::vector{MediaKind::photo});

    WallSlots failing({.count = 12, .seed = 1, .lead = 0s});
    failing.set_catalogue(std::vector{moving});
    failing.source_failed(failing.shots().front().source, 1s);
    REQUIRE(failing.shots().size() == 1);
    CHECK(failing.shots().front().kind == MediaKind::photo);

    moving.film->shot.stored->is_dropped = true;
    WallSlots without({.count = 12, .seed = 1, .lead = 0s});
    without.set_catalogue(std::vector{moving});
    CHECK(without.shots().front().kind == MediaKind::photo);
}

TEST_CASE("where its film cannot be played a Live Photo is a photo") {
    const std::vector<MediaRecord> all = folder();
    const std::vector<MediaRecord> pair(all.begin() + 24, all.end());
    WallSlots slots({.count = 12, .seed = 1, .lead = 0s});
    slots.set_catalogue(pair, hints_of(pair));
    slots.source_failed(slots.shots().front().source, 1s);
    REQUIRE(slots.shots().size() == 1);
    CHECK(slots.shots().front().key.path == "IMG_0001.HEIC");
}

TEST_CASE("without its photo the film of a Live Photo is a film") {
    std::vector<MediaRecord> records = folder();
    const ShowHints hints = hints_of(records);
    std::erase_if(records, [](const MediaRecord& record) { return record.path == "IMG_0001.HEIC"; });
    WallSlots slots({.count = 30, .seed = 1, .lead = 0s});
    slots.set_catalogue(records, hints);
    Crowd crowd;
    crowd.look(slots.shots());
    CHECK(crowd.seen.contains("IMG_0001.MOV"));
}
