#include "analyzer/child/progress_rule.hpp"

namespace vitrine::analyzer {

ProgressRule::Verdict ProgressRule::judge(Duration passed, Duration processor, Duration kept) {
    constexpr int next_to_nothing = 200;  // one part of so many of the time that passed
    const bool is_computing = (processor + kept - at_look_) * next_to_nothing > passed;
    at_look_ = processor + kept;
    if (has_progressed_) at_progress_ = processor;
    idle_ = has_progressed_ || is_computing ? Duration(0) : idle_ + passed;
    has_progressed_ = false;
    if (processor - at_progress_ >= patience_.computing) return Verdict::computing;
    return idle_ >= patience_.idling ? Verdict::idling : Verdict::fine;
}

}  // namespace vitrine::analyzer
