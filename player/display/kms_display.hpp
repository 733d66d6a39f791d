#pragma once

#include "player/display/card.hpp"
#include "player/display/display.hpp"
#include "player/display/egl.hpp"
#include "player/display/kms_panels.hpp"
#include "player/display/kms_screen.hpp"
#include "player/display/panel_watch.hpp"

#include "base/system/handle.hpp"

#include <gbm.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace vitrine::player {

struct KmsOptions {
    std::filesystem::path card;  // empty: the first card with a panel
    ModeWishes modes;
    KmsApi api = KmsApi::best;
    SoftwareGl* software = nullptr;  // kept from display to display, outlives them; none: made here
};

/// Shows on the panels of a graphics card, without a desktop. Some events are states and not errors: there is
/// no panel, panels come, go or change, another program takes the card over.
class KmsDisplay final : public Display {
  public:
    /// @throws std::runtime_error, std::system_error: no card to show on, or it cannot be drawn on
    /// @param left  the keeper from an earlier run (frame_buffers.hpp); taken once a card is open
    KmsDisplay(const KmsOptions& options, UniqueFd& left);
    KmsDisplay(const KmsDisplay&) = delete;
    KmsDisplay& operator=(const KmsDisplay&) = delete;
    KmsDisplay(KmsDisplay&&) = delete;
    KmsDisplay& operator=(KmsDisplay&&) = delete;
    ~KmsDisplay() override;

    /// The name of the keeper at systemd.
    static constexpr const char* keeper_name = "card";

    std::span<Screen* const> screens() override;

    int event_fd() const override { return watch_.fd(); }

    void dispatch() override;

    bool is_gone() const override { return is_gone_; }

    bool is_away() const override { return is_left_ || !is_master_; }

    bool has_old_picture() const override { return card_.frame_buffers().has_old(); }

    bool keep_picture() override { return is_kept_ = card_.frame_buffers().keep(); }

    void leave() override;
    void take_back() override;

    std::vector<DisplayEvent> take_events() override { return std::exchange(events_, {}); }

    const std::shared_ptr<Egl>& gl() const override { return egl_; }

    bool has_lasting_gl() const override { return device_ == nullptr; }

    std::string description() const override;

  private:
    void on_tick();
    void look_for_panels(KmsPanels::Ask ask);
    void take_outcomes();
    void set_master(bool is_master);
    void lose_card(const std::string& why);

    bool is_any_card_;                                // the settings named no card
    Card card_;                                       // with the keeper
    Handle<gbm_device, &gbm_device_destroy> device_;  // none: GL draws in software, to memory
    std::shared_ptr<Egl> egl_;                        // shared with SoftwareGl if it draws in software
    KmsSurface surface_;
    PanelWatch watch_;
    std::vector<DisplayEvent> events_;
    KmsPanels panels_;
    bool is_master_ = true;
    bool is_left_ = false;
    bool is_gone_ = false;
    bool is_kept_ = false;  // the picture stays after this ends
    int ticks_ = 0;
};

/// Makes an opener of displays on a graphics card: "kms", "kms:/dev/dri/card1".
/// @param argument  the text after the colon of `output.screen`
/// @return none: the argument is not understood
std::unique_ptr<DisplayOpener> make_kms_opener(std::optional<std::string_view> argument,
                                               const DisplayRequest& request);

}  // namespace vitrine::player
