#include "analyzer/watch/attempts.hpp"

namespace vitrine::analyzer {

Attempts::Next Attempts::postpone(const Pace& pace) {
    ++postponements_;
    return {.verdict = Verdict::postpone, .retry_after = pace.retry_after(postponements_)};
}

/// One bad minute of a share or of the machine never leads to a final verdict.
Attempts::Next Attempts::note_answer(Answer answer, const Circumstances& circumstances, const Pace& pace) {
    using std::chrono::milliseconds;
    switch (answer) {
    case Answer::postponed:
        return postpone(pace);
    case Answer::died:
        if (++deaths_ < pace.deaths) return {.verdict = Verdict::retry, .retry_after = milliseconds(0)};
        if (circumstances.have_others_died) return postpone(pace);
        *this = {};  // after the quarantine the content has two tries again
        return {.verdict = Verdict::quarantine, .retry_after = {}};
    case Answer::waiting:
        postponements_ = 0;
        if (is_last(pace)) return {.verdict = Verdict::give_up, .retry_after = {}};
        return {.verdict = Verdict::store, .retry_after = pace.retry_after(++waits_)};
    case Answer::damaged:
        postponements_ = 0;
        if (circumstances.is_remote && !is_damaged_) {
            is_damaged_ = true;
            return {.verdict = Verdict::retry, .retry_after = pace.first_retry};
        }
        break;
    case Answer::final:
        break;
    }
    *this = {};
    return {};
}

}  // namespace vitrine::analyzer
