#include "player/stage/tapestry_playback.hpp"

#include "base/hints/keyframe_choice.hpp"
#include "base/state/keyframe_notes.hpp"
#include "base/state/wanted_tapestry.hpp"
#include "base/system/log.hpp"
#include "player/scene/tapestry/kept_frames.hpp"
#include "player/scene/tapestry/unwoven_tapestry.hpp"

#include <array>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace vitrine::player {

namespace {

constexpr int tile_bits = 32;        // bits of a tile's number below its level
constexpr int generation_bits = 48;  // and below the generation of its tapestry
/// A tapestry's height in bricks: it has two rows, three quarters of a brick apart.
constexpr double rows_of_bricks = 1.5;
constexpr std::array<std::byte, 4> white{std::byte{255}, std::byte{255}, std::byte{255}, std::byte{255}};

/// The number by which the loader knows a tile.
std::uint64_t number_of(const TileId& tile, unsigned generation) {
    return (std::uint64_t{generation} << generation_bits) + (std::uint64_t{tile.level} << tile_bits) +
           static_cast<std::uint64_t>(tile.tile);
}

TileId tile_of(std::uint64_t number) {
    return {(number >> tile_bits) & 0xffff, static_cast<int>(number & 0xffffffff)};
}

unsigned generation_of(std::uint64_t number) {
    return static_cast<unsigned>(number >> generation_bits);
}

/// The film of a tapestry as its record has it. Without a record, its picture has the shape of a brick.
/// The path is that of the record, because the film may have moved since the tapestry was woven.
PreviewedFilm film_of(const Tapestry& tapestry, const RecordList::Record& record) {
    PreviewedFilm film{
        .path = tapestry.path,
        .duration = tapestry.duration,
        .picture = {static_cast<double>(tapestry.brick_width), tapestry.height / rows_of_bricks},
        .shots = {}};
    if (!record) return film;
    const Box active = active_picture(*record);
    film.path = record->path;
    film.picture = active.max - active.min;
    film.active = {{active.min.x / record->width, active.min.y / record->height},
                   {active.max.x / record->width, active.max.y / record->height}};
    film.shots = record->shots;
    return film;
}

/// The tapestry to begin with.
Tapestry first_tapestry(const std::filesystem::path& directory, const TapestryPlaybackOptions& options) {
    if (!options.awaits_index) {
        Tapestry tapestry = read_tapestry(directory);
        if (tapestry.levels.empty())
            throw std::runtime_error("'" + directory.string() + "' has no level yet");
        return tapestry;
    }
    const MediaRecord& film = *options.film;
    const Box active = active_picture(film);
    Tapestry tapestry = unwoven_tapestry(film.duration, active.max - active.min);
    tapestry.path = film.path;
    tapestry.bytes = film.bytes;
    tapestry.mtime_ns = film.mtime_ns;
    return tapestry;
}

/// Tells if the same pictures are shown by both.
bool shows_the_same(const Tapestry& a, const Tapestry& b) {
    return a.folder == b.folder && a.levels.size() == b.levels.size() &&
           a.kept.times.size() == b.kept.times.size() && a.digits.width == b.digits.width;
}

NewerIndex followed_index(const std::filesystem::path& directory, const TapestryPlaybackOptions& options) {
    NewerIndex index(directory);
    if (!options.awaits_index) index.pass_over();
    return index;
}

/// The keyframes that were chosen by touch before.
KeyframeChoice noted_choice(const std::filesystem::path& state, const std::string& path) {
    const KeyframeNotes notes = read_keyframe_notes(state);
    const auto note = notes.find(path);
    return note == notes.end() ? KeyframeChoice{}
                               : read_keyframe_choice(note->second, keyframe_notes_file).choice;
}

TapestryShow show_of(const std::filesystem::path& directory, const TapestryRoom& room,
                     const TapestryPlaybackOptions& options) {
    Tapestry tapestry = first_tapestry(directory, options);
    TapestrySettings settings{.first_source = options.first_source,
                              .patience = options.patience,
                              .plays_at_once = !options.follows,
                              .first_seen = options.first_seen};
    if (options.edits_keyframes) settings.edited = noted_choice(options.wishes_in, options.film->path);
    if (options.rests) settings.pace.patience = std::chrono::nanoseconds::max();
    PreviewedFilm film = film_of(tapestry, options.film);
    return {std::move(tapestry), std::move(film), room, settings};
}

std::shared_ptr<const ZoomMesh> mesh_of(const std::optional<ZoomField>& field, double left,
                                        bool is_to_finer) {
    if (!field) return nullptr;
    return std::make_shared<const ZoomMesh>(zoom_mesh(*field, left, is_to_finer));
}

}  // namespace

TapestryWish::TapestryWish(std::filesystem::path state, std::string path)
    : state_(std::move(state)), path_(std::move(path)) {
    try {
        want_tapestry(state_, path_);
    } catch (const std::system_error& error) {
        log::warning("the analyzer does not hear of a visitor's wish: {}", error.what());
    }
}

TapestryWish::~TapestryWish() {
    withdraw_wish(state_, path_);
}

bool is_woven_from(const Tapestry& tapestry, const MediaRecord& film) {
    return tapestry.bytes == film.bytes && tapestry.mtime_ns == film.mtime_ns;
}

TapestryPlayback::TapestryPlayback(std::filesystem::path directory, const TapestryRoom& room,
                                   const TapestryPlaybackOptions& options)
    : directory_(std::move(directory)),
      state_(options.wishes_in),
      awaits_tiles_(options.awaits_tiles),
      film_(options.film),
      index_(followed_index(directory_, options)),
      show_(show_of(directory_, room, options)) {
    if (film_ && !state_.empty() && !show_.tapestry().is_complete) wish_.emplace(state_, film_->path);
}

void TapestryPlayback::set_catalogue(const RecordList& records) {
    const RecordList::Record film = records.find(show_.film().path);
    const bool is_known = film && is_woven_from(show_.tapestry(), *film);
    if (!is_known && !film_) return;
    if (!is_known) return show_.end();
    film_ = film;
    show_.set_film(film_of(show_.tapestry(), film));
}

/// A newer index of the same film is shown as soon as its tiles are there, one after another.
void TapestryPlayback::take_newer_index(std::chrono::nanoseconds now) {
    if (show_.strips().coming()) return;
    std::optional<Tapestry> newer = index_.take(now);
    const Tapestry& shown = show_.tapestry();
    if (!newer || newer->bytes != shown.bytes || newer->mtime_ns != shown.mtime_ns) return;
    if (newer->is_complete) wish_.reset();
    if (shows_the_same(*newer, shown)) return;
    const auto waited = std::chrono::duration_cast<std::chrono::milliseconds>(now - *opened_);
    if (is_unwoven(shown))
        log::info("first view of the tapestry of '{}' after {} ms", show_.film().path, waited.count());
    else
        log::debug("newer tapestry of '{}': {}, {} levels", show_.film().path, newer->folder,
                   newer->levels.size());
    show_.strips().take_over(std::move(*newer));
}

void TapestryPlayback::follow(const TapestryMoment& seen) {
    followed_ = seen;
    show_.set_room(seen.room);
}

void TapestryPlayback::end_waiting(std::chrono::nanoseconds now) {
    const bool waits = is_unwoven(show_.tapestry()) && !show_.strips().coming() && !show_.is_over();
    if (!waits || followed_ || now - *opened_ < max_wait) return;
    log::info("no tapestry of '{}' within {} s: the analyzer does not run, or needs longer",
              show_.film().path, max_wait.count());
    show_.end();
}

/// The film is woven anew at once, as a technician waits for it.
void TapestryPlayback::hand_over_choice() {
    const std::optional<KeyframeChoice> choice = show_.take_choice();
    if (!choice) return;
    const std::string& path = show_.film().path;
    try {
        write_keyframe_note(state_, path, to_toml(*choice));
    } catch (const std::runtime_error& error) {
        return log::warning("the keyframes chosen for '{}' are not kept: {}", path, error.what());
    }
    log::info("keyframes of '{}' by touch: {}", path,
              choice->is_empty() ? "none chosen, none struck" : in_words(*choice));
    wish_.emplace(state_, path);
}

WallStep TapestryPlayback::step(std::chrono::nanoseconds now, Renderer* renderer) {
    if (!opened_) opened_ = now;
    take_newer_index(now);
    end_waiting(now);
    hand_over_choice();
    if (renderer != nullptr && !std::exchange(has_mark_, true))
        renderer->upload(show_.sources().mark(),
                         {.width = 1, .height = 1, .stride = white.size(), .pixels = white});
    const TapestryMoment* const followed = followed_ ? &*followed_ : nullptr;
    TapestryStep step = show_.step(now, followed);
    WallStep done{.requests = std::move(step.requests), .retired = std::move(step.retired)};
    if (give_tiles(step, renderer) && awaits_tiles_) {
        step = show_.step(now, followed);
        done.retired.insert(done.retired.end(), step.retired.begin(), step.retired.end());
    }
    done.frame = std::move(step.frame);
    seen_ = std::move(step.seen);
    seen_.opened = *opened_;
    return done;
}

/// Gives tiles that have been read to the renderer. True: at least one.
bool TapestryPlayback::give_tiles(const TapestryStep& step, Renderer* renderer) {
    std::vector<TileFile> wanted;
    if (const std::optional<ComingStrip>& coming = show_.strips().coming())
        add_files(coming->strip(), step.coming, wanted);
    add_files(show_.strips().shown(), step.missing, wanted);
    if (awaits_tiles_) {
        for (const TileFile& file : wanted)
            give(load_tile(file), renderer);
        return !wanted.empty();
    }
    const std::vector<LoadedTile> loaded = loader_.take(max_uploads);
    for (const LoadedTile& tile : loaded)
        give(tile, renderer);
    std::vector<std::uint64_t> numbers;
    numbers.reserve(wanted.size());
    for (const TileFile& file : wanted)
        numbers.push_back(file.number);
    if (numbers != asked_) loader_.want(std::move(wanted));
    asked_ = std::move(numbers);
    return !loaded.empty();
}

void TapestryPlayback::add_files(const TapestryStrip& strip, const std::vector<TileId>& tiles,
                                 std::vector<TileFile>& files) const {
    const Tapestry& tapestry = strip.tapestry();
    const auto zoom = [&](const TileId& tile, bool is_to_finer) {
        const std::size_t finer = tile.level + (is_to_finer ? 1 : 0);
        if (finer >= tapestry.levels.size() || !tapestry.levels[finer].has_zoom) return std::string();
        return (directory_ / tapestry.zoom_name(tile.level, tile.tile, is_to_finer)).string();
    };
    for (const TileId& tile : tiles) {
        const std::uint64_t number = number_of(tile, strip.sources().generation);
        if (!unreadable_.contains(number))
            files.push_back({.number = number,
                             .file = (directory_ / file_of(tapestry, tile)).string(),
                             .to_coarser = zoom(tile, false),
                             .to_finer = zoom(tile, true)});
    }
}

/// A tapestry that is to come and has no such tile any more has been replaced: the next one is awaited.
void TapestryPlayback::give(const LoadedTile& loaded, Renderer* renderer) {
    const TileId tile = tile_of(loaded.number);
    const unsigned generation = generation_of(loaded.number);
    const TapestryStrip* const strip = show_.strips().find(generation);
    if (strip == nullptr) return;
    if (loaded.sample.pixels.empty()) {
        unreadable_.insert(loaded.number);
        log::warning("tile {} of level {} of '{}' cannot be read", tile.tile, tile.level,
                     directory_.string());
        if (strip != &show_.strips().shown()) show_.strips().drop_coming();
        return;
    }
    if (renderer != nullptr) renderer->upload(strip->sources().tile(tile), loaded.sample);
    const double left = static_cast<double>(tile.tile) * strip->tapestry().tile_width;
    show_.strips().add(generation, tile,
                       {.to_coarser = mesh_of(loaded.to_coarser, left, false),
                        .to_finer = mesh_of(loaded.to_finer, left, true)});
}

void TapestryPlayback::forget_uploads() {
    has_mark_ = false;
    show_.strips().forget_tiles();
}

}  // namespace vitrine::player
