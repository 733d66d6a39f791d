#include "analyzer/status/status_text.hpp"

#include "analyzer/status/plain_text.hpp"
#include "base/hints/hint_words.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace vitrine::analyzer {

std::string in_words(const StatusEntry& entry, const ClockText& clock) {
    using State = FileState::State;
    const FileState& file = entry.file;
    const std::string reason = plain_text(file.reason);
    switch (file.state) {
    case State::ready: {
        const std::string how = in_words(entry.hints);
        const std::string chosen = in_words(entry.keyframes);
        const std::string ready =
            (how.empty() ? "ready" : "ready, " + how) + (chosen.empty() ? "" : "; tapestry: " + chosen);
        const std::string wall = entry.on_wall ? ". " + plain_text(sentence(*entry.on_wall)) : "";
        return (reason.empty() ? ready : ready + "; " + reason) + wall;
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

StateCounts counts_of(const StatusReport& report) {
    StateCounts counts;
    for (const StatusEntry& entry : report.files)
        ++counts[entry.file.state];
    return counts;
}

std::string summary(const StateCounts& counts) {
    using State = FileState::State;
    constexpr std::array words{std::pair(State::ready, "ready"),
                               std::pair(State::copying, "copying"),
                               std::pair(State::analysing, "looked at"),
                               std::pair(State::waiting, "waiting"),
                               std::pair(State::unsupported, "unsupported"),
                               std::pair(State::failed, "not readable"),
                               std::pair(State::quarantined, "quarantined")};
    std::size_t all = 0;
    for (const auto& [state, count] : counts)
        all += count;
    std::string text = fmt::format("{} file{}", all, all == 1 ? "" : "s");
    const char* before = ": ";
    for (const auto& [state, word] : words) {
        const auto found = counts.find(state);
        if (found == counts.end() || found->second == 0) continue;
        text += fmt::format("{}{} {}", before, found->second, word);
        before = ", ";
    }
    return text;
}

std::string status_text(const StatusReport& report, const ClockText& clock) {
    std::string text = summary(counts_of(report)) + "\n";
    if (!report.is_player_running) text += fmt::format("{}\n", player_is_off);
    for (const std::string& remark : report.remarks)
        text += plain_text(remark) + "\n";
    text += "\n";
    for (const StatusEntry& entry : report.files)
        text += plain_text(entry.file.path) + ": " + in_words(entry, clock) + "\n";
    for (const std::string& path : report.inbox)
        text += fmt::format("{}: {}\n", plain_text(path), what_inbox_is);
    return text;
}

}  // namespace vitrine::analyzer
