#include "analyzer/watch/analyses.hpp"

#include "analyzer/status/plain_text.hpp"
#include "base/hints/notice.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace vitrine::analyzer {

namespace {

std::string time_in_words(std::chrono::seconds time) {
    return time < std::chrono::minutes(2) ? fmt::format("{} s", time.count())
                                          : fmt::format("{} min", time.count() / 60);
}

}  // namespace

Analyses::Analyses(EventLoop& loop, AnalysisCommand command, Events events)
    : loop_(loop), command_(std::move(command)), events_(std::move(events)) {}

void Analyses::start(const std::string& path, const FileFacts& facts,
                     const std::vector<std::string>& arguments) {
    std::vector<std::string> words = command_.words;
    words.insert(words.end(), arguments.begin(), arguments.end());
    ChildLimits limits = limits_for(command_.limits, command_.seconds_per_mebibyte, facts.bytes);
    if (notice_named(path)) limits.niceness = 0;  // it must be seen at once
    log::debug("analysing '{}'", path);
    const auto finish = [this, path, facts, limits](const ChildResult& result) {
        running_.erase(path);
        events_.ended(facts, outcome_of(result, limits, path, facts));
    };
    const auto hear = [this, path, facts](const std::string& line) { read_line(path, facts, line); };
    running_[path] = {.since = EventLoop::Clock::now(),
                      .process = std::make_unique<ChildProcess>(loop_, words, limits, finish, hear)};
}

/// The first shot of a film is on the wall while the rest of it is still analysed.
void Analyses::read_line(const std::string& path, const FileFacts& facts, const std::string& line) {
    std::optional<MediaRecord> part;
    try {
        part = growth_of(line, path, facts);
    } catch (const std::runtime_error& error) {  // loading one record
        return log::warning("new shots of '{}' are invalid, ignored: {}", path, error.what());
    }
    if (part) events_.grown(*part);
}

std::string Analyses::in_words() const {
    std::string text;
    for (const auto& [path, analysis] : running_) {
        const auto time = std::chrono::floor<std::chrono::seconds>(EventLoop::Clock::now() - analysis.since);
        text += fmt::format("{}'{}' for {}", text.empty() ? "looking at " : ", ", plain_text(path),
                            time_in_words(time));
    }
    return text;
}

}  // namespace vitrine::analyzer
