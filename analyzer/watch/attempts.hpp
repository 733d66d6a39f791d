#pragma once

#include "analyzer/watch/pace.hpp"

#include <chrono>
#include <optional>

namespace vitrine::analyzer {

/// The end of an analysis.
enum class Answer {
    final,      // ready or unsupported: stands until the file changes
    waiting,    // the file is incomplete: it is tried again, some times
    damaged,    // failed, by the bytes that were read; a share may have given wrong ones
    postponed,  // not the file is at fault: it is tried again until that is over
    died,       // the file brought its reader down
};

/// The fate of an answer.
enum class Verdict {
    store,       // store the record as it is
    give_up,     // store it as failed: it has waited long enough
    quarantine,  // store it as quarantined
    retry,       // store nothing yet, try again
    postpone,    // try again; until then the file waits, unless a record of this content holds
    discard,     // the file changed or went in the meantime
};

/// The analyses of one content so far, and what follows from the next one. Pure.
class Attempts {
  public:
    /// The consequence of an answer.
    struct Next {
        Verdict verdict = Verdict::store;
        std::optional<std::chrono::milliseconds> retry_after;  // nothing: the analysis is done
    };

    /// The circumstances of an answer.
    struct Circumstances {
        bool is_remote = false;  // the file is on a share
        bool have_others_died =
            false;  // other files brought their readers down lately: the machine is suspected
    };

    Next note_answer(Answer answer, const Circumstances& circumstances, const Pace& pace);

    /// True where the last answer asked for another try, of a file that waits.
    bool is_waiting() const { return waits_ > 0 || postponements_ > 0; }

    /// True where no retry follows if the file is found incomplete once more.
    bool is_last(const Pace& pace) const { return waits_ >= pace.retries; }

  private:
    Next postpone(const Pace& pace);

    int deaths_ = 0;           // children that this content has killed
    int waits_ = 0;            // answers that it is incomplete
    int postponements_ = 0;    // answers in a row that something else is at fault
    bool is_damaged_ = false;  // it was found damaged once
};

}  // namespace vitrine::analyzer
