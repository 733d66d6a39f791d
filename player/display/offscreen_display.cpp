#include "player/display/offscreen_display.hpp"

#include "player/display/gl_device.hpp"

#include <fmt/format.h>

#include <utility>

namespace vitrine::player {

namespace {

class OffscreenOpener final : public DisplayOpener {
  public:
    OffscreenOpener(OffscreenChoice choice, const DisplayRequest& request)
        : DisplayOpener({.has_terminal = false,
                         .is_awaited = false,
                         .can_wait_for_pictures = true,
                         .expected = choice.screens.front()}),
          choice_(std::move(choice)),
          request_(request) {}

    std::unique_ptr<Display> open() override {
        return std::make_unique<OffscreenDisplay>(choice_, request_.recording,
                                                  static_cast<double>(request_.output.frame_rate));
    }

  private:
    OffscreenChoice choice_;
    DisplayRequest request_;
};

}  // namespace

std::unique_ptr<DisplayOpener> make_offscreen_opener(std::optional<std::string_view> argument,
                                                     const DisplayRequest& request) {
    std::optional<std::vector<ScreenSize>> sizes = screen_sizes_named(argument.value_or(""));
    if (!sizes) return nullptr;
    return std::make_unique<OffscreenOpener>(OffscreenChoice{*std::move(sizes)}, request);
}

std::filesystem::path numbered(const std::filesystem::path& path, std::size_t index) {
    if (index == 0) return path;
    std::filesystem::path made = path;
    return made.replace_filename(
        fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string()));
}

OffscreenDisplay::OffscreenDisplay(const OffscreenChoice& choice, Recording recording, double rate)
    : recording_(std::move(recording)), egl_(std::make_shared<Egl>(Egl::surfaceless())) {
    for (std::size_t i = 0; i < choice.screens.size(); ++i) {
        OffscreenOptions options{.width = choice.screens[i].width,
                                 .height = choice.screens[i].height,
                                 .film_rate = rate,
                                 .name = fmt::format("offscreen-{}", i + 1)};
        if (recording_.film) options.film = numbered(*recording_.film, i);
        screens_.push_back(std::make_unique<OffscreenScreen>(options, egl_));
        lent_.push_back(screens_.back().get());
    }
}

std::string OffscreenDisplay::description() const {
    std::string sizes;
    for (const auto& screen : screens_)
        sizes += fmt::format("{}x{} px, ", screen->width(), screen->height());
    return fmt::format("off screen, {}{}", sizes, gl_device());
}

std::vector<std::string> OffscreenDisplay::finish_recording() {
    std::vector<std::string> lines;
    for (const auto& screen : screens_)
        screen->finish_film();
    if (recording_.film) lines.push_back(fmt::format("film: '{}'", recording_.film->string()));
    if (!recording_.snapshot) return lines;
    for (std::size_t i = 0; i < screens_.size(); ++i)
        save_png(screens_[i]->picture(), numbered(*recording_.snapshot, i));
    lines.push_back(fmt::format("snapshot: '{}'", recording_.snapshot->string()));
    return lines;
}

}  // namespace vitrine::player
