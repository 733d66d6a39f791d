#include "player/display/offscreen_screen.hpp"

#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace vitrine {

OffscreenScreen::OffscreenScreen(const OffscreenOptions& options, std::shared_ptr<Egl> egl)
    : name_(options.name),
      width_(options.width),
      height_(options.height),
      egl_(egl ? std::move(egl) : std::make_shared<Egl>(Egl::surfaceless())) {
    glGenFramebuffers(1, &frame_buffer_);
    glGenRenderbuffers(1, &colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
    glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw std::runtime_error(fmt::format("no off-screen picture of {}x{} px", width_, height_));
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (options.film) film_ = std::make_unique<FilmWriter>(*options.film, width_, height_, options.film_rate);
}

// The frame buffer ends with its context.
OffscreenScreen::~OffscreenScreen() = default;

void OffscreenScreen::begin_frame() {
    glBindFramebuffer(GL_FRAMEBUFFER, frame_buffer_);
    glViewport(0, 0, width_, height_);
}

void OffscreenScreen::present(std::chrono::nanoseconds time) {
    if (film_)
        film_->add(picture(), time);
    else
        glFinish();
}

Picture OffscreenScreen::picture() {
    const auto row = static_cast<std::size_t>(width_) * 4;
    rows_.resize(row * static_cast<std::size_t>(height_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_buffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rows_.data());
    if (const GLenum error = glGetError(); error != GL_NO_ERROR)
        throw std::runtime_error(fmt::format("read the off-screen picture: GL error {:#x}", error));

    Picture picture{.width = width_, .height = height_, .pixels = {}};
    picture.pixels.reserve(rows_.size());
    for (std::size_t end = rows_.size(); end > 0; end -= row)
        picture.pixels.insert(picture.pixels.end(), rows_.data() + (end - row), rows_.data() + end);
    return picture;
}

void OffscreenScreen::finish_film() {
    if (!film_) return;
    const std::unique_ptr<FilmWriter> ending = std::move(film_);
    ending->finish();
}

}  // namespace vitrine
