#include "analyzer/store/store_place.hpp"

#include "analyzer/store/clip_form.hpp"
#include "base/state/screen_note.hpp"

#include <system_error>

namespace vitrine::analyzer {

int clip_side(const Settings& settings) {
    if (settings.store.clip_size > 0) return settings.store.clip_size;
    return clip_side_for(settings.layout.slots, noted_screen_side(settings.state.directory));
}

bool has_room(const StorePlace& place) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(place.store, error);
    return !error && space.available > place.min_free_bytes;
}

}  // namespace vitrine::analyzer
