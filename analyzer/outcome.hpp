#pragma once

#include "analyzer/child_process.hpp"
#include "analyzer/file_facts.hpp"
#include "analyzer/schedule.hpp"
#include "base/catalogue/record.hpp"

#include <string>

namespace vitrine {

/// What a child's end means for its file.
struct Outcome {
    Answer answer = Answer::final;
    MediaRecord record;  // of that path and content, with state and reason
};

/// The record of a file that was not analysed.
MediaRecord record_of(const std::string& path, const FileFacts& facts, MediaState state, std::string reason);

/// Never throws for what the child did or said: every end has its record.
Outcome outcome_of(const ChildResult& result, const ChildLimits& limits, const std::string& path,
                   const FileFacts& facts);

}  // namespace vitrine
