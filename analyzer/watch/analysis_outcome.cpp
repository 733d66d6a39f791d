#include "analyzer/watch/analysis_outcome.hpp"

#include "base/state/record_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <stdexcept>

namespace vitrine::analyzer {

namespace {

constexpr std::size_t max_reason = 300;

std::string signal_in_words(int number) {
    switch (number) {
    case SIGSEGV:
    case SIGBUS:
        return "it used memory that is not its own";
    case SIGKILL:
        return "the machine ran out of memory";
    case SIGXCPU:
        return "it took too much processor time";
    default:
        return ::strsignal(number);
    }
}

/// The last line that is not blank: libraries warn first, the reason stands at the end.
std::string last_line(const std::string& text) {
    const std::size_t end = text.find_last_not_of(" \n\r\t");
    if (end == std::string::npos) return "";
    const std::size_t before = text.find_last_of('\n', end);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    return text.substr(begin, std::min(end - begin + 1, max_reason));
}

}  // namespace

std::string reason_of(const ChildResult& result, const ChildLimits& limits) {
    switch (result.end) {
    case ChildResult::End::late:
        return fmt::format("it took longer than {} s", limits.deadline.count() / 1000);
    case ChildResult::End::killed:
        return fmt::format("it crashed the reader: {}", signal_in_words(result.code));
    case ChildResult::End::talked_too_much:
        return "its analysis is too large";
    case ChildResult::End::stopped:
        return "its analysis was stopped";
    case ChildResult::End::exited:
        break;
    }
    const std::string line = last_line(result.complaint);
    return line.empty() ? fmt::format("the reader failed without a reason (exit status {})", result.code)
                        : line;
}

MediaRecord record_of(const std::string& path, const FileFacts& facts, MediaState state, std::string reason) {
    return {.path = path,
            .bytes = facts.bytes,
            .mtime_ns = facts.mtime_ns,
            .state = state,
            .reason = std::move(reason)};
}

std::optional<MediaRecord> growth_of(const std::string& line, const std::string& path,
                                     const FileFacts& facts) {
    MediaRecord part = record_from_json(line);
    if (part.is_complete) return std::nullopt;
    if (part.state != MediaState::ready) throw std::runtime_error("a part that is not ready");
    part.path = path;
    part.bytes = facts.bytes;
    part.mtime_ns = facts.mtime_ns;
    return part;
}

std::optional<MediaRecord> kept_record(std::optional<MediaRecord> known, const AnalysisOutcome& outcome) {
    const MediaRecord& judged = outcome.record;
    if (!outcome.ran_out || !known || known->shots.empty() || known->state != MediaState::ready ||
        known->bytes != judged.bytes || known->mtime_ns != judged.mtime_ns)
        return std::nullopt;
    known->is_complete = true;
    known->reason = fmt::format("not shown to its end: {}", judged.reason);
    known->duration = known->shots.back().end;
    return known;
}

AnalysisOutcome outcome_of(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                           const FileFacts& facts) {
    using End = ChildResult::End;
    if (result.end == End::late || result.end == End::killed)
        return {.answer = Answer::died,
                .record = record_of(path, facts, MediaState::quarantined, reason_of(result, limits)),
                .ran_out = result.end == End::late || result.code == SIGKILL || result.code == SIGXCPU};
    if (result.end != End::exited || result.code != 0)
        return {.answer = Answer::final,
                .record = record_of(path, facts, MediaState::failed, reason_of(result, limits))};
    try {
        MediaRecord record = record_from_json(result.output);
        if (record.state == MediaState::ready && record.shots.empty())
            throw std::runtime_error("ready without a shot");
        if (!record.is_complete) throw std::runtime_error("it ends before the film is over");
        record.path = path;
        record.bytes = facts.bytes;
        record.mtime_ns = facts.mtime_ns;
        return {.answer = record.state == MediaState::waiting ? Answer::waiting : Answer::final,
                .record = std::move(record)};
    } catch (const std::runtime_error& error) {  // loading one record
        return {.answer = Answer::final,
                .record = record_of(path, facts, MediaState::failed,
                                    fmt::format("the reader's answer is invalid: {}", error.what()))};
    }
}

std::vector<log::Field> journal_fields(const MediaRecord& record) {
    return {{"MESSAGE_ID", log::file_at_fault},
            {"VITRINE_FILE", record.path},
            {"VITRINE_STATE", std::string(name_of(record.state))}};
}

}  // namespace vitrine::analyzer
