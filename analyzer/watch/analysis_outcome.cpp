#include "analyzer/watch/analysis_outcome.hpp"

#include "analyzer/watch/fault_record.hpp"
#include "base/state/record_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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

/// True for a signal that a process gets for what it does itself. All others come from outside: from the
/// kernel that is out of memory, from systemd, from a person.
bool is_own_crash(int signal) {
    constexpr std::array own{SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGTRAP, SIGSYS, SIGXCPU};
    return std::ranges::find(own, signal) != own.end();
}

/// The owner of the fault where a child ended without an answer.
FaultOwner owner_of(const ChildResult& result) {
    switch (result.end) {
    case ChildResult::End::idle:
        return FaultOwner::transport;
    case ChildResult::End::killed:
        return is_own_crash(result.code) ? FaultOwner::file : FaultOwner::machine;
    case ChildResult::End::exited:
        return result.code == ChildProcess::exit_not_started ? FaultOwner::machine : FaultOwner::program;
    case ChildResult::End::late:
    case ChildResult::End::talked_too_much:
    case ChildResult::End::stopped:
        break;
    }
    return FaultOwner::file;
}

/// The answer that a whole record is.
Answer answer_of(const MediaRecord& record) {
    if (record.fault.owner != FaultOwner::file) return Answer::postponed;
    if (record.state == MediaState::waiting) return Answer::waiting;
    return record.state == MediaState::failed ? Answer::damaged : Answer::final;
}

AnalysisOutcome postponed(const std::string& path, const FileFacts& facts, FaultOwner owner,
                          std::string reason) {
    AnalysisOutcome outcome{.answer = Answer::postponed,
                            .record = record_of(path, facts, MediaState::waiting, std::move(reason))};
    outcome.record.fault.owner = owner;
    return outcome;
}

/// A child that brought no record.
AnalysisOutcome failed_child(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                             const FileFacts& facts) {
    using End = ChildResult::End;
    std::string reason = reason_of(result, limits);
    const FaultOwner owner = owner_of(result);
    if (owner != FaultOwner::file) return postponed(path, facts, owner, std::move(reason));
    if (result.end == End::late || result.end == End::killed)
        return {.answer = Answer::died,
                .record = record_of(path, facts, MediaState::quarantined, std::move(reason)),
                .ran_out = result.end == End::late || result.code == SIGXCPU};
    return {.answer = Answer::damaged,
            .record = record_of(path, facts, MediaState::failed, std::move(reason))};
}

}  // namespace

std::string reason_of(const ChildResult& result, const ChildLimits& limits) {
    switch (result.end) {
    case ChildResult::End::late:
        return fmt::format("its reader computed for {} s and came to nothing",
                           limits.patience.computing.count() / 1000);
    case ChildResult::End::idle:
        return "the file's disk or share does not answer";
    case ChildResult::End::killed:
        if (!is_own_crash(result.code))
            return "its reader was ended from outside, or the machine lacks memory";
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
            .inode = facts.inode,
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
    part.inode = facts.inode;
    return part;
}

std::optional<MediaRecord> kept_record(std::optional<MediaRecord> known, const AnalysisOutcome& outcome) {
    const MediaRecord& judged = outcome.record;
    if (!outcome.ran_out || !known || known->shots.empty() || known->state != MediaState::ready ||
        !is_same_content(*known, judged))
        return std::nullopt;
    known->is_complete = true;
    known->reason = fmt::format("not shown to its end: {}", judged.reason);
    known->duration = known->shots.back().end;
    for (Shot& shot : known->shots)
        shot.analysis = Shot::current_analysis;  // more is not to be had
    return known;
}

AnalysisOutcome outcome_of(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                           const FileFacts& facts) {
    if (result.end != ChildResult::End::exited || result.code != 0)
        return failed_child(result, limits, path, facts);
    try {
        MediaRecord record = record_from_json(result.output);
        if (record.state == MediaState::ready && record.shots.empty())
            throw std::runtime_error("ready without a shot");
        if (!record.is_complete) throw std::runtime_error("it ends before the film is over");
        record.path = path;
        record.bytes = facts.bytes;
        record.mtime_ns = facts.mtime_ns;
        record.inode = facts.inode;
        const Answer answer = answer_of(record);
        return {.answer = answer, .record = std::move(record)};
    } catch (const std::runtime_error& error) {  // loading one record
        return postponed(path, facts, FaultOwner::program,
                         fmt::format("the reader's answer is invalid: {}", error.what()));
    }
}

std::vector<log::Field> journal_fields(const MediaRecord& record) {
    return {{"MESSAGE_ID", log::file_at_fault},
            {"VITRINE_FILE", record.path},
            {"VITRINE_STATE", std::string(name_of(record.state))}};
}

}  // namespace vitrine::analyzer
