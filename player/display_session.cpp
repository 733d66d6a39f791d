#include "player/display_session.hpp"

#include "base/state/screen_note.hpp"
#include "base/system/log.hpp"
#include "player/display/console.hpp"
#include "player/display/display.hpp"
#include "player/display/gl_device.hpp"
#include "player/render/renderer.hpp"
#include "player/render/uploaded_pictures.hpp"

#include <sys/epoll.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto retry_pause = 1s;  // before another try to open a graphics card

}  // namespace

DisplaySession::DisplaySession(EventLoop& loop, std::unique_ptr<DisplayOpener> opener,
                               std::filesystem::path state, PanelRules rules, RendererCalls calls)
    : loop_(loop),
      opener_(std::move(opener)),
      state_(std::move(state)),
      hours_(std::move(rules)),
      calendar_(state_ / "catalogue"),
      calls_(std::move(calls)),
      console_(opener_->traits().has_terminal ? std::make_unique<Console>() : nullptr) {}

DisplaySession::~DisplaySession() = default;

void DisplaySession::open() {
    next_try_ = EventLoop::Clock::now() + retry_pause;
    if (console_ && !console_->is_in_front()) return;
    try {
        display_ = opener_->open();
    } catch (const std::exception& error) {
        if (!opener_->traits().is_awaited) throw;
        if (complaint_ != error.what()) log::warning("screen: waiting for a display: {}", error.what());
        complaint_ = error.what();
        return;
    }
    complaint_.clear();
    if (gl_ != display_->gl()) make_renderer();
    if (display_->event_fd() >= 0)
        events_ = loop_.watch(display_->event_fd(), EPOLLIN, [this](std::uint32_t) { display_->dispatch(); });
    log::info("screen: {}", display_->description());
}

void DisplaySession::make_renderer() {
    drop_renderer();
    gl_ = display_->gl();
    gl_->make_current(EGL_NO_SURFACE);
    renderer_ = std::make_unique<Renderer>(1, 1);
    const PictureForm form = picture_form(gl_device(), renderer_->reads_shared_planes());
    calls_.began(form);
    log::info("pictures of films: {}", in_words(form));
}

/// The renderer's GL objects must be destroyed while their context is current.
void DisplaySession::drop_renderer() {
    if (!renderer_) return;
    gl_->make_current(EGL_NO_SURFACE);
    calls_.ends();
    renderer_.reset();
    gl_.reset();
}

void DisplaySession::close() {
    events_ = {};
    if (!display_->has_lasting_gl()) drop_renderer();
    display_.reset();
}

/// Turns the panels off outside their hours; the next picture turns them on.
void DisplaySession::follow_hours(std::optional<std::chrono::local_seconds> rehearsed,
                                  std::chrono::nanoseconds now) {
    hours_.look(rehearsed ? rehearsed : calendar_.now(), now);
    if (const std::string news = hours_.take_news(); !news.empty()) {
        log::info("screen: {}", news);
        if (traits().has_terminal) television_.ask(hours_.is_on());
    }
    television_.look();
    if (renderer_) renderer_->set_light(hours_.light());
    if (hours_.is_on() || !display_) return;
    for (Screen* screen : display_->screens())
        screen->turn_off();
}

void DisplaySession::follow_display(std::optional<std::chrono::local_seconds> rehearsed,
                                    std::chrono::nanoseconds now) {
    if (display_) {
        for (const DisplayEvent& event : display_->take_events())
            log::write(event.is_trouble ? log::Level::warning : log::Level::info, "screen: " + event.text);
        if (display_->is_gone()) close();
    }
    if (!display_ && EventLoop::Clock::now() >= next_try_) open();
    note_screens();
    follow_hours(rehearsed, now);
}

std::span<Screen* const> DisplaySession::screens() const {
    return display_ && hours_.is_on() ? display_->screens() : std::span<Screen* const>();
}

void DisplaySession::forget_source(SourceId source) {
    if (renderer_) renderer_->forget(source);
}

const DisplayTraits& DisplaySession::traits() const {
    return opener_->traits();
}

bool DisplaySession::has_old_picture() const {
    return display_ && display_->has_old_picture();
}

bool DisplaySession::is_away() const {
    return !hours_.is_on() || (display_ && display_->is_away());
}

std::string DisplaySession::description() const {
    if (display_) return (hours_.is_on() ? "" : "off, outside of output.on: ") + display_->description();
    return complaint_.empty() ? "no graphics card at present" : complaint_;
}

/// Tells the analyzer the size of the screens: it makes clips of films to suit them.
void DisplaySession::note_screens() {
    int side = 0;
    for (const Screen* screen : screens())
        side = std::max({side, screen->width(), screen->height()});
    if (side == 0 || side == std::exchange(noted_side_, side)) return;
    try {
        note_screen_side(state_, side);
    } catch (const std::system_error& error) {
        log::warning("the size of the screens cannot be noted for the analyzer: {}", error.what());
    }
}

void DisplaySession::leave_terminal() {
    if (display_) display_->leave();
    log::info("screen: left to another terminal");
    if (console_) console_->leave();
}

void DisplaySession::return_to_terminal() {
    if (console_) console_->enter();
    log::info("screen: back from another terminal");
    if (display_) display_->take_back();
}

void DisplaySession::finish() {
    if (display_ && console_ && display_->keep_picture()) console_->keep();
    if (!display_) return;
    for (const std::string& line : display_->finish_recording())
        log::info("{}", line);
}

}  // namespace vitrine::player
