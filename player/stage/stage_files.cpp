#include "player/stage/stage_files.hpp"

namespace vitrine::player {

void StageFiles::set(const RecordList& records, const ShowHints& hints) {
    all_ = records.in_folder(folder_);
    hints_ = hints;
}

}  // namespace vitrine::player
