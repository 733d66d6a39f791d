#include "analyzer/watch/pace.hpp"

#include <algorithm>

namespace vitrine::analyzer {

std::chrono::milliseconds Pace::quiet_after(LookKind look) const {
    if (look == LookKind::closed) return std::min(quiet, closed_quiet);
    return look == LookKind::remote ? quiet * remote_quiets : quiet;
}

std::chrono::milliseconds Pace::retry_after(int tries) const {
    constexpr int max_doublings = 20;
    return std::min(first_retry * (1 << std::clamp(tries - 1, 0, max_doublings)),
                    std::max(max_retry, first_retry));
}

}  // namespace vitrine::analyzer
