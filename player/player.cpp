#include "player/player.hpp"

#include "base/calendar/dates.hpp"
#include "base/media/still_picture.hpp"
#include "base/settings/settings_file.hpp"
#include "base/system/log.hpp"
#include "base/system/service.hpp"
#include "player/content/visible_files.hpp"
#include "player/display/console.hpp"
#include "player/display/display.hpp"
#include "player/display/display_kinds.hpp"
#include "player/display/screen.hpp"
#include "player/display_session.hpp"
#include "player/input/input_devices.hpp"
#include "player/playback/hardware_decoders.hpp"
#include "player/playback/reader/upload_readers.hpp"
#include "player/playback/sound/wall_sound.hpp"
#include "player/playback/source_pool.hpp"
#include "player/player_service.hpp"
#include "player/render/renderer.hpp"
#include "player/scene/chosen_sound.hpp"
#include "player/scene/show.hpp"
#include "player/settings_change.hpp"
#include "player/stage/stage_settings.hpp"
#include "player/stage/stages.hpp"
#include "player/stage/wall_picture.hpp"
#include "player/wall_link/wall_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <set>
#include <string>
#include <utility>

namespace vitrine::player {

namespace {

using namespace std::chrono_literals;

constexpr auto invisible_pause = 200ms;    // between two tries while no screen is there
constexpr auto busy_pause = 2ms;           // between two tries while a flip is under way
constexpr auto old_picture_patience = 4s;  // then a wall with gaps replaces the old picture

/// True: all screens can take a picture; or one can, and the frame is too late to wait for the others.
bool can_draw(std::span<Screen* const> screens, bool is_late) {
    const auto ready = std::ranges::count_if(screens, &Screen::is_ready);
    return ready == std::ssize(screens) || (ready > 0 && is_late);
}

/// True: a screen shows a wall, or one of a box that this one leads.
bool are_seen(const Stages& stages) {
    return std::ranges::any_of(stages.all(), [](const auto& stage) { return stage->is_seen(); });
}

/// @param is_off  the displays are off, or another program has them
WallContent content_of(const Stages& stages, const SourcePool& sources, bool is_off) {
    WallContent content{.folders = {}, .files = {}, .open = sources.open_files(), .is_off = is_off};
    for (const auto& stage : stages.all()) {
        if (!stage->is_seen()) continue;
        content.folders.push_back({.folder = stage->files().folder(),
                                   .opened = stage->wall().opened_folder(),
                                   .avoided = stage->wall().avoided_files()});
        for (const SlotShot& shot : stage->wall().standing())
            content.files.insert(shot.key.path);
    }
    return content;
}

}  // namespace

Player::Player(const Settings& settings, const PlayOptions& options)
    : settings_(settings),
      options_(options),
      signals_(watch_signals()),
      clock_(settings.output.frame_rate),
      wall_(std::make_unique<WallLink>(loop_, settings_)),
      tick_(loop_.timer([this] { tick(); })) {
    make_display();
    const std::filesystem::path state = settings.state.directory;
    const Rehearsal* rehearsal = options_.rehearsal ? &*options_.rehearsal : nullptr;
    files_ = std::make_unique<VisibleFiles>(
        loop_, state,
        ShowDays{.holidays = *dates_named(settings.show.holidays), .on_this_day = settings.show.on_this_day},
        rehearsal, [this] {
            if (stages_) stages_->set_catalogue(files_->records(), files_->hints());
        });
    make_sources();
    stages_ = std::make_unique<Stages>(settings_, *sources_, is_paced_by_pictures(), wall_->others());
    if (!is_paced_by_pictures() && !settings.output.sound.empty())
        sound_ = std::make_unique<WallSound>(media_places(settings), alsa_sink(settings.output.sound));
    if (!settings.status.folder.empty() && !options.rehearsal)
        wall_picture_ = std::make_unique<WallPicture>(state / "wall.jpg");
    input_devices_ = std::make_unique<InputDevices>(
        loop_, display_->traits().has_terminal ? settings.input.devices : "none");
    service_ = std::make_unique<PlayerService>(loop_, view(), actions());
    if (settings_.input.keep_arrangement) service_->arrangements().take_last();
    begin_stages();
    // Opening the display takes a tenth of a second. Meanwhile the first wall is laid out for the most usual
    // size.
    const ScreenSize size = display_->traits().expected;
    if (!is_paced_by_pictures()) stages_->first().expect_screen(size.width, size.height);
    display_->open();
    if (!is_paced_by_pictures()) service_->export_to_bus();
}

Player::~Player() = default;

std::vector<EventLoop::Source> Player::watch_signals() {
    std::vector<EventLoop::Source> signals;
    const auto watch = [&](int number, std::function<void()> call) {
        signals.push_back(loop_.signal(number, std::move(call)));
    };
    watch(SIGINT, [this] { loop_.quit(); });
    watch(SIGTERM, [this] { loop_.quit(); });
    watch(SIGHUP, [this] {
        try {
            reload();
        } catch (const SettingsError& error) {
            log::error("settings: {}; the old ones stay", error.what());
        }
    });
    watch(Console::leave_signal, [this] {
        input_devices_->suspend();
        display_->leave_terminal();
    });
    watch(Console::enter_signal, [this] {
        input_devices_->resume();
        display_->return_to_terminal();
    });
    return signals;
}

void Player::make_display() {
    const Recording recording{.film = options_.film, .snapshot = options_.snapshot};
    display_ = std::make_unique<DisplaySession>(
        loop_, make_display_opener({.output = settings_.output, .recording = recording}),
        settings_.state.directory, panel_rules(settings_),
        RendererCalls{.began = [this](PictureForm form) { sources_->film_options().form = form; },
                      .ends = [this] { stages_->forget_uploads(); }});
}

void Player::make_sources() {
    init_vips();  // here, where there are no threads yet that load libraries or read the environment
    SourceOptions options = source_options(settings_, !is_paced_by_pictures());
    if (options_.readers) options.uploads = upload_readers(options_.readers, settings_.media.root);
    sources_ = std::make_unique<SourcePool>(media_places(settings_), options);
    if (settings_.output.decoders == DecoderChoice::automatic)
        sources_->film_options().decoders = hardware_decoders(is_usable_here);
    log::info("films are decoded {}", in_words(sources_->film_options().decoders));
    sources_->listen_to_files([this](const std::string& path, FileNews news) {
        files_->note_file(path, news, EventLoop::Clock::now());
    });
}

PlayerView Player::view() const {
    return {.settings = settings_,
            .display = *display_,
            .files = *files_,
            .stages = *stages_,
            .sources = *sources_,
            .clock = clock_,
            .wall = *wall_,
            .is_rehearsed = options_.rehearsal.has_value()};
}

PlayerActions Player::actions() {
    return {.set_controls = [this](const ShowControls& controls) { stages_->set_controls(controls); },
            .set_dismissed = [this](const std::set<std::string>& paths) { files_->set_dismissed(paths); },
            .arrange = [this](const ArrangedWalls& walls) { stages_->arrange(walls); },
            .acquit = [this](const std::string& path) { files_->acquit(path); },
            .reload = [this] { reload(); },
            .toggle_guides = [this] { return stages_->toggle_guides(); }};
}

void Player::begin_stages() {
    stages_->set_catalogue(files_->records(), files_->hints());
    if (!options_.tapestry) return;
    for (const auto& stage : stages_->all())
        stage->show_tapestry(*options_.tapestry, std::nullopt);
}

void Player::run() {
    wall_->begin();
    tick_.arm(0s);
    service::ready("starting");
    loop_.run();
    finish();
}

/// True: time waits for the pictures; false: pictures that are late are skipped.
bool Player::is_paced_by_pictures() const {
    return display_->traits().can_wait_for_pictures && !options_.is_realtime &&
           settings_.wall.role == WallRole::alone;
}

std::chrono::nanoseconds Player::now() const {
    return is_paced_by_pictures() ? clock_.due() : wall_->now();
}

/// Draws one frame, or waits until one can be drawn.
void Player::tick() {
    wall_->follow_clocks(stages_->first().wall());
    const std::chrono::nanoseconds time = now();
    if (options_.duration && time >= *options_.duration) return loop_.quit();
    display_->hours().set_others_awake(wall_->others()->are_awake);
    display_->follow_display(options_.rehearsal ? options_.rehearsal->local_time() : std::nullopt, time);
    wall_->set_awake(display_->hours().is_awake(time));
    renew_stages(time);
    stages_->set_screens(display_->screens(), time);
    service_->look(time);
    if (!are_seen(*stages_)) return rest(time);
    if (time < clock_.due()) return tick_.arm(clock_.due() - time);
    const bool is_late = time > clock_.due() + 500'000'000ns / settings_.output.frame_rate;
    if (!can_draw(display_->screens(), is_late)) return tick_.arm(busy_pause);
    handle_input(time);
    look_at_files(time);
    sources_->update();
    const std::chrono::nanoseconds frame = wall_->is_shared() ? clock_.last_due(time) : time;
    wall_->direct(*stages_, display_->screens(), frame);
    stages_->show(frame, display_->renderer(), display_->has_old_picture() && time < old_picture_patience);
    wall_->speak(stages_->first().wall(), frame);
    play_sound(time);
    take_wall_picture(time);
    if (is_paced_by_pictures())
        clock_.advance_exactly();
    else if (display_->screens().empty())
        clock_.skip_to(time);
    else
        clock_.advance(time);
    tick_.arm(std::max(0ns, clock_.due() - now()));
}

/// Draws nothing. The other boxes of a wall hear that this one has no screen.
void Player::rest(std::chrono::nanoseconds time) {
    clock_.skip_to(time);
    handle_input(time);
    look_at_files(time);
    play_sound(time);
    wall_->direct(*stages_, {}, time);
    wall_->speak(stages_->first().wall(), time);
    tick_.arm(is_paced_by_pictures() ? 0s : std::chrono::nanoseconds(invisible_pause));
}

/// Handles the rehearsal's events first, then those of visitors. Each wakes panels that are off; they are not
/// meant for what nobody saw.
void Player::handle_input(std::chrono::nanoseconds time) {
    const bool is_seen = !display_->screens().empty();
    if (options_.rehearsal) {
        if (options_.rehearsal->advance(time)) files_->apply_filters();
        for (const InputEvent& event : options_.rehearsal->next_touches()) {
            display_->hours().wake(time);
            if (is_seen) first_seen(*stages_).handle_input(event);
        }
    }
    if (input_devices_->has_input()) display_->hours().wake(time);
    input_devices_->deliver_input(
        display_->screens(), wall_->start(),
        [this](const Screen& screen, InputEvent event) { stages_->handle_input(screen, event); });
}

void Player::look_at_files(std::chrono::nanoseconds time) {
    files_->look(time, EventLoop::Clock::now(), [this] {
        return content_of(*stages_, *sources_, display_->is_away() && !are_seen(*stages_));
    });
}

/// Updates the sound to the films now on the walls; silent while no wall is shown.
void Player::play_sound(std::chrono::nanoseconds time) {
    if (!sound_) return;
    sound_->follow(stages_->audible(), (wall_->start() + time).time_since_epoch());
    for (const SoundEvent& event : sound_->take_events())
        log::write(event.is_trouble ? log::Level::warning : log::Level::info, "sound: " + event.text);
}

/// Takes the picture of the first wall that is shown for the status page.
void Player::take_wall_picture(std::chrono::nanoseconds time) {
    const Stage& stage = first_seen(*stages_);
    if (!wall_picture_ || stage.screens().empty() || !wall_picture_->is_due(stage.frame(), time)) return;
    wall_picture_->write(picture_of(stage.frame(), WallPicture::max_side, *display_->renderer()));
}

/// Reads the settings again. @throws SettingsError; then the settings stay as they are
void Player::reload() {
    if (!options_.read_settings) return;
    SettingsChange change = settings_change(settings_, options_.read_settings());
    settings_ = std::move(change.settings);
    log::set_level(settings_.log.level);
    const auto list = [](const std::vector<std::string>& keys) {
        return keys.empty() ? "nothing" : fmt::format("{}", fmt::join(keys, ", "));
    };
    log::info("settings read again: {} changed now, {} will change after a restart", list(change.now),
              list(change.later));
    display_->hours().set_rules(panel_rules(settings_));
    if (change.are_walls_new) stages_->ask_anew();
}

/// Makes the walls anew if the settings ask for it.
void Player::renew_stages(std::chrono::nanoseconds time) {
    if (!stages_->claim_renewal(time)) return;
    for (const SourceId source : sources_->retire_all())
        display_->forget_source(source);
    stages_->make_anew();
    wall_->begin_anew();
    begin_stages();
}

void Player::finish() {
    service_->arrangements().end_run(settings_.input.keep_arrangement);
    files_->end_run();
    service::stopping();
    log::info("{} pictures shown, {} left out as too late; {} pictures of films were late", clock_.pictures(),
              clock_.late(), sources_->late());
    display_->finish();
}

}  // namespace vitrine::player
