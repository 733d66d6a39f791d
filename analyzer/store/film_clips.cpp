#include "analyzer/store/film_clips.hpp"

#include "analyzer/store/clip_reader.hpp"
#include "analyzer/store/clip_writer.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <exception>
#include <system_error>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

/// One pass through the film, from shot to shot.
class FilmClips::Pass {
  public:
    explicit Pass(FilmClips& clips) : clips_(clips), reader_(clips.film_, clips.form_) {}

    /// @return  false where the film has no more frames, or was given up
    bool make(const Shot& shot, const fs::path& file) {
        while (frame_.time < shot.begin)
            if (!advance()) return false;
        ClipWriter writer(file, frame_.sample.get(), clips_.place_.max_bytes);
        bool has_more = true;
        while (has_more && frame_.time < shot.end) {
            writer.push(frame_.sample.get(), frame_.time - shot.begin);
            has_more = advance();
        }
        if (clips_.is_stopped()) return false;
        writer.finish(shot.duration());
        return true;
    }

  private:
    bool advance() {
        if (clips_.is_stopped()) return false;
        std::optional<ClipFrame> next = reader_.next();
        if (next) frame_ = std::move(*next);
        return next.has_value();
    }

    FilmClips& clips_;  // outlives the pass
    ClipReader reader_;
    ClipFrame frame_{.sample = {}, .time = std::chrono::nanoseconds(-1)};
};

FilmClips::FilmClips(std::string film, const ClipForm& form, StorePlace place)
    : film_(std::move(film)), form_(form), place_(std::move(place)), thread_([this] { run(); }) {}

FilmClips::~FilmClips() {
    {
        const std::lock_guard lock(mutex_);
        is_stopped_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

void FilmClips::request_clip(const Shot& shot) {
    const std::lock_guard lock(mutex_);
    wanted_.push_back(shot);
    changed_.notify_all();
}

std::vector<Shot> FilmClips::take_made() {
    const std::lock_guard lock(mutex_);
    return std::exchange(made_, {});
}

void FilmClips::finish() {
    {
        const std::lock_guard lock(mutex_);
        is_finishing_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

bool FilmClips::is_stopped() {
    const std::lock_guard lock(mutex_);
    return is_stopped_;
}

std::optional<Shot> FilmClips::next_wanted() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return is_stopped_ || is_finishing_ || !wanted_.empty(); });
    if (is_stopped_ || wanted_.empty()) return std::nullopt;
    Shot shot = std::move(wanted_.front());
    wanted_.pop_front();
    return shot;
}

/// The thread's whole body. After an error the rest of the shots have no clip; the analysis decides what that
/// means.
void FilmClips::run() {
    try {
        fs::create_directories(place_.store / place_.id);
        std::optional<Pass> pass;
        while (std::optional<Shot> shot = next_wanted()) {
            if (!pass) pass.emplace(*this);
            make(*pass, std::move(*shot));
        }
    } catch (const std::exception& error) {
        log::debug("no further clips in '{}': {}", place_.id, error.what());
    }
}

void FilmClips::make(Pass& pass, Shot shot) {
    const std::string file =
        fmt::format("{}/{}-{}-{}.mp4", place_.id, shot.begin.count(), shot.end.count(), place_.clip_side);
    shot.stored = {.file = file, .width = form_.width, .height = form_.height};
    try {
        const bool is_there = fs::exists(place_.store / file);  // left by an analysis that was cut off
        if (!is_there && has_room(place_) && !pass.make(shot, place_.store / file)) return;
    } catch (const ClipError& error) {
        log::debug("no clip '{}': {}", file, error.what());
        if (error.why() == ClipError::Why::broken) return;
        shot.stored->is_dropped = error.why() == ClipError::Why::too_large;
    }
    const std::lock_guard lock(mutex_);
    made_.push_back(std::move(shot));
}

}  // namespace vitrine::analyzer
