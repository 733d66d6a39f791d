#include "analyzer/tapestry/weave/weave_plan.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <system_error>

// A line with the film's content, the choice and the folder, then a line a level.

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr const char* plan_name = "plan";
constexpr std::size_t max_plan_levels = 32;
constexpr const char* no_choice = "-";

std::optional<Keyframes> level_in(const std::string& line, std::size_t candidates) {
    std::istringstream words(line);
    Keyframes level;
    for (int frame = 0; words >> frame;) {
        const bool is_next = level.empty() ? frame >= 0 : frame > level.back();
        if (!is_next || static_cast<std::size_t>(frame) >= candidates) return std::nullopt;
        level.push_back(frame);
    }
    if (!words.eof() || level.empty()) return std::nullopt;
    return level;
}

/// The first line of a plan for this content, without the folder at its end.
std::string first_words(const PlanSubject& subject) {
    return fmt::format("vitrine-plan 2 {} {} {} ", subject.content.bytes, subject.content.mtime_ns,
                       subject.choice.empty() ? no_choice : subject.choice);
}

}  // namespace

std::optional<WeavePlan> read_plan(const fs::path& directory, const PlanSubject& subject,
                                   std::size_t candidates) {
    std::error_code error;
    if (!fs::exists(directory / plan_name, error)) return std::nullopt;
    std::istringstream lines(read_file(directory / plan_name));
    std::string line;
    const std::string head = first_words(subject);
    if (!std::getline(lines, line) || !line.starts_with(head)) return std::nullopt;
    WeavePlan plan{.folder = line.substr(head.size()), .levels = {}};
    if (!plan.folder.starts_with("tiles-") || plan.folder.find_first_of("/.") != std::string::npos)
        return std::nullopt;
    while (std::getline(lines, line)) {
        std::optional<Keyframes> level = level_in(line, candidates);
        const bool is_nested =
            level && (plan.levels.empty() || std::ranges::includes(*level, plan.levels.back()));
        if (!is_nested || plan.levels.size() == max_plan_levels) return std::nullopt;
        plan.levels.push_back(std::move(*level));
    }
    if (plan.levels.empty()) return std::nullopt;
    return plan;
}

void write_plan(const fs::path& directory, const PlanSubject& subject, const WeavePlan& plan) {
    std::string text = first_words(subject) + plan.folder + "\n";
    for (const Keyframes& level : plan.levels)
        text += fmt::format("{}\n", fmt::join(level, " "));
    replace_file(directory / plan_name, text);
}

void remove_plan(const fs::path& directory) {
    std::error_code missing;
    fs::remove(directory / plan_name, missing);
}

}  // namespace vitrine::analyzer
