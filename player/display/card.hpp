#pragma once

#include "base/settings/choices.hpp"
#include "player/display/atomic_request.hpp"
#include "player/display/frame_buffers.hpp"
#include "player/display/kms_state.hpp"

#include "base/system/unique_fd.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace vitrine::player {

/// A graphics card (DRM device), opened for showing. The first program that opens it is its master and may
/// set modes; for this a program needs the right to open the file, not root.
class Card {
  public:
    /// @throws std::system_error, std::runtime_error naming the file: the card cannot be opened, has no
    /// output, or another program has it
    Card(const std::filesystem::path& path, KmsApi api);

    int fd() const { return fd_.get(); }

    bool is_atomic() const { return is_atomic_; }

    bool has_modifiers() const { return has_modifiers_; }

    const std::filesystem::path& path() const { return path_; }

    /// The kernel's name of its driver: "i915".
    std::string driver() const;

    /// @param is_asked  true: the connector's panel is queried again, which takes a while; false: the
    /// kernel's last answer is used
    /// @return none: the card was pulled out
    std::optional<CardState> state(const std::function<bool(std::uint32_t connector)>& is_asked) const;

    OutputProperties properties(const Output& output) const;

    /// The buffers that the card can show.
    FrameBuffers& frame_buffers() const { return *frame_buffers_; }

    /// Adds all further frame buffers through this opening. @pre there are none yet
    void set_keeper(UniqueFd keeper);

    /// The numbers of the frame buffers that its outputs show now.
    std::vector<std::uint32_t> shown() const;

    /// @param flags  DRM_MODE_ATOMIC_*, DRM_MODE_PAGE_FLIP_EVENT
    /// @param user   returned with the event
    /// @return 0, or the errno; then nothing has changed
    int commit(const AtomicRequest& request, std::uint32_t flags, std::uint64_t user) const;

    /// Shows another frame buffer of the same size, by the legacy call (drmModePageFlip). @return as commit()
    int flip(std::uint32_t crtc, std::uint32_t frame_buffer, std::uint64_t user) const;

    /// Reads the flips since the last call, as the `user` number of each.
    /// @pre the card has something to read
    std::vector<std::uint64_t> read_flips() const;

    /// True while this program is the card's master.
    bool is_ours() const;

    /// Becomes the card's master again after another program has left it. False: that program still has it.
    bool take_over() const;

  private:
    std::filesystem::path path_;
    UniqueFd fd_;
    std::unique_ptr<FrameBuffers> frame_buffers_;
    bool is_atomic_ = false;
    bool has_modifiers_ = false;
};

/// Opens the card at `path`; an empty path: the first card with a panel, else the first with a connector.
/// @throws std::runtime_error naming the cards that were tried
Card open_card(const std::filesystem::path& path, KmsApi api);

/// True if a card other than this one has a panel.
bool is_panel_elsewhere(const std::filesystem::path& path);

}  // namespace vitrine::player
