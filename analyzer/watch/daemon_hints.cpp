#include "analyzer/watch/daemon.hpp"

// What follows from what names and folders say: films that are to be heard have their sound in the store.

namespace vitrine::analyzer {

using namespace std::chrono_literals;

void Daemon::read_hints() {
    if (is_online()) {
        hint_files_.read(schedule_.paths_below(""));
        want_sounds();
    }
    status_.touch();
}

bool Daemon::is_to_be_heard(const std::string& path) const {
    return hints_of(path, hint_files_.hints()).sound.value_or(false);
}

/// A film of which that was said only after its analysis is analysed once more; the wall keeps its shots
/// meanwhile.
void Daemon::want_sounds() {
    if (!store_.is_on()) return;
    for (const std::string& path : schedule_.paths_below("")) {
        if (!is_to_be_heard(path)) {
            heard_.erase(path);
            continue;
        }
        if (heard_.contains(path)) continue;
        const std::optional<MediaRecord> record = stored(path);
        if (!record || record->state != MediaState::ready || !record->is_complete) continue;
        heard_.insert(path);
        if (!store_.lacks_sound(*record)) continue;
        growing_.known(*record);
        schedule_.analyse_again(path);
        wake_.arm(0s);
    }
}

}  // namespace vitrine::analyzer
