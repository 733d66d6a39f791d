#include "base/state/wanted_tapestry.hpp"

#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <string>

using namespace vitrine;

namespace {

std::string wanted_in(const TemporaryDirectory& state, std::chrono::minutes later = {}) {
    return wanted_tapestry(state.path, std::filesystem::file_time_type::clock::now() + later);
}

}  // namespace

TEST_CASE("a wish names a film, whatever bytes its name has, until it is withdrawn or old") {
    const TemporaryDirectory state;
    CHECK(wanted_in(state).empty());
    for (const std::string path : {"summer/lake.mp4", "\xff\xfe \"odd\".mp4"}) {
        want_tapestry(state.path, path);
        CHECK(wanted_in(state) == path);
        withdraw_wish(state.path, "another.mp4");
        CHECK(wanted_in(state) == path);
        CHECK(wanted_in(state, max_wish_age + std::chrono::minutes(1)).empty());
        withdraw_wish(state.path, path);
        CHECK(wanted_in(state).empty());
    }
}

TEST_CASE("what is no wish is none") {
    const TemporaryDirectory state;
    for (const char* text : {"", "film.mp4", "{}", R"({"version":2,"path":"a"})", R"({"version":1,"path":7})",
                             R"({"version":1,"path":"a","path_hex":"zz"})"}) {
        state.write(wanted_tapestry_file, text);
        CHECK(wanted_in(state).empty());
    }
    state.write(wanted_tapestry_file, R"({"version":1,"path":")" + std::string(1 << 20, 'a') + "\"}");
    CHECK(wanted_in(state).empty());
}
