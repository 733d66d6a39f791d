#pragma once

#include "player/scene/frame.hpp"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::player {

/// News of a source: it is ready, or it has failed. Each is reported once.
struct SourceEvent {
    SourceId source = 0;
    std::optional<std::string> failure;  // the reason in plain words; none: the source is ready
    std::string unstored;  // the file of the media folder that it is read from; empty: read from the store
};

/// The upper bits of a source's number are its owner's number; the lower bits count the owner's sources.
constexpr int owner_shift = 48;

constexpr std::uint64_t owner_of(SourceId source) {
    return source >> owner_shift;
}

/// The number just before an owner's first source.
constexpr SourceId sources_of(std::uint64_t owner) {
    return owner << owner_shift;
}

/// The function that gets the news of one owner's sources.
struct SourceListener {
    std::uint64_t owner = 0;
    std::function<void(const SourceEvent&)> call;  // must not destroy the listener
};

/// Passes each event to the listener of its source's owner.
class SourceEvents {
  public:
    /// Adds a listener. It is called for as long as it exists.
    void add(std::weak_ptr<const SourceListener> listener) { listeners_.push_back(std::move(listener)); }

    /// Calls the listeners, in the order of the events. @return the events without a listener
    std::vector<SourceEvent> deliver(std::vector<SourceEvent> events);

  private:
    std::vector<std::weak_ptr<const SourceListener>> listeners_;
};

}  // namespace vitrine::player
