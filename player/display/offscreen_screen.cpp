#include "player/display/offscreen_screen.hpp"

#include <utility>

namespace vitrine::player {

OffscreenScreen::OffscreenScreen(const OffscreenOptions& options, std::shared_ptr<Egl> egl)
    : name_(options.name),
      egl_(egl ? std::move(egl) : std::make_shared<Egl>(Egl::surfaceless())),
      drawn_(options.width, options.height) {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (options.film)
        film_ = std::make_unique<FilmWriter>(*options.film, width(), height(), options.film_rate);
}

void OffscreenScreen::begin_frame() {
    drawn_.make_current();
    glViewport(0, 0, width(), height());
}

void OffscreenScreen::present(std::chrono::nanoseconds time) {
    if (film_)
        film_->add(picture(), time);
    else
        glFinish();
    has_picture_ = true;
    ++flips_;
}

std::optional<CardPicture> OffscreenScreen::shown() {
    if (flips_ == 0) return std::nullopt;
    return drawn_.picture();
}

void OffscreenScreen::finish_film() {
    if (!film_) return;
    const std::unique_ptr<FilmWriter> ending = std::move(film_);
    ending->finish();
}

}  // namespace vitrine::player
