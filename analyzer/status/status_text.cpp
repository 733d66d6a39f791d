#include "analyzer/status/plain_text.hpp"
#include "analyzer/status/status_report.hpp"
#include "analyzer/status/status_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace vitrine {

std::string in_words(const StatusEntry& entry, const ClockText& clock) {
    using State = FileState::State;
    const FileState& file = entry.file;
    const std::string reason = plain_text(file.reason);
    switch (file.state) {
    case State::ready: {
        const std::string how = in_words(entry.hints);
        const std::string ready = how.empty() ? "ready" : "ready, " + how;
        return reason.empty() ? ready : ready + "; " + reason;
    }
    case State::copying:
        return "copying: it still changes";
    case State::analysing:
        return "being looked at";
    case State::waiting:
        return fmt::format("waiting since {}: {}", clock(file.since), reason);
    case State::unsupported:
        return fmt::format("unsupported because {}", reason);
    case State::failed:
        return fmt::format("not shown because {}", reason);
    case State::quarantined:
        return fmt::format("quarantined because {}", reason);
    }
    return {};
}

std::string summary(const StatusReport& report) {
    using State = FileState::State;
    constexpr std::array words{std::pair(State::ready, "ready"),
                               std::pair(State::copying, "copying"),
                               std::pair(State::analysing, "looked at"),
                               std::pair(State::waiting, "waiting"),
                               std::pair(State::unsupported, "unsupported"),
                               std::pair(State::failed, "not readable"),
                               std::pair(State::quarantined, "quarantined")};
    std::string text = fmt::format("{} file{}", report.files.size(), report.files.size() == 1 ? "" : "s");
    const char* before = ": ";
    for (const auto& [state, word] : words) {
        const auto count = std::ranges::count_if(
            report.files, [state = state](const StatusEntry& entry) { return entry.file.state == state; });
        if (count == 0) continue;
        text += fmt::format("{}{} {}", before, count, word);
        before = ", ";
    }
    return text;
}

std::string status_text(const StatusReport& report, const ClockText& clock) {
    std::string text = summary(report) + "\n";
    for (const std::string& remark : report.remarks)
        text += plain_text(remark) + "\n";
    text += "\n";
    for (const StatusEntry& entry : report.files)
        text += plain_text(entry.file.path) + ": " + in_words(entry, clock) + "\n";
    return text;
}

}  // namespace vitrine
