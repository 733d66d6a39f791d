#pragma once

#include "base/state/catalogue.hpp"
#include "player/layout/layout.hpp"

#include <string>
#include <vector>

namespace vitrine::player {

/// The items of all shots of a catalogue's ready media.
inline std::vector<LayoutItem> items_of_catalogue(const std::string& directory) {
    std::vector<LayoutItem> items;
    for (const MediaRecord& record : Catalogue(directory).load())
        if (record.state == MediaState::ready)
            for (const Shot& shot : record.shots)
                items.push_back(layout_item(record, shot));
    return items;
}

}  // namespace vitrine::player
