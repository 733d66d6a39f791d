#include "player/stage/newer_index.hpp"

#include "base/system/log.hpp"

#include <sys/stat.h>

#include <exception>

namespace vitrine::player {

namespace {

constexpr auto look_interval = std::chrono::milliseconds(100);
constexpr std::int64_t ns_a_second = 1'000'000'000;

}  // namespace

std::optional<Tapestry> NewerIndex::take(std::chrono::nanoseconds now) {
    if (looked_ && now - *looked_ < look_interval) return std::nullopt;
    looked_ = now;
    const Version version = present();
    if (version == known_ || version == Version{0, 0}) return std::nullopt;
    known_ = version;
    try {
        Tapestry tapestry = read_tapestry(directory_);
        if (!tapestry.levels.empty()) return tapestry;
    } catch (const std::exception& error) {  // loading one record: it went just now, or nobody can read it
        log::debug("{}", error.what());
    }
    return std::nullopt;
}

NewerIndex::Version NewerIndex::present() const {
    struct stat status {};

    if (::stat((directory_ / "index.json").c_str(), &status) < 0) return {0, 0};
    return {status.st_ino, status.st_mtim.tv_sec * ns_a_second + status.st_mtim.tv_nsec};
}

}  // namespace vitrine::player
