#include "player/player.hpp"

#include "base/catalogue/catalogue.hpp"
#include "base/media/colour.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"
#include "player/display/kms_screen.hpp"
#include "player/display/offscreen_screen.hpp"
#include "player/display/screen_choice.hpp"
#include "player/layout/nesting.hpp"
#include "player/player_settings.hpp"
#include "player/scene/panning_wall.hpp"
#include "player/scene/wall.hpp"

#include <fmt/format.h>
#include <sys/epoll.h>

#include <algorithm>
#include <csignal>
#include <utility>

namespace vitrine {

namespace {

using namespace std::chrono_literals;

constexpr auto source_patience = 10s;    // that a picture paced by its sources waits for one of them
constexpr auto invisible_pause = 500ms;  // between two looks at a screen that is not there
constexpr auto busy_pause = 2ms;         // between two looks at a screen whose flip is under way
constexpr auto status_interval = 5s;
constexpr int most_settling_steps = 100;  // each gives up on a file at least

KmsOptions kms_options(const Settings& settings, const KmsChoice& choice) {
    return {.card = choice.card,
            .wish = parse_mode(settings.output.mode),
            .api = settings.output.api == "legacy" ? KmsApi::legacy : KmsApi::best};
}

}  // namespace

Player::Player(const Settings& settings, const PlayOptions& options)
    : settings_(settings),
      options_(options),
      interrupted_(loop_.signal(SIGINT, [this] { loop_.quit(); })),
      terminated_(loop_.signal(SIGTERM, [this] { loop_.quit(); })),
      screen_(make_screen()),
      view_(view_of(settings)),
      canvas_(canvas_size(screen_->width(), screen_->height(), view_)),
      renderer_(screen_->width(), screen_->height(), view_),
      show_(make_show()),
      sources_({.media = settings.media.root, .store = settings.state.directory + "/store"},
               colour_named(settings.show.background).value_or(Colour{})),
      follower_(loop_, Catalogue(std::filesystem::path(settings.state.directory) / "catalogue"),
                [this](const CatalogueChange& change) { follow(change); }),
      clock_(settings.output.frame_rate),
      tick_(loop_.timer([this] { tick(); })),
      told_(loop_.timer([this] { tell(); })) {
    if (screen_->event_fd() >= 0)
        screen_events_ =
            loop_.watch(screen_->event_fd(), EPOLLIN, [this](std::uint32_t) { screen_->dispatch(); });
    log::info("screen: {}", screen_->description());
}

Player::~Player() = default;

std::unique_ptr<Screen> Player::make_screen() {
    const ScreenChoice choice = parse_screen(settings_.output.screen);
    if (const auto* memory = std::get_if<OffscreenChoice>(&choice)) {
        auto screen = make_offscreen({.width = memory->width,
                                      .height = memory->height,
                                      .film = options_.film,
                                      .film_rate = static_cast<double>(settings_.output.frame_rate)});
        offscreen_ = screen.get();
        is_paced_by_pictures_ = !options_.is_realtime;
        return screen;
    }
    return make_kms(kms_options(settings_, std::get<KmsChoice>(choice)));
}

std::unique_ptr<Show> Player::make_show() const {
    if (settings_.layout.mode == "pan")
        return std::make_unique<PanningWall>(canvas_, pan_settings(settings_));
    return std::make_unique<Wall>(canvas_, wall_settings(settings_));
}

void Player::run() {
    start_ = EventLoop::Clock::now();
    tick_.arm(0s);
    told_.arm(0s);
    service::ready("starting");
    loop_.run();
    finish();
}

void Player::follow(const CatalogueChange& change) {
    for (const std::string& path : change.added)
        log::info("new: '{}'", path);
    for (const std::string& path : change.grown)
        log::debug("further shots: '{}'", path);
    for (const std::string& path : change.replaced)
        log::info("replaced: '{}'", path);
    for (const std::string& path : change.gone)
        log::info("gone: '{}'", path);
    if (!options_.rehearsal) return show_->set_catalogue(follower_.records());
    show_->set_catalogue(options_.rehearsal->present(follower_.records()));
}

void Player::rehearse(std::chrono::nanoseconds time) {
    if (options_.rehearsal->advance(time))
        show_->set_catalogue(options_.rehearsal->present(follower_.records()));
    show_->touch(options_.rehearsal->finger());
}

std::chrono::nanoseconds Player::now() const {
    return is_paced_by_pictures_ ? clock_.due() : EventLoop::Clock::now() - start_;
}

/// One picture, or the pause until there can be one.
void Player::tick() {
    const std::chrono::nanoseconds time = now();
    if (options_.duration && time >= *options_.duration) return loop_.quit();
    tell_of_screen();
    if (!screen_->is_visible()) {
        clock_.skip_to(time);
        return tick_.arm(invisible_pause);
    }
    if (time < clock_.due()) return tick_.arm(clock_.due() - time);
    if (!screen_->is_ready()) return tick_.arm(busy_pause);
    follow_screen_size();
    if (options_.rehearsal) rehearse(time);
    WallStep step = next_step(time);
    draw(step.frame);
    if (is_paced_by_pictures_)
        clock_.shown_exactly();
    else
        clock_.shown(time);
    service::alive();
    tick_.arm(std::max(0ns, clock_.due() - now()));
}

void Player::tell_of_screen() {
    for (const ScreenEvent& event : screen_->take_events())
        log::write(event.is_trouble ? log::Level::warning : log::Level::info, "screen: " + event.text);
}

void Player::follow_screen_size() {
    const Vec2 canvas = canvas_size(screen_->width(), screen_->height(), view_);
    if (canvas == canvas_) return;
    canvas_ = canvas;
    renderer_.resize(screen_->width(), screen_->height());
    show_->set_canvas(canvas);
}

WallStep Player::next_step(std::chrono::nanoseconds time) {
    take_layout();
    take_source_events(sources_.update(), time);
    WallStep step = show_->step(time);
    carry_out(step);
    for (int i = 0; is_paced_by_pictures_ && i < most_settling_steps && (step.plan || !step.requests.empty());
         ++i) {
        // The clock stands still until the layout and the sources are there.
        take_source_events(sources_.wait_until_ready(source_patience), time);
        step = show_->step(time);
        carry_out(step);
    }
    return step;
}

void Player::take_layout() {
    std::optional<Layout> layout = planner_.take();
    if (!layout || !layout->is_final || layout->generation != asked_) return;
    take_layout(std::move(*layout));
}

void Player::take_layout(Layout layout) {
    layout.generation = planned_.generation;
    show_->set_layout(layout);
}

void Player::take_source_events(const std::vector<SourceEvent>& events, std::chrono::nanoseconds time) {
    for (const SourceEvent& event : events) {
        if (!event.failure) {
            if (!event.unstored.empty())
                log::info("not in the store, played from the media folder: '{}'", event.unstored);
            show_->source_ready(event.source);
            continue;
        }
        log::warning("not shown for now: {}", *event.failure);
        show_->source_failed(event.source, time);
    }
}

void Player::carry_out(const WallStep& step) {
    if (step.plan) ask(*step.plan);
    for (const ShotRequest& request : step.requests)
        sources_.request(request);
    for (const SourceId source : step.retired) {
        sources_.retire(source);
        renderer_.forget(source);
        uploaded_.erase(source);
    }
}

/// Has a wall laid out: at once where the clock waits anyway, else by the planner's thread.
void Player::ask(const WallPlan& wall) {
    PlanRequest request = plan_request(settings_, wall.canvas);
    request.items = wall.items;
    planned_ = wall;
    if (is_paced_by_pictures_)
        take_layout(planned(request));
    else
        asked_ = planner_.request(std::move(request));
}

void Player::draw(Frame& frame) {
    if (is_paced_by_pictures_) sources_.wait_for(frame, source_patience);
    sources_.advance(frame);
    for (const DrawItem& item : frame.items) {
        const std::optional<Sample> sample = sources_.sample(item.source);
        if (!sample || uploaded_[item.source] == sample->owner) continue;
        renderer_.upload(item.source, *sample);
        uploaded_[item.source] = sample->owner;
    }
    screen_->begin_frame();
    renderer_.draw(frame);
    screen_->present(frame.time);
    if (show_->count() == items_) return;
    items_ = show_->count();
    log::info("wall of {} {}", items_, items_ == 1 ? "item" : "items");
}

void Player::tell() {
    service::status(fmt::format("{}, {} items, {} pictures shown, {} late", screen_->description(), items_,
                                clock_.pictures(), clock_.late()));
    told_.arm(status_interval);
}

void Player::finish() {
    service::stopping();
    log::info("{} pictures shown, {} late; {} pictures of films were late", clock_.pictures(), clock_.late(),
              sources_.late());
    if (offscreen_ == nullptr) return;
    offscreen_->finish_film();
    if (options_.film) log::info("film: '{}'", options_.film->string());
    if (!options_.snapshot) return;
    save_png(offscreen_->picture(), *options_.snapshot);
    log::info("snapshot: '{}'", options_.snapshot->string());
}

}  // namespace vitrine
