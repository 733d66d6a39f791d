#pragma once

#include "player/display/card.hpp"
#include "player/display/console.hpp"
#include "player/display/egl.hpp"
#include "player/display/panel_watch.hpp"
#include "player/display/scanout.hpp"
#include "player/display/screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace vitrine {

struct KmsOptions {
    std::filesystem::path card;  // empty: the first with a panel
    OutputWish wish;
    KmsApi api = KmsApi::best;
};

/// A panel, shown on without a desktop. No panel, a panel that goes, comes back or changes its size, and
/// another program that takes the card over, are states and not errors: is_visible() is false meanwhile,
/// and width() and height() change when a panel of another size appears.
class KmsScreen final : public Screen {
  public:
    /// @throws std::runtime_error, std::system_error: no card to show on, or it cannot be drawn on
    explicit KmsScreen(const KmsOptions& options);
    KmsScreen(const KmsScreen&) = delete;
    KmsScreen& operator=(const KmsScreen&) = delete;
    KmsScreen(KmsScreen&&) = delete;
    KmsScreen& operator=(KmsScreen&&) = delete;
    ~KmsScreen() override;

    int width() const override { return width_; }

    int height() const override { return height_; }

    void begin_frame() override;
    void present(std::chrono::nanoseconds time) override;

    int event_fd() const override { return watch_.fd(); }

    void dispatch() override;

    bool is_ready() const override { return !in_flight_ && scanout_ && scanout_->has_free_buffer(); }

    bool is_visible() const override { return output_ && is_master_; }

    std::vector<ScreenEvent> take_events() override { return std::exchange(events_, {}); }

    std::string description() const override;

  private:
    struct SavedCrtc;

    static void flipped(int card, unsigned sequence, unsigned seconds, unsigned micros, void* screen);
    void look_for_panel(bool asks_panels);
    void light(const Output& output);
    void go_dark();
    void on_tick();
    int set_mode(const ScanoutBuffer& buffer);
    int flip(const ScanoutBuffer& buffer);
    void take_result(int error, const char* what);
    void tell(std::string text, bool is_trouble = false);
    void set_master(bool is_master);

    Card card_;
    OutputWish wish_;
    QuietConsole console_;
    Handle<gbm_device, &gbm_device_destroy> device_;
    Egl egl_;
    PanelWatch watch_;
    int width_ = 1920;  // px, until there is a panel
    int height_ = 1080;
    bool is_master_ = true;
    bool needs_mode_ = true;  // the next picture comes with a mode, all others flip
    bool has_shown_ = false;  // a mode was set once: what fails later is a state
    int ticks_in_flight_ = 0;
    std::vector<ScreenEvent> events_;
    std::chrono::steady_clock::time_point found_;  // when the panel was
    std::optional<Output> output_;
    OutputProperties properties_;
    std::unique_ptr<SavedCrtc> before_;  // what the panel showed before us
    std::optional<Scanout> scanout_;
    std::optional<ScanoutBuffer> on_screen_;
    std::optional<ScanoutBuffer> in_flight_;
};

/// A screen on a panel.
std::unique_ptr<KmsScreen> make_kms(const KmsOptions& options);

}  // namespace vitrine
