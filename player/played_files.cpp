#include "player/played_files.hpp"

#include "player/playback/source_pool.hpp"
#include "player/stage/stages.hpp"

namespace vitrine::player {

void PlayedFiles::look(const Stages& stages, const SourcePool& sources, std::chrono::nanoseconds now) {
    if (now < next_look_) return;
    next_look_ = now + interval;
    PlayLedger::Day day;
    if (const auto time = calendar_.now()) day = std::chrono::floor<std::chrono::days>(*time);
    ledger_.look(seen_.look(stages, sources, now), now, day);
}

}  // namespace vitrine::player
