#include "player/stage/stage_files.hpp"

namespace vitrine::player {

void StageFiles::set(const RecordList& records, const ShowHints& hints) {
    all_ = records.in_folder(folder_);
    hints_ = hints;
    open(opened_);
}

void StageFiles::open(const std::string& folder) {
    opened_ = all_.in_folder(folder).is_empty() ? "" : folder;
}

}  // namespace vitrine::player
