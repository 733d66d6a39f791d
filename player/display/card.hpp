#pragma once

#include "player/display/atomic_request.hpp"
#include "player/display/kms_state.hpp"

#include "base/system/unique_fd.hpp"

#include <filesystem>

namespace vitrine {

/// How a card is told what to show.
enum class KmsApi {
    best,    // atomic requests where the driver has them
    legacy,  // the calls of before, also where there is better
};

/// A graphics card, opened for showing. Who opens it first is its master and may set modes.
class Card {
  public:
    /// @throws std::system_error naming the file; it cannot be opened, or shows nothing
    Card(const std::filesystem::path& path, KmsApi api);

    int fd() const { return fd_.get(); }

    bool is_atomic() const { return is_atomic_; }

    bool has_modifiers() const { return has_modifiers_; }

    const std::filesystem::path& path() const { return path_; }

    /// @param asks_panels  true: has each panel asked afresh, which takes a while; false: as last known
    CardState state(bool asks_panels) const;

    OutputProperties properties(const Output& output) const;

    /// @param flags  DRM_MODE_ATOMIC_*, DRM_MODE_PAGE_FLIP_EVENT
    /// @param user   handed to the flip event
    /// @return 0, or the errno why nothing has changed
    int commit(const AtomicRequest& request, std::uint32_t flags, void* user) const;

  private:
    std::filesystem::path path_;
    UniqueFd fd_;
    bool is_atomic_ = false;
    bool has_modifiers_ = false;
};

/// The card at `path`; where that is empty, the first one with a panel, else the first with a connector.
/// @throws std::runtime_error saying what was found instead
Card open_card(const std::filesystem::path& path, KmsApi api);

}  // namespace vitrine
