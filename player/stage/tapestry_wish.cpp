#include "player/stage/tapestry_wish.hpp"

#include "base/state/wanted_tapestry.hpp"
#include "base/system/log.hpp"

#include <system_error>
#include <utility>

namespace vitrine::player {

TapestryWish::TapestryWish(std::filesystem::path state, std::string path)
    : state_(std::move(state)), path_(std::move(path)) {
    try {
        want_tapestry(state_, path_);
    } catch (const std::system_error& error) {
        log::warning("the analyzer does not hear of a visitor's wish: {}", error.what());
    }
}

TapestryWish::~TapestryWish() {
    withdraw_wish(state_, path_);
}

}  // namespace vitrine::player
