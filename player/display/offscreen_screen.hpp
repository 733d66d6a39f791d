#pragma once

#include "player/display/egl.hpp"
#include "player/display/film_writer.hpp"
#include "player/display/picture.hpp"
#include "player/display/screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace vitrine {

struct OffscreenOptions {
    int width = 1280;  // px
    int height = 720;
    std::optional<std::filesystem::path> film;  // every picture presented goes into this file
    double film_rate = 30;                      // pictures a second that the film is told to hold
};

/// A screen in memory, always ready and visible. What is presented can be read back, and filmed.
class OffscreenScreen final : public Screen {
  public:
    /// @throws std::runtime_error where EGL cannot draw without a device, or the film cannot be written
    explicit OffscreenScreen(const OffscreenOptions& options);
    OffscreenScreen(const OffscreenScreen&) = delete;
    OffscreenScreen& operator=(const OffscreenScreen&) = delete;
    OffscreenScreen(OffscreenScreen&&) = delete;
    OffscreenScreen& operator=(OffscreenScreen&&) = delete;
    ~OffscreenScreen() override;

    int width() const override { return width_; }

    int height() const override { return height_; }

    void begin_frame() override;
    void present(std::chrono::nanoseconds time) override;

    int event_fd() const override { return -1; }

    void dispatch() override {}

    bool is_ready() const override { return true; }

    bool is_visible() const override { return true; }

    std::vector<ScreenEvent> take_events() override { return {}; }

    std::string description() const override;

    /// What has been drawn last.
    Picture picture();

    /// Ends the film, so that the file is whole; nothing is filmed after. Nothing to do without a film.
    /// @throws std::runtime_error naming the film
    void finish_film();

  private:
    int width_;
    int height_;
    Egl egl_;
    unsigned frame_buffer_ = 0;
    unsigned colour_ = 0;
    std::vector<std::byte> rows_;  // as GL hands them out: from the bottom
    std::unique_ptr<FilmWriter> film_;
};

std::unique_ptr<OffscreenScreen> make_offscreen(const OffscreenOptions& options);

}  // namespace vitrine
