#include "analyzer/watch/analysis_slots.hpp"

namespace vitrine::analyzer {

bool AnalysisSlots::note_death(const std::string& path, Time now, std::chrono::milliseconds memory) {
    std::erase_if(died_, [&](const auto& death) { return now - death.second >= memory; });
    died_[path] = now;
    return died_.size() > 1;
}

}  // namespace vitrine::analyzer
