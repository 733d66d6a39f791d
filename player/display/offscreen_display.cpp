#include "player/display/offscreen_display.hpp"

#include "player/display/gl_device.hpp"

#include <fmt/format.h>

namespace vitrine::player {

std::filesystem::path numbered(const std::filesystem::path& path, std::size_t index) {
    if (index == 0) return path;
    std::filesystem::path made = path;
    return made.replace_filename(
        fmt::format("{}-{}{}", path.stem().string(), index + 1, path.extension().string()));
}

OffscreenDisplay::OffscreenDisplay(const OffscreenChoice& choice,
                                   const std::optional<std::filesystem::path>& film, double rate)
    : egl_(std::make_shared<Egl>(Egl::surfaceless())) {
    for (std::size_t i = 0; i < choice.screens.size(); ++i) {
        OffscreenOptions options{.width = choice.screens[i].width,
                                 .height = choice.screens[i].height,
                                 .film_rate = rate,
                                 .name = fmt::format("offscreen-{}", i + 1)};
        if (film) options.film = numbered(*film, i);
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

void OffscreenDisplay::finish_films() {
    for (const auto& screen : screens_)
        screen->finish_film();
}

void OffscreenDisplay::save(const std::filesystem::path& path) {
    for (std::size_t i = 0; i < screens_.size(); ++i)
        save_png(screens_[i]->picture(), numbered(path, i));
}

}  // namespace vitrine::player
