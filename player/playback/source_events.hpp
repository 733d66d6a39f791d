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

/// News of a source: it is ready, or it has failed. Each is told once.
struct SourceEvent {
    SourceId source = 0;
    std::optional<std::string> failure;  // in plain words; none: the source is ready
    std::string unstored;  // the file of the media folder that it is read from; empty: the store
};

/// The upper bits of a source's number name its owner, the lower ones count the owner's sources.
constexpr int owner_shift = 48;

constexpr std::uint64_t owner_of(SourceId source) {
    return source >> owner_shift;
}

/// The number before an owner's first source.
constexpr SourceId sources_of(std::uint64_t owner) {
    return owner << owner_shift;
}

/// Who is told what became of one owner's sources.
struct SourceListener {
    std::uint64_t owner = 0;
    std::function<void(const SourceEvent&)> call;  // must not end the listener
};

/// Takes each event to the listener of its source's owner.
class SourceEvents {
  public:
    /// The listener is called for as long as it exists.
    void add(std::weak_ptr<const SourceListener> listener) { listeners_.push_back(std::move(listener)); }

    /// Calls the listeners, in the order of the events. @return the events that nobody listens to
    std::vector<SourceEvent> deliver(std::vector<SourceEvent> events);

  private:
    std::vector<std::weak_ptr<const SourceListener>> listeners_;
};

}  // namespace vitrine::player
