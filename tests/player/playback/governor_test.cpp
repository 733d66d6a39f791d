#include "player/playback/governor.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <vector>

using namespace vitrine;
using namespace vitrine::player;

namespace {

/// The cost of a film on each step of the ladder, as measured: 0.156, 0.121 and 0.0116 cores.
double share(Detail detail) {
    constexpr double shares[] = {1, 0.78, 0.08, 0};
    return shares[static_cast<int>(detail)];
}

struct Film {
    SourceId source = 0;
    double cost = 0;  // cores, of all pictures
    double salience = 0;
};

/// A machine with some cores that shows thirty pictures a second of each film where it can.
struct Machine {
    double cores = 1;
    std::vector<Film> films;
    Governor governor;
    std::vector<Governor::Change> changes;
    double late = 0;  // share in the last period

    void run(int periods) {
        for (int i = 0; i < periods; ++i) {
            double wanted = 0;
            for (const Film& film : films)
                wanted += film.cost * share(governor.detail(film.source));
            late = wanted > cores ? 1 - cores / wanted : 0;
            std::vector<FilmLoad> loads;
            for (const Film& film : films) {
                const bool plays = governor.detail(film.source) != Detail::still;
                loads.push_back({.source = film.source,
                                 .cost = film.cost * share(governor.detail(film.source)),
                                 .salience = film.salience,
                                 .due = plays ? 30 : 0,
                                 .late = plays ? static_cast<int>(30 * late) : 0});
            }
            if (const auto change = governor.judge(loads)) changes.push_back(*change);
        }
    }

    Detail detail(SourceId source) const { return governor.detail(source); }
};

}  // namespace

TEST_CASE("nothing gives way while nothing is late") {
    Machine machine{.cores = 2, .films = {{1, 0.5, 0.5}, {2, 0.5, 0.5}}};
    machine.run(1000);
    CHECK(machine.changes.empty());
}

TEST_CASE("a few late pictures now and then change nothing") {
    Governor governor;
    for (int i = 0; i < 1000; ++i) {
        const FilmLoad film{.source = 1, .cost = 0.5, .salience = 1, .due = 30, .late = i % 3 == 0 ? 1 : 0};
        CHECK_FALSE(governor.judge({&film, 1}));
    }
}

TEST_CASE("the film that costs most for what is seen of it gives way first") {
    Machine dear{.cores = 1, .films = {{1, 0.3, 0.3}, {2, 0.6, 0.3}, {3, 0.3, 0.3}}};
    dear.run(1);
    REQUIRE(dear.changes.size() == 1);
    CHECK(dear.changes[0].source == 2);
    CHECK(dear.changes[0].detail == Detail::references);
    Machine hidden{.cores = 1, .films = {{1, 0.4, 0.5}, {2, 0.4, 0.1}, {3, 0.4, 0.4}}};
    hidden.run(1);
    REQUIRE(hidden.changes.size() == 1);
    CHECK(hidden.changes[0].source == 2);
}

TEST_CASE("films give way step by step until nothing is late, and no more than that") {
    Machine machine{.cores = 1, .films = {{1, 0.3, 0.4}, {2, 0.4, 0.2}, {3, 0.4, 0.2}, {4, 0.3, 0.2}}};
    int periods = 0;
    do {
        machine.run(1);
    } while (machine.late >= 0.05 && ++periods < 40);
    CHECK(periods < 20);
    CHECK(machine.detail(1) == Detail::all);
    CHECK(machine.detail(2) != Detail::still);
    CHECK(machine.detail(3) != Detail::still);
}

TEST_CASE("on a machine that is far too slow all stand still in the end, and judging goes on") {
    Machine machine{.cores = 0, .films = {{1, 0.5, 0.5}, {2, 0.5, 0.5}}};
    machine.run(60);
    CHECK(machine.detail(1) == Detail::still);
    CHECK(machine.detail(2) == Detail::still);
}

TEST_CASE("all films play whole again once the machine is free, the last to give way first") {
    Machine machine{.cores = 1, .films = {{1, 0.8, 0.5}, {2, 0.8, 0.4}, {3, 0.8, 0.1}}};
    machine.run(60);
    const SourceId last = machine.changes.back().source;
    const std::size_t before = machine.changes.size();
    machine.cores = 4;
    machine.run(2000);
    for (const SourceId source : {1, 2, 3})
        CHECK(machine.detail(source) == Detail::all);
    CHECK(machine.changes[before].source == last);
}

TEST_CASE("a load on the edge does not flicker: ever longer calm between two tries") {
    Machine machine{.cores = 0.95, .films = {{1, 0.5, 0.5}, {2, 0.55, 0.5}}};
    machine.run(200);
    const std::size_t early = machine.changes.size();
    machine.changes.clear();
    machine.run(3000);
    CHECK(early <= 14);
    CHECK(machine.changes.size() <= 14);  // 3000 periods at most every 512 + a few, two changes each
}

TEST_CASE("a film that has left the wall is forgotten, and the others come back") {
    Machine machine{.cores = 1, .films = {{1, 0.6, 0.5}, {2, 0.9, 0.5}}};
    machine.run(30);
    CHECK(machine.detail(2) != Detail::all);
    machine.films.pop_back();
    machine.run(600);
    CHECK(machine.detail(1) == Detail::all);
    CHECK(machine.detail(2) == Detail::all);
}
