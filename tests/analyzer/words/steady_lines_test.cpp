#include "analyzer/words/steady_lines.hpp"

#include <doctest/doctest.h>

namespace vitrine::analyzer {

TEST_CASE("a line counts where two searches have found it, at its place or moved by the drift") {
    const Box line{{100, 70}, {150, 78}};
    const Vec2 drift{10, 0};
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}}, {}).size() == 1);
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}, {2, {}}}, {}).empty());
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}, {2, {}}, {4, {line}}}, {}).empty());
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}, {2, {line}}}, {}).size() == 2);
    // Signs on a pan move along.
    const Box later = moved(line, drift * 2);
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}, {2, {later}}}, drift).size() == 2);
    const Box far = moved(line, Vec2{60, 0});
    CHECK(steady_lines(std::vector<LineSearch>{{0, {line}}, {2, {far}}}, {}).empty());
    const auto on_pan = steady_lines(std::vector<LineSearch>{{0, {line}}, {6, {far}}}, drift);
    REQUIRE(on_pan.size() == 2);
    CHECK(on_pan[0] == line);
    CHECK(on_pan[1] == line);  // at its place at the begin
}

TEST_CASE("a line that stands still over a pan is a caption") {
    const Box line{{100, 70}, {150, 78}};
    const std::vector<LineSearch> still{{0, {line}}, {2, {line}}};
    CHECK(has_caption(still, {10, 0}));
    CHECK_FALSE(has_caption(still, {1, 0}));
    CHECK_FALSE(has_caption(still, {}));
    CHECK_FALSE(has_caption(std::vector<LineSearch>{{0, {line}}, {2, {moved(line, {60, 0})}}}, {30, 0}));
    CHECK_FALSE(has_caption(std::vector<LineSearch>{{0, {line}}}, {10, 0}));
}

}  // namespace vitrine::analyzer
