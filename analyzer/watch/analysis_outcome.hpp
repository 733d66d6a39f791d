#pragma once

#include "analyzer/watch/child_process.hpp"
#include "analyzer/watch/file_facts.hpp"
#include "analyzer/watch/schedule.hpp"
#include "base/state/record.hpp"
#include "base/system/journal.hpp"

#include <optional>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// What a child's end means for its file.
struct Outcome {
    Answer answer = Answer::final;
    MediaRecord record;    // of that path and content, with state and reason
    bool ran_out = false;  // of time or memory: the file is not to blame for more than its length
};

/// The record of a file that was not analysed.
MediaRecord record_of(const std::string& path, const FileFacts& facts, MediaState state, std::string reason);

/// What a line of a child's output says of a film whose analysis goes on; nothing where it is the whole
/// record.
/// @throws std::runtime_error where it is no record
std::optional<MediaRecord> growth_of(const std::string& line, const std::string& path,
                                     const FileFacts& facts);

/// The record of a film whose analysis ran out of time or memory: what the catalogue has of it stays. Nothing
/// where that is of other content or has no shot.
std::optional<MediaRecord> kept(std::optional<MediaRecord> known, const Outcome& outcome);

/// Why a child did not do what it was for, in the operator's words.
std::string reason_of(const ChildResult& result, const ChildLimits& limits);

/// Never throws for what the child did or said: every end has its record.
Outcome outcome_of(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                   const FileFacts& facts);

/// What the journal is told beside the words of a line about a file at fault.
std::vector<log::Field> journal_fields(const MediaRecord& record);

}  // namespace vitrine::analyzer
