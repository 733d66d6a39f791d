#include "link/backoff.hpp"

#include <algorithm>

namespace vitrine::link {

Backoff::Duration Backoff::next(Duration connected) {
    if (connected >= held) pause_ = first;
    const Duration pause = pause_;
    pause_ = std::min(longest, 2 * pause_);
    return pause;
}

}  // namespace vitrine::link
