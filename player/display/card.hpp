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

/// A graphics card, opened for showing. Who opens it first is its master and may set modes; root is not
/// needed for that, but the right to open the file.
class Card {
  public:
    /// @throws std::system_error, std::runtime_error naming the file: it cannot be opened, shows nothing, or
    /// another program has it
    Card(const std::filesystem::path& path, KmsApi api);

    int fd() const { return fd_.get(); }

    bool is_atomic() const { return is_atomic_; }

    bool has_modifiers() const { return has_modifiers_; }

    const std::filesystem::path& path() const { return path_; }

    /// The kernel's name of its driver: "i915".
    std::string driver() const;

    /// @param is_asked  whether a connector's panel is to be asked afresh, which takes a while, instead of
    /// what
    ///                  the kernel last heard from it
    /// @return nothing: the card was pulled out
    std::optional<CardState> state(const std::function<bool(std::uint32_t connector)>& is_asked) const;

    OutputProperties properties(const Output& output) const;

    /// The pictures that it is told of.
    FrameBuffers& frame_buffers() const { return *frame_buffers_; }

    /// From here on pictures are told to it through this opening. @pre there are none yet
    void set_keeper(UniqueFd keeper);

    /// The numbers of those that are on its outputs now.
    std::vector<std::uint32_t> shown() const;

    /// @param flags  DRM_MODE_ATOMIC_*, DRM_MODE_PAGE_FLIP_EVENT
    /// @param user   comes back with the event
    /// @return 0, or the errno why nothing has changed
    int commit(const AtomicRequest& request, std::uint32_t flags, std::uint64_t user) const;

    /// The same in the old way: shows another frame buffer of the same size.
    int flip(std::uint32_t crtc, std::uint32_t frame_buffer, std::uint64_t user) const;

    /// The pictures that the card has told of since the last call, by the number that their flips had.
    /// @pre there is something to read
    std::vector<std::uint64_t> read_flips() const;

    /// Whether it may be told what to show, and not another program.
    bool is_ours() const;

    /// Takes it back after another program has left it. False: that program still has it.
    bool take_over() const;

  private:
    std::filesystem::path path_;
    UniqueFd fd_;
    std::unique_ptr<FrameBuffers> frame_buffers_;
    bool is_atomic_ = false;
    bool has_modifiers_ = false;
};

/// The card at `path`; where that is empty, the first one with a panel, else the first with a connector.
/// @throws std::runtime_error saying what was found instead
Card open_card(const std::filesystem::path& path, KmsApi api);

/// Whether a card other than this one has a panel.
bool is_panel_elsewhere(const std::filesystem::path& path);

}  // namespace vitrine::player
