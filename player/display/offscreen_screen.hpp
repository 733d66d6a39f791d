#pragma once

#include "player/display/egl.hpp"
#include "player/display/film_writer.hpp"
#include "player/display/memory_target.hpp"
#include "player/display/picture.hpp"
#include "player/display/screen.hpp"

#include <filesystem>
#include <memory>
#include <optional>

namespace vitrine::player {

struct OffscreenOptions {
    int width = 1280;  // px
    int height = 720;
    std::optional<std::filesystem::path> film;  // gets every presented frame
    double film_rate = 30;                      // frames a second that are written into the film's header
    std::string name = "offscreen-1";
};

/// A screen in memory, always ready. Its frames can be read back, and filmed.
class OffscreenScreen final : public Screen {
  public:
    /// @param egl  shared, because screens beside each other use one context; none: a context of its own
    /// @throws std::runtime_error if EGL cannot draw without a device, or the film cannot be written
    explicit OffscreenScreen(const OffscreenOptions& options, std::shared_ptr<Egl> egl = {});
    OffscreenScreen(const OffscreenScreen&) = delete;
    OffscreenScreen& operator=(const OffscreenScreen&) = delete;
    OffscreenScreen(OffscreenScreen&&) = delete;
    OffscreenScreen& operator=(OffscreenScreen&&) = delete;
    ~OffscreenScreen() override = default;

    const std::string& name() const override { return name_; }

    int width() const override { return drawn_.width(); }

    int height() const override { return drawn_.height(); }

    bool is_ready() const override { return true; }

    /// True: a film has every frame.
    bool wants_picture() const override { return film_ || !has_picture_; }

    void begin_frame() override;
    void present(std::chrono::nanoseconds time) override;

    std::uint64_t flips() const override { return flips_; }

    std::optional<CardPicture> shown() override;

    /// The last picture that was drawn.
    Picture picture() { return to_picture(drawn_.picture()); }

    /// Ends the film and completes the file; nothing is filmed afterwards. Does nothing without a film.
    /// @throws std::runtime_error naming the film
    void finish_film();

  private:
    std::string name_;
    std::shared_ptr<Egl> egl_;  // shared: see the constructor
    MemoryTarget drawn_;
    bool has_picture_ = false;
    std::unique_ptr<FilmWriter> film_;
    std::uint64_t flips_ = 0;
};

}  // namespace vitrine::player
