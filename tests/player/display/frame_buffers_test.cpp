#include "player/display/frame_buffers.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>

using namespace vitrine;
using namespace vitrine::player;

TEST_CASE("old pictures go that are not shown, in whatever order they are") {
    CHECK(without(std::vector<std::uint32_t>{7, 3, 9}, std::vector<std::uint32_t>{3}) ==
          std::vector<std::uint32_t>{7, 9});
    CHECK(without(std::vector<std::uint32_t>{7, 3}, {}) == std::vector<std::uint32_t>{7, 3});
    CHECK(without({}, std::vector<std::uint32_t>{3}).empty());
}

TEST_CASE("a descriptor that is no opening of the card is not taken for one") {
    const UniqueFd card(::open("/dev/null", O_RDWR | O_CLOEXEC));
    const auto keeper = [&](const char* path) {
        UniqueFd left(::open(path, O_RDWR | O_CLOEXEC));
        const int known = left.get();
        return std::pair(keeper_of(card.get(), std::move(left)), known);
    };
    const auto [kept, known] = keeper("/dev/null");
    CHECK(kept.get() == known);
    const auto [made, unknown] = keeper("/dev/zero");
    CHECK(made.is_open());
    CHECK(made.get() != unknown);
    CHECK(keeper_of(card.get(), UniqueFd()).is_open());
}

TEST_CASE("nothing outlives a card that has no keeper") {
    FrameBuffers buffers(-1, UniqueFd());
    CHECK_FALSE(buffers.keep());
    CHECK_FALSE(buffers.has_old());
}
