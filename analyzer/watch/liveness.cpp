#include "analyzer/watch/liveness.hpp"

#include <algorithm>

namespace vitrine::analyzer {

std::optional<std::string> Pulse::missed(Time now) const {
    const auto earliest =
        std::ranges::min_element(expected_, {}, [](const auto& expected) { return expected.second; });
    if (earliest == expected_.end() || now <= earliest->second + patience) return std::nullopt;
    return earliest->first;
}

}  // namespace vitrine::analyzer
