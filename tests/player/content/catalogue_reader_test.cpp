#include "player/content/catalogue_reader.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <atomic>

using namespace vitrine;
using namespace vitrine::player;

namespace {

MediaRecord record(const std::string& path, std::int64_t mtime = 1, MediaState state = MediaState::ready) {
    return {.path = path, .mtime_ns = mtime, .state = state, .width = 4, .height = 3, .shots = {Shot{}}};
}

std::string name_of_record(const std::string& path) {
    return record_id(path) + ".json";
}

/// A catalogue and its reader.
struct House {
    CatalogueNews read(const std::set<std::string>& names) {
        reader.request_files(names);
        reader.finish();
        return reader.pop_news().value_or(CatalogueNews{});
    }

    TemporaryDirectory home;
    Catalogue catalogue{home.path / "catalogue"};
    std::atomic<int> told = 0;
    CatalogueReader reader{catalogue, [this] { ++told; }};
};

}  // namespace

TEST_CASE("only the files that are named are read") {
    House house;
    house.catalogue.store(record("b"));
    house.catalogue.store(record("a"));
    house.reader.request_all();
    house.reader.finish();
    const CatalogueNews all = house.reader.pop_news().value();
    CHECK(all.change.added == std::vector<std::string>{"a", "b"});
    REQUIRE(all.records.size() == 2);
    CHECK((*all.records.begin())->path == "a");
    CHECK(all.counts.at(MediaState::ready) == 2);

    house.catalogue.store(record("a", 2));
    house.catalogue.store(record("b", 2));
    const CatalogueNews one = house.read({name_of_record("a")});
    CHECK(one.change.replaced == std::vector<std::string>{"a"});
    CHECK(one.records.find("b") == all.records.find("b"));  // the same object: it was neither read nor copied

    house.catalogue.store(record("a", 2));  // written again, and nothing in it changed
    const CatalogueNews other = house.read({name_of_record("a"), name_of_record("b")});
    CHECK(other.change.replaced == std::vector<std::string>{"b"});
    CHECK(other.records.find("a") == one.records.find("a"));  // the same object

    house.catalogue.remove("a");
    CHECK(house.read({name_of_record("a")}).change.gone == std::vector<std::string>{"a"});
    CHECK(house.read({name_of_record("a")}).change.is_empty());
    CHECK(house.told >= 3);
}

TEST_CASE("what nobody has fetched yet is told with what came later") {
    House house;
    house.catalogue.store(record("a"));
    house.reader.request_files({name_of_record("a")});
    house.reader.finish();
    house.catalogue.store(record("b"));
    const CatalogueNews news = house.read({name_of_record("b")});
    CHECK(news.change.added == std::vector<std::string>{"a", "b"});
    CHECK(news.records.size() == 2);
    CHECK_FALSE(house.reader.pop_news().has_value());
}

TEST_CASE("a record that cannot be read is told once and hides no other") {
    House house;
    house.catalogue.store(record("a"));
    house.home.write("catalogue/0000000000000000.json", "{");
    house.home.write("catalogue/notes.txt", "nothing of ours");
    house.reader.request_all();
    house.reader.finish();
    const CatalogueNews news = house.reader.pop_news().value();
    CHECK(news.records.size() == 1);
    CHECK(news.unreadable.size() == 1);
    CHECK(house.read({"0000000000000000.json"}).unreadable.empty());
}
