#include "player/scene/files/shared_list.hpp"

#include <doctest/doctest.h>

#include <map>
#include <random>

using namespace vitrine::player;

namespace {

struct Named {
    std::string path;
    int value = 0;
};

using List = SharedList<Named>;
using Plain = std::map<std::string, int>;

List::Entry entry(const std::string& path, int value = 0) {
    return std::make_shared<const Named>(Named{.path = path, .value = value});
}

List numbered(int count) {
    std::vector<List::Entry> entries;
    for (int i = 0; i < count; ++i)
        entries.push_back(entry("f" + std::to_string(100'000 + i), i));
    return List(std::move(entries));
}

Plain plain(const List& list) {
    Plain all;
    for (const List::Entry& one : list)
        all.emplace(one->path, one->value);
    return all;
}

/// The blocks that two lists with equally many share.
int shared_blocks(const List& a, const List& b) {
    int shared = 0;
    auto one = a.begin(), other = b.begin();
    for (; one != a.end() && other != b.end(); one.skip_block(), other.skip_block())
        if (one.begins_same_block(other)) ++shared;
    return shared;
}

}  // namespace

TEST_CASE("entries are in the order of their paths, and each path is there once") {
    const List list({entry("b", 1), entry("a", 2), entry("b", 3)});
    CHECK(plain(list) == Plain{{"a", 2}, {"b", 1}});
    CHECK((*list.begin())->path == "a");
    CHECK(list.size() == 2);
    CHECK(list.find("b")->value == 1);
    CHECK_FALSE(list.find("c"));
    CHECK(List().is_empty());
}

TEST_CASE("a change of one entry copies one block of many") {
    const List before = numbered(60'000);
    List now = before;
    now.apply({{"f130000", entry("f130000", 7)}});
    const int blocks = shared_blocks(before, before);
    CHECK(blocks >= 60'000 / static_cast<int>(List::max_block));
    CHECK(shared_blocks(before, now) == blocks - 1);
    CHECK(before.find("f130000")->value == 30'000);

    int changes = 0;
    now.for_each_change(before, [&](const List::Entry& old, const List::Entry& fresh) {
        ++changes;
        CHECK(old->value == 30'000);
        CHECK(fresh->value == 7);
    });
    CHECK(changes == 1);
}

TEST_CASE("after any changes a list holds what a map would, and tells what has changed") {
    std::mt19937 random(11);
    List list = numbered(700);
    Plain expected = plain(list);
    for (int round = 0; round < 300; ++round) {
        List::Changes changes;
        for (auto i = random() % 40; i > 0; --i) {
            const std::string path = "f" + std::to_string(99'800 + random() % 1'200);
            const bool is_removed = random() % 3 == 0;
            changes[path] = is_removed ? nullptr : entry(path, round);
            if (is_removed)
                expected.erase(path);
            else
                expected[path] = round;
        }
        const List before = list;
        list.apply(changes);
        REQUIRE(plain(list) == expected);
        REQUIRE(list.size() == expected.size());
        Plain told = plain(before);
        list.for_each_change(before, [&](const List::Entry& old, const List::Entry& now) {
            REQUIRE(changes.contains((now ? now : old)->path));
            if (now)
                told[now->path] = now->value;
            else
                told.erase(old->path);
        });
        REQUIRE(told == expected);
    }
    for (const auto& [path, value] : expected)
        REQUIRE(list.find(path)->value == value);
}

TEST_CASE("a part of a list has the entries from one path to another, and shares their blocks") {
    const List list = numbered(2'000);
    const List part = list.between("f100300", "f101700");
    CHECK(part.size() == 1'400);
    CHECK((*part.begin())->path == "f100300");
    CHECK(part.contains("f101699"));
    CHECK_FALSE(part.contains("f101700"));
    CHECK(list.between("g", "h").is_empty());
    CHECK(list.between("", "z").size() == 2'000);

    int changes = 0;
    part.for_each_change(list.between("f100300", "f101700"), [&](const auto&, const auto&) { ++changes; });
    CHECK(changes == 0);
}
