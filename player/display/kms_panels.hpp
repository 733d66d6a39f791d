#pragma once

#include "player/display/display.hpp"
#include "player/display/kms_screen.hpp"
#include "player/display/kms_state.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace vitrine::player {

/// The panels of one card that are lit, each with its screen. A lit panel that shall stay lit is left as it
/// is, whatever happens to the others.
class KmsPanels {
  public:
    enum class Ask { none, unlit, all };  // the panels to query again, which takes a while

    /// @param surface, events  outlive this
    KmsPanels(KmsSurface& surface, ModeWishes modes, std::vector<DisplayEvent>& events);

    /// Lights new panels and drops those that are gone. False: the card was pulled out.
    bool look(Ask ask);

    /// True if look() is due before the next frame because a mode was refused. Reported once.
    bool take_due_look();

    std::span<const std::unique_ptr<KmsScreen>> lit() const { return lit_; }

    /// The screens in the order of the card's outputs. Lent until the next look().
    std::span<Screen* const> screens() const { return lent_; }

    /// Call when the panel has refused its mode: another mode is tried.
    void refuse(const KmsScreen& screen, const std::string& reason);

    /// Allows refused modes to be tried again.
    void forgive() { refusals_.clear(); }

    /// Sets the mode again with every panel's next picture.
    void start_over();

    /// A text such as "HDMI-A-1 1920x1080 at 60.00 Hz, ..."; empty: no panel is lit.
    std::string description() const;

  private:
    void follow(const std::vector<Output>& outputs, const CardState& state);
    void light(const Output& output, const CardState& state, const std::vector<Output>& all);

    KmsSurface& surface_;  // outlives this
    ModeWishes modes_;
    std::vector<DisplayEvent>& events_;  // outlives this
    Refusals refusals_;
    std::vector<std::unique_ptr<KmsScreen>> lit_;
    std::vector<Screen*> lent_;
    bool is_told_dark_ = false;
    bool is_look_due_ = false;
};

}  // namespace vitrine::player
