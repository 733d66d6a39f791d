#pragma once

#include "player/display/card.hpp"
#include "player/display/egl.hpp"
#include "player/display/output_state.hpp"
#include "player/display/scanout.hpp"
#include "player/display/screen.hpp"

#include <gbm.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

namespace vitrine::player {

/// The card and the GL of all its screens.
struct KmsSurface {
    const Card& card;
    gbm_device* device = nullptr;  // egl draws to its buffers; nullptr: egl draws to memory
    Egl& egl;
    std::uint64_t flips = 0;  // number of the last requested flip
};

/// One panel of a card. Its owner asks for the card's answer to each frame with take_presented().
class KmsScreen final : public Screen {
  public:
    using Time = OutputState::Time;

    /// @param surface     outlives this
    /// @param in_the_way  obstacles of the output; the first frame removes them
    /// @throws std::runtime_error if the card has no room for its pictures
    KmsScreen(KmsSurface& surface, const Output& output, const Obstacles& in_the_way);

    const std::string& name() const override { return output_.name; }

    int width() const override { return output_.mode.hdisplay; }

    int height() const override { return output_.mode.vdisplay; }

    double refresh() const override { return refresh_rate(output_.mode); }

    std::uint64_t flips() const override { return flips_; }

    std::optional<CardPicture> shown() override;

    bool is_ready() const override { return !state_.is_waiting() && scanout_->has_free_buffer(); }

    bool wants_picture() const override { return state_.needs_mode() || is_lost_; }

    void turn_off() override;
    void begin_frame() override;
    void present(std::chrono::nanoseconds time) override;

    const Output& output() const { return output_; }

    /// The answer of the card to a picture.
    struct Presented {
        Outcome outcome = Outcome::nothing;
        std::string reason;  // the reason in words, if it failed
    };

    /// The answer to the last picture. Reported once.
    Presented take_presented();

    /// The time at which the panel was last known to be wanted lit.
    Time awaited_since() const { return awaited_since_; }

    /// Call when the card has reported this flip.
    void flipped(std::uint64_t flip);

    /// Call now and then. True: the card never reported the last flip.
    bool give_up_waiting();

    /// Sets the mode again with the next frame.
    void start_over();

  private:
    /// Gives the card a picture, with the mode or as a flip. @return  0, or an errno
    int request(const ScanoutBuffer& buffer, bool has_mode);
    void show(ScanoutBuffer buffer);

    KmsSurface& surface_;  // outlives this
    Output output_;
    Obstacles in_the_way_;
    OutputProperties properties_;
    OutputState state_;
    Presented presented_;
    bool is_off_ = false;
    bool is_lost_ = true;  // the last frame will not be seen
    Time awaited_since_ = std::chrono::steady_clock::now();
    std::uint64_t flip_ = 0;   // number of the last requested flip
    std::uint64_t flips_ = 0;  // flips that the card has reported
    std::unique_ptr<Scanout> scanout_;
    std::optional<ScanoutBuffer> on_screen_;
    std::optional<ScanoutBuffer> in_flight_;
};

}  // namespace vitrine::player
