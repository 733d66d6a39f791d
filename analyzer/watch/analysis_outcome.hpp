#pragma once

#include "analyzer/child/child_process.hpp"
#include "analyzer/watch/file_facts.hpp"
#include "analyzer/watch/schedule.hpp"
#include "base/state/record.hpp"
#include "base/system/journal.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The meaning of a child's end for its file.
struct AnalysisOutcome {
    Answer answer = Answer::final;
    MediaRecord record;    // has path, bytes, mtime, state and reason
    bool ran_out = false;  // time or memory ran out: only the file's length is to blame
};

/// The record of a file without shots.
MediaRecord record_of(const std::string& path, const FileFacts& facts, MediaState state, std::string reason);

/// Reads a line that a child prints while its analysis goes on.
/// @return the new shots; nothing where the line is the whole record
/// @throws std::runtime_error where it is no record
std::optional<MediaRecord> growth_of(const std::string& line, const std::string& path,
                                     const FileFacts& facts);

/// The record of a film whose analysis ran out of time or memory: the shots that the catalogue has stay.
/// @param known  the record in the catalogue
/// @return nothing where that is of other content or has no shot
std::optional<MediaRecord> kept_record(std::optional<MediaRecord> known, const AnalysisOutcome& outcome);

/// Why a child failed, in the operator's words.
std::string reason_of(const ChildResult& result, const ChildLimits& limits);

/// Throws for no fault of the child: every end has its record.
AnalysisOutcome outcome_of(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                           const FileFacts& facts);

/// The fields that the journal gets beside a line about a file at fault.
std::vector<log::Field> journal_fields(const MediaRecord& record);

}  // namespace vitrine::analyzer
