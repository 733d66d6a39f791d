#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace vitrine::player {

class SourcePool;
class Stage;
class Stages;

/// Tells which files are really seen on a panel: those with a picture in the last frame of a stage, while
/// frames reach one of its screens. A stage without a screen is seen while other boxes show it.
class SeenFiles {
  public:
    static constexpr std::chrono::seconds patience{
        5};  // a screen that took no picture for longer is not seen

    /// Call several times a second. @param now  since the player's start
    /// @return  paths; each once, however often it is seen
    std::set<std::string> look(const Stages& stages, const SourcePool& sources, std::chrono::nanoseconds now);

  private:
    bool is_seen(const Stage& stage, std::chrono::nanoseconds now);

    struct Flips {
        std::uint64_t count = 0;             // of all screens of the stage
        std::chrono::nanoseconds changed{};  // the time of the last one
    };

    std::map<std::string, Flips> flips_;  // by the stages' folders
};

}  // namespace vitrine::player
