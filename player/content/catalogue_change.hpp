#pragma once

#include "player/scene/files/show_files.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// Paths of the ready files that a change of the catalogue concerns.
struct CatalogueChange {
    std::vector<std::string> added;
    std::vector<std::string> grown;  // the same content with further shots: a shot that plays goes on
    std::vector<std::string> replaced;
    std::vector<std::string> gone;
    bool has_others = false;  // files that are not ready, before or now, have changed

    bool is_empty() const {
        return added.empty() && grown.empty() && replaced.empty() && gone.empty() && !has_others;
    }
};

/// True: the analyzer has found shots in the file.
bool is_ready(const MediaRecord& record);

/// Compares two lists of records that are ordered by path.
CatalogueChange change_between(const RecordList& before, const RecordList& after);

}  // namespace vitrine::player
