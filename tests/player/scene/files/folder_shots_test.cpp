#include "player/scene/files/folder_shots.hpp"

#include "tests/player/scene/scene_media.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <random>

using namespace vitrine;
using namespace vitrine::player;

namespace {

using Keys = std::vector<ShotKey>;

/// Photos of series as cameras make them, short and long ones: every picture of a series differs little from
/// its first one.
std::vector<MediaRecord> series(std::mt19937_64& random) {
    std::vector<MediaRecord> records;
    for (int i = 0; const int of_each : {30, 6, 2, 1, 1, 1}) {
        ++i;
        ShotLook first{.hash = random()};
        for (std::uint8_t& colour : first.colours)
            colour = static_cast<std::uint8_t>(random() % 256);
        for (int k = 0; k < of_each; ++k) {
            ShotLook look = first;
            for (int bit = 0; bit < 4; ++bit)
                look.hash ^= std::uint64_t{1} << random() % 64;
            MediaRecord record = photo("s" + std::to_string(i) + "/" + std::to_string(100 + k));
            record.shots[0].look = look;
            records.push_back(record);
        }
    }
    return records;
}

double mean_distance(const RecordList& files, const Keys& keys) {
    double sum = 0;
    int pairs = 0;
    for (std::size_t i = 0; i < keys.size(); ++i)
        for (std::size_t j = 0; j < i; ++j, ++pairs)
            sum +=
                unlikeness(*files.find(keys[i].path), keys[i].shot, *files.find(keys[j].path), keys[j].shot);
    return sum / pairs;
}

Keys random_five(const std::vector<MediaRecord>& records, std::mt19937_64& random) {
    std::vector<MediaRecord> five;
    std::ranges::sample(records, std::back_inserter(five), 5, random);
    Keys keys;
    for (const MediaRecord& record : five)
        keys.push_back({record.path, 0});
    return keys;
}

}  // namespace

TEST_CASE("the shots of a folder are less alike by half than five at random") {
    std::mt19937_64 random(7);
    double chosen = 0;
    double usual = 0;
    for (int folder = 0; folder < 40; ++folder) {
        const std::vector<MediaRecord> records = series(random);
        const RecordList files(records);
        chosen += mean_distance(files, folder_shots(files, {}, {}, 5));
        usual += mean_distance(files, random_five(records, random));
    }
    CHECK(chosen >= 1.5 * usual);
}

TEST_CASE("of shots that are equally unlike the most telling one comes first") {
    std::vector<MediaRecord> records = photos(6);
    records[4].shots[0].region.polygon = {{40, 20}, {600, 20}, {600, 340}, {40, 340}};
    records[3].shots[0].region.polygon = {{0, 0}, {20, 0}, {20, 20}, {0, 20}};
    const Keys keys = folder_shots(records, {}, {}, 5);
    REQUIRE(keys.size() == 5);
    CHECK(keys.front().path == "p104");
    CHECK(std::ranges::find(keys, "p103", &ShotKey::path) == keys.end());
}

TEST_CASE(
    "records without a look: shots of different sub-folders come first, then other files, then other times") {
    const RecordList files(std::vector{film("a/1", 4), photo("a/2"), photo("b/3"), photo("c/4")});
    Keys keys = folder_shots(files, {}, {}, 3);
    std::set<char> folders;
    for (const ShotKey& key : keys)
        folders.insert(key.path[0]);
    CHECK(folders.size() == 3);
    keys = folder_shots(files, {}, {}, 4);
    std::set<std::string> paths;
    for (const ShotKey& key : keys)
        paths.insert(key.path);
    CHECK(paths.size() == 4);
    CHECK(folder_shots(files, {}, {}, 20).size() == 7);
}

TEST_CASE("what stays comes first, and what is avoided does not come") {
    const RecordList files(photos(8));
    const Keys kept{{"p105", 0}, {"p102", 0}};
    const Keys keys = folder_shots(files, kept, {"p100", "p101"}, 5);
    REQUIRE(keys.size() == 5);
    CHECK(keys[0] == kept[0]);
    CHECK(keys[1] == kept[1]);
    for (const ShotKey& key : keys)
        CHECK(key.path > "p101");
    CHECK(folder_shots(files, kept, {"p100", "p101"}, 5) == keys);
}

TEST_CASE("a large folder is looked at in all its parts") {
    std::vector<MediaRecord> records;
    for (int i = 0; i < 5000; ++i)
        records.push_back(photo("f" + std::to_string(10'000 + i)));
    records[4983].shots[0].region.polygon = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Keys keys = folder_shots(RecordList(records), {}, {}, 5);
    CHECK(keys.size() == 5);
}
