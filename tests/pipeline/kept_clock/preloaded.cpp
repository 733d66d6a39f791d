// A system clock that somebody keeps right, for tests alone: it stands before the C library's call. The boxes
// of a test are on one machine and share its clock, but a machine that runs tests has seldom a daemon that
// keeps it.

#include <sys/timex.h>

extern "C" int adjtimex(timex* asked) noexcept {
    *asked = {};
    return TIME_OK;
}
