#include "player/display/offscreen_display.hpp"

#include "player/display/gl_device.hpp"

#include <fmt/format.h>

#include <charconv>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int min_side = 16;     // px
constexpr int max_side = 16384;  // px, as graphics cards allow

std::optional<int> side(std::string_view digits) {
    int value = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (error != std::errc{} || stop != end || value < min_side || value > max_side) return std::nullopt;
    return value;
}

std::optional<ScreenSize> screen_size(std::string_view text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos) return std::nullopt;
    const std::optional<int> width = side(text.substr(0, cross));
    const std::optional<int> height = side(text.substr(cross + 1));
    if (!width || !height) return std::nullopt;
    return ScreenSize{.width = *width, .height = *height};
}

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

std::optional<OffscreenChoice> offscreen_choice(std::string_view sizes) {
    OffscreenChoice choice;
    while (true) {
        const std::size_t plus = sizes.find('+');
        const std::optional<ScreenSize> size = screen_size(sizes.substr(0, plus));
        if (!size) return std::nullopt;
        choice.screens.push_back(*size);
        if (plus == std::string_view::npos) return choice;
        sizes.remove_prefix(plus + 1);
    }
}

std::unique_ptr<DisplayOpener> make_offscreen_opener(std::optional<std::string_view> argument,
                                                     const DisplayRequest& request) {
    std::optional<OffscreenChoice> choice = offscreen_choice(argument.value_or(""));
    if (!choice) return nullptr;
    return std::make_unique<OffscreenOpener>(*std::move(choice), request);
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
