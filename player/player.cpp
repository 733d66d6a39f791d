#include "player/player.hpp"

#include "base/settings/output_words.hpp"
#include "base/state/catalogue.hpp"
#include "base/system/journal.hpp"
#include "base/system/service.hpp"
#include "player/display/display_kinds.hpp"
#include "player/display/gl_device.hpp"
#include "player/playback/hardware_decoders.hpp"
#include "player/render/upload_choice.hpp"
#include "player/stage/stage_settings.hpp"

#include <fmt/format.h>
#include <sys/epoll.h>

#include <algorithm>
#include <csignal>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto invisible_pause = 200ms;  // between two looks at a screen that is not there
constexpr auto busy_pause = 2ms;         // between two looks at a screen whose flip is under way
constexpr auto retry_pause = 1s;         // before another try to open a graphics card
constexpr auto status_interval = 5s;
constexpr auto old_picture_patience = 4s;  // then it gives way to a wall that is not whole

}  // namespace

Player::Player(const Settings& settings, const PlayOptions& options)
    : settings_(settings),
      options_(options),
      interrupted_(loop_.signal(SIGINT, [this] { loop_.quit(); })),
      terminated_(loop_.signal(SIGTERM, [this] { loop_.quit(); })),
      reloaded_(loop_.signal(SIGHUP, [this] { reload_or_tell(); })),
      left_(loop_.signal(Console::leave_signal, [this] { leave_terminal(); })),
      entered_(loop_.signal(Console::enter_signal, [this] { come_to_terminal(); })),
      opener_(make_display_opener(
          {.output = settings.output, .recording = {.film = options.film, .snapshot = options.snapshot}})),
      is_paced_by_pictures_(opener_->traits().can_wait_for_pictures && !options.is_realtime),
      console_(opener_->traits().has_terminal ? std::make_unique<Console>() : nullptr),
      crash_note_(settings.state.directory),
      sources_(media_places(settings), source_options(settings, !is_paced_by_pictures_)),
      hours_(settings.state.directory),
      follower_(loop_, Catalogue(std::filesystem::path(settings.state.directory) / "catalogue"),
                [this](const CatalogueChange& change) { follow(change); }),
      clock_(settings.output.frame_rate),
      visitors_(loop_, opener_->traits().has_terminal ? settings.input.devices : "none"),
      tick_(loop_.timer([this] { tick(); })),
      told_(loop_.timer([this] { tell(); })),
      noted_(loop_.timer([this] {
          if (crash_note_.keep(sources_.open_files(), follower_.records(), EventLoop::Clock::now()))
              give_catalogue();
          noted_.arm(status_interval);
      })) {
    if (settings.output.decoders == DecoderChoice::automatic)
        sources_.set_decoders(hardware_decoders(is_usable_here));
    log::info("films are decoded {}", in_words(sources_.decoders()));
    operation_.emplace(loop_, OperatedParts{.settings = settings_,
                                            .display = display_,
                                            .complaint = complaint_,
                                            .stages = stages_,
                                            .sources = sources_,
                                            .follower = follower_,
                                            .clock = clock_,
                                            .give_catalogue = [this] { give_catalogue(); },
                                            .reload = [this] { reload(); }});
    if (!is_paced_by_pictures_ && !settings.output.sound.empty())
        sound_.emplace(media_places(settings), alsa_sink(settings.output.sound));
    if (!settings.status.folder.empty() && !options.rehearsal)
        wall_picture_.emplace(std::filesystem::path(settings.state.directory) / "wall.jpg");
    sources_.before_opening([this](const std::string& path) {
        crash_note_.open(path, follower_.records(), EventLoop::Clock::now());
    });
    make_stages();
    if (!is_paced_by_pictures_) expect_screen();
    open_display();
    if (!is_paced_by_pictures_) operation_->export_to_bus();
}

Player::~Player() = default;

void Player::make_stages() {
    const auto folders = output_folders_named(settings_.output.folders).value();
    std::map<std::string, std::size_t> stage_of_folder{{"", 0}};
    for (const auto& [output, folder] : folders)
        stage_of_[output] = stage_of_folder.emplace(folder, stage_of_folder.size()).first->second;
    stages_.resize(stage_of_folder.size());
    for (const auto& [folder, i] : stage_of_folder) {
        StageOptions options{.number = i, .folder = folder, .await_sources = {}};
        if (is_paced_by_pictures_)
            options.await_sources = [this] { hand_out(sources_.wait_until_ready(source_patience)); };
        stages_[i] = std::make_unique<Stage>(settings_, options, sources_);
    }
    give_catalogue();
    if (options_.tapestry) stages_.front()->show_strip(*options_.tapestry, std::nullopt);
}

/// While the display is opened, which takes a tenth of a second, the first wall is laid out for the size that
/// most have.
void Player::expect_screen() {
    const ScreenSize size = opener_->traits().expected;
    stages_.front()->expect_screen(size.width, size.height);
}

/// A card that is not there, or that another program has, is awaited; off screen there is nothing to wait
/// for.
void Player::open_display() {
    next_try_ = EventLoop::Clock::now() + retry_pause;
    if (console_ && !console_->is_in_front()) return;
    try {
        display_ = opener_->open();
    } catch (const std::exception& error) {
        if (!opener_->traits().is_awaited) throw;
        if (complaint_ != error.what()) log::warning("screen: waiting: {}", error.what());
        complaint_ = error.what();
        return;
    }
    complaint_.clear();
    if (gl_ != display_->gl()) make_renderer();
    if (display_->event_fd() >= 0)
        display_events_ =
            loop_.watch(display_->event_fd(), EPOLLIN, [this](std::uint32_t) { display_->dispatch(); });
    log::info("screen: {}", display_->description());
}

void Player::make_renderer() {
    drop_renderer();
    gl_ = display_->gl();
    gl_->make_current(EGL_NO_SURFACE);
    renderer_.emplace(1, 1);
    const PictureForm form = picture_form(gl_device(), renderer_->reads_shared_planes());
    sources_.set_form(form);
    log::info("films: {}", in_words(form));
}

/// What it has made ends in the context that it was made in.
void Player::drop_renderer() {
    if (!renderer_) return;
    gl_->make_current(EGL_NO_SURFACE);
    for (const auto& stage : stages_)
        stage->forget_uploads();
    renderer_.reset();
    gl_.reset();
}

void Player::close_display() {
    for (const auto& stage : stages_)
        stage->set_screens({}, now());
    display_events_ = {};
    if (!display_->has_lasting_gl()) drop_renderer();
    display_.reset();
}

void Player::run() {
    start_ = EventLoop::Clock::now();
    tick_.arm(0s);
    told_.arm(0s);
    noted_.arm(status_interval);
    service::ready("starting");
    loop_.run();
    finish();
}

void Player::follow(const CatalogueChange& change) {
    for (const std::string& path : change.added)
        log::write_with(log::Level::info, fmt::format("new: '{}'", path), {{"VITRINE_FILE", path}});
    for (const std::string& path : change.grown)
        log::debug("further shots: '{}'", path);
    for (const std::string& path : change.replaced)
        log::info("replaced: '{}'", path);
    for (const std::string& path : change.gone)
        log::write_with(log::Level::info, fmt::format("gone: '{}'", path), {{"VITRINE_FILE", path}});
    give_catalogue();
}

void Player::give_catalogue() {
    std::vector<MediaRecord> records =
        options_.rehearsal ? options_.rehearsal->present(follower_.records()) : follower_.records();
    crash_note_.hold_back(records);
    hours_.set_files(operation_ ? operation_->wanted(records) : std::move(records));
    next_look_ = 0ns;
    follow_hours(0ns);
}

/// Periods and hours begin and end on the second.
void Player::follow_hours(std::chrono::nanoseconds time) {
    if (time < next_look_) return;
    next_look_ = time + 1s;
    if (!hours_.look(options_.rehearsal ? options_.rehearsal->local_time() : std::nullopt)) return;
    const RecordList records = hours_.open();
    for (const auto& stage : stages_)
        stage->set_catalogue(records, hours_.hints());
}

std::chrono::nanoseconds Player::now() const {
    return is_paced_by_pictures_ ? clock_.due() : EventLoop::Clock::now() - start_;
}

/// One picture, or the pause until there can be one.
void Player::tick() {
    const std::chrono::nanoseconds time = now();
    if (options_.duration && time >= *options_.duration) return loop_.quit();
    follow_display(time);
    operation_->look(time);
    if (!display_ || display_->screens().empty()) {
        clock_.skip_to(time);
        hear(time);
        return tick_.arm(invisible_pause);
    }
    if (time < clock_.due()) return tick_.arm(clock_.due() - time);
    if (!is_time_to_draw(time)) return tick_.arm(busy_pause);
    if (options_.rehearsal) rehearse(time);
    follow_hours(time);
    visitors_.hand_out(display_->screens(), start_,
                       [this](const Screen& screen, InputEvent event) { take(screen, event); });
    hand_out(sources_.update());
    const bool waits = display_->has_old_picture() && time < old_picture_patience;
    for (const auto& stage : stages_)
        if (!stage->screens().empty()) stage->show(time, *renderer_, waits);
    hear(time);
    take_wall_picture(time);
    tell_items();
    if (is_paced_by_pictures_)
        clock_.shown_exactly();
    else
        clock_.shown(time);
    tick_.arm(std::max(0ns, clock_.due() - now()));
}

/// Of the first wall, where it is shown.
void Player::take_wall_picture(std::chrono::nanoseconds time) {
    const Stage& stage = *stages_.front();
    if (!wall_picture_ || stage.screens().empty() || !wall_picture_->is_due(stage.frame(), time)) return;
    wall_picture_->take(stage.picture(WallPicture::longest_side, *renderer_));
}

/// All screens can take a picture; or one can, and the others have been waited for.
bool Player::is_time_to_draw(std::chrono::nanoseconds time) {
    const auto patience = 500'000'000ns / settings_.output.frame_rate;
    const std::span<Screen* const> screens = display_->screens();
    const auto ready = std::ranges::count_if(screens, &Screen::is_ready);
    return ready == std::ssize(screens) || (ready > 0 && time > clock_.due() + patience);
}

void Player::hand_out(const std::vector<SourceEvent>& events) {
    for (const SourceEvent& event : events)
        for (const auto& stage : stages_)
            if (stage->owns(event.source)) stage->tell(event);
}

void Player::tell_items() {
    for (const auto& stage : stages_) {
        const auto [told, is_new] = items_.try_emplace(stage->folder(), 0);
        if (told->second == stage->count()) continue;
        told->second = stage->count();
        log::info("wall of {} {}{}", told->second, told->second == 1 ? "item" : "items",
                  stage->folder().empty() ? "" : fmt::format(" of '{}'", stage->folder()));
    }
}

void Player::tell() {
    operation_->tell(now());
    told_.arm(status_interval);
}

void Player::finish() {
    if (display_ && console_ && display_->keep_picture()) console_->keep();
    crash_note_.end();
    service::stopping();
    log::info("{} pictures shown, {} late; {} pictures of films were late", clock_.pictures(), clock_.late(),
              sources_.late());
    if (!display_) return;
    for (const std::string& line : display_->finish_recording())
        log::info("{}", line);
}

}  // namespace vitrine::player
