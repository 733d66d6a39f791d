#include "base/system/kept_clock.hpp"

#include <sys/timex.h>

namespace vitrine {

bool is_clock_kept_right() {
    timex question{};  // it changes nothing
    const int state = ::adjtimex(&question);
    return state >= 0 && state != TIME_ERROR && (question.status & STA_UNSYNC) == 0;
}

}  // namespace vitrine
