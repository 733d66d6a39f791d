#include "player/playback/source_events.hpp"

#include <algorithm>

namespace vitrine::player {

std::vector<SourceEvent> SourceEvents::deliver(std::vector<SourceEvent> events) {
    std::erase_if(listeners_, [](const auto& listener) { return listener.expired(); });
    std::erase_if(events, [this](const SourceEvent& event) {
        const auto found = std::ranges::find_if(listeners_, [&](const auto& listener) {
            return listener.lock()->owner == owner_of(event.source);
        });
        if (found == listeners_.end()) return false;
        found->lock()->call(event);
        return true;
    });
    return events;
}

}  // namespace vitrine::player
