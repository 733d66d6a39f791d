#include "analyzer/tapestry/weave_file.hpp"

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/film/media_file.hpp"
#include "analyzer/film/reader_sandbox.hpp"
#include "analyzer/lettering/font_places.hpp"
#include "analyzer/models/model_file.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/tapestry/export/page_data.hpp"
#include "analyzer/tapestry/export/page_folder.hpp"
#include "analyzer/tapestry/export/small_film.hpp"
#include "analyzer/tapestry/weave/film_weave.hpp"
#include "analyzer/tapestry/weave/first_view.hpp"
#include "analyzer/tapestry/weave/kept_frames.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "analyzer/tapestry/weave/poster.hpp"
#include "analyzer/tapestry/weave/sharp_frames.hpp"
#include "analyzer/tapestry/weave/threads.hpp"
#include "analyzer/tapestry/weave/woven_sheet.hpp"
#include "analyzer/tapestry/weave/zoom_sheet.hpp"
#include "base/state/media_error.hpp"
#include "base/state/screen_note.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>
#include <utility>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr double max_chosen_seconds = 1e6;  // the largest time that may be chosen
constexpr std::size_t max_choice_bytes = 1U << 16;
constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

/// Reads times in seconds, one a line. Empty lines and text behind a # do not count.
std::vector<std::chrono::nanoseconds> times_in(const fs::path& file) {
    std::istringstream lines(read_file(file));
    std::vector<std::chrono::nanoseconds> times;
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::string word;
        if (!(words >> word)) continue;
        char* end = nullptr;
        const double seconds = std::strtod(word.c_str(), &end);
        if (*end != '\0' || !(seconds >= 0 && seconds <= max_chosen_seconds) || words >> word)
            throw std::runtime_error(
                fmt::format("'{}' line {}: '{}' is not a time in seconds", file.string(), number, line));
        times.emplace_back(std::llround(seconds * 1e9));
    }
    if (times.empty()) throw std::runtime_error(fmt::format("'{}': it holds no times", file.string()));
    return times;
}

/// @throws std::runtime_error naming the first line with a fault
KeyframeChoice choice_in(const fs::path& file) {
    KeyframeFile read = read_keyframe_choice(read_file(file, max_choice_bytes), file.string());
    if (!read.faults.empty()) throw std::runtime_error(read.faults.front());
    return std::move(read.choice);
}

/// @param size  px, longest side of the frames
std::unique_ptr<FrameSource> opened(const MediaFile& file, int size) {
    std::unique_ptr<FrameSource> source = open_media(file.name(), size);
    if (source->info().kind == MediaKind::photo)
        throw MediaError(MediaState::unsupported, "a photo has no tapestry");
    return source;
}

/// The height of bricks with which a tapestry is as tall as the settings want it, or as the strip on the
/// largest screen needs.
int wanted_brick_height(const Settings& settings) {
    constexpr int usual_side = 1920;         // px, of a screen that is not known
    constexpr double shape = 9.0 / 16;       // of a screen
    constexpr double strip_share = 0.31;     // of its height
    constexpr double max_enlargement = 1.2;  // of the tapestry on it
    constexpr int max_height = 600;          // px
    double height = settings.tapestry.height;
    if (height == 0) {
        const int noted = noted_screen_side(settings.state.directory);
        height = (noted > 0 ? noted : usual_side) * shape * strip_share / max_enlargement;
    }
    return static_cast<int>(std::lround(std::min<double>(height, max_height) / 2 / kept_height));
}

/// A tapestry of the file, still without levels. @param name  as the person gave it
Tapestry begun_tapestry(const MediaFile& file, const fs::path& name) {
    return {.path = file.path() == name.string() ? name.filename().string() : file.path(),
            .bytes = file.bytes(),
            .mtime_ns = file.mtime_ns()};
}

/// Says if a folder has an index of the same content as `head`.
bool has_index(const fs::path& directory, const Tapestry& head) {
    std::error_code error;
    if (!fs::exists(directory / "index.json", error)) return false;
    try {
        const Tapestry index = read_tapestry(directory);
        return index.bytes == head.bytes && index.mtime_ns == head.mtime_ns;
    } catch (const std::runtime_error&) {  // loading one record: it is written anew
        return false;
    }
}

/// One weaving, with all that it needs.
class Weaving {
  public:
    Weaving(const WeaveRequest& request, const Settings& settings)
        : request_(request),
          settings_(settings),
          file_(request.file, settings.media.root),
          head_(begun_tapestry(file_, request.file)),
          content_{.bytes = head_.bytes, .mtime_ns = head_.mtime_ns},
          choice_{.max_levels = request.levels, .is_uniform = request.is_uniform},
          pyramid_{.retarget = {}, .max_bytes = request.max_bytes},
          brick_height_(wanted_brick_height(settings)),
          run_(threaded(request.threads > 0 ? request.threads
                                            : static_cast<int>(std::thread::hardware_concurrency()))) {
        if (!request.times.empty())
            choice_.chosen = {.keyframes = times_in(request.times), .struck = {}, .is_only = true};
        if (!request.keyframes.empty()) choice_.chosen = choice_in(request.keyframes);
        head_.choice = key_of(choice_.chosen);
        if (!request.html.empty()) {
            page_.emplace(request.html);
            require_film_encoder();
        }
        const Settings::Analyzer& models = settings.analyzer;
        faces_ =
            face_detector(find_model(models.face_model, Settings{}.analyzer.face_model), models.face_cascade);
    }

    /// Lets the process read the film and write the result, and nothing else.
    void enter_sandbox() const {
        ReaderNeeds needs{.libraries = font_places()};
        for (const fs::path& folder : {request_.directory, request_.html})
            if (!folder.empty()) needs.folders.push_back(folder);
        for (const fs::path& sheet : {request_.sheet, request_.zoom, request_.poster})
            if (!sheet.empty()) needs.folders.push_back(fs::absolute(sheet).parent_path());
        enter_reader_sandbox(file_, needs);
    }

    std::string once() {
        const Film film = watched();
        const std::vector<Keyframes> levels = chosen_keyframes(*film.candidates, choice_, run_);
        if (!request_.sheet.empty()) write_png(request_.sheet, drawn_weave(film, levels, {}, run_));
        if (!request_.zoom.empty()) draw_zoom(film, levels);
        if (!request_.directory.empty()) write_pyramid(film, levels, request_.directory);
        if (page_) write_page(film, levels);
        return in_words(levels) + (request_.poster.empty() ? "" : write_poster(film, levels.front()));
    }

    /// Weaves so that it can be interrupted: frames, plan and tiles stay in the folder until the tapestry is
    /// complete.
    std::string on() {
        const fs::path& directory = request_.directory;
        fs::create_directories(directory);
        const Film film = kept_film();
        std::optional<WeavePlan> plan = read_plan(directory, subject(), film.candidates->signatures().size());
        if (!plan) plan = new_plan(film);
        const std::optional<SharpFrames> size = sharp_frames(*film.candidates, brick_height_);
        PyramidSettings first = pyramid_;
        first.is_last = !size;
        if (size) first.retarget.quality = TileQuality::on_demand;
        PyramidWriter(directory, film, first, run_).write(head_, *plan);
        if (size) sharpen(film, *plan, *size);
        remove_plan(directory);
        remove_kept_frames(directory);
        return in_words(plan->levels);
    }

  private:
    static std::string in_words(const std::vector<Keyframes>& levels) {
        return fmt::format("{} levels, {} to {} keyframes", levels.size(), levels.front().size(),
                           levels.back().size());
    }

    /// The film's frames. What is no film is told before a folder is made.
    Film watched() const {
        const std::unique_ptr<FrameSource> source = opened(file_, settings_.analyzer.frame_size);
        fs::create_directories(work_folder());
        return gathered(*source, work_folder(), faces_.get());
    }

    /// A folder in which the result comes to lie, for files without a name.
    fs::path work_folder() const {
        for (const fs::path& folder : {request_.directory, request_.html})
            if (!folder.empty()) return folder;
        return fs::absolute(request_.result()).parent_path();
    }

    /// Chooses the keyframes. Before, which may take a while, there is a first view, unless the film has a
    /// tapestry already.
    WeavePlan new_plan(const Film& film) const {
        const fs::path& directory = request_.directory;
        WeavePlan plan{.folder = new_tile_folder(directory), .levels = {}};
        if (!has_index(directory, head_))
            write_first_view(directory, head_, plan.folder + first_suffix, film, choice_.chosen);
        plan.levels = chosen_keyframes(*film.candidates, choice_, run_);
        write_plan(directory, subject(), plan);
        return plan;
    }

    PlanSubject subject() const { return {.content = content_, .choice = head_.choice}; }

    void write_pyramid(const Film& film, const std::vector<Keyframes>& levels,
                       const fs::path& directory) const {
        const WeavePlan plan{.folder = new_tile_folder(directory), .levels = levels};
        const std::optional<SharpFrames> size = sharp_frames(*film.candidates, brick_height_);
        if (!size) {
            (void)PyramidWriter(directory, film, pyramid_, run_).write(head_, plan);
            return;
        }
        const Film sharp = read_again(film, levels.back(), *size);
        (void)PyramidWriter(directory, sharp, pyramid_, run_)
            .write(head_, {.folder = plan.folder, .levels = sharp_levels(levels)});
    }

    /// The keyframes of a level, larger.
    Film read_again(const Film& film, const Keyframes& level, const SharpFrames& size) const {
        CandidateWriter writer(nameless_file(work_folder()), CandidateWriter::two_hours, size.brick_height);
        read_sharp_frames(*opened(file_, size.frame_size), *film.candidates, level,
                          [&](const FilmFrame& frame) { writer.push(frame); });
        const cv::Rect active = active_in(*film.candidates, writer.frame());
        return film_of(writer.finish(record_of(film), {}, active), faces_.get());
    }

    /// Writes the page from a tapestry that is woven already, or from one that goes with its making.
    void write_page(const Film& film, const std::vector<Keyframes>& levels) {
        const fs::path& data = page_->begin();
        const fs::path own = data / "woven";
        if (request_.directory.empty()) write_pyramid(film, levels, own);
        const MediaInfo info = opened(file_, settings_.analyzer.frame_size)->info();
        const SmallFilmSize size = write_small_film(file_.name(), info, film.duration, data / page_film_name);
        write_page_data(
            request_.directory.empty() ? own : request_.directory,
            {.name = request_.file.filename().string(), .width = size.width, .height = size.height}, data);
        fs::remove_all(own);
        page_->publish();
    }

    /// @return  the poster in words for the log
    std::string write_poster(const Film& film, const Keyframes& level) const {
        const SharpFrames size = poster_frames(*film.candidates, request_.poster_height, level.size());
        const Film sharp = read_again(film, level, size);
        const Poster poster =
            drawn_poster(sharp, sharp_levels({level}).front(), request_.poster_height, run_);
        write_png(request_.poster, poster.picture);
        std::string words = fmt::format("; a poster of {} keyframes, {} x {} px", level.size(),
                                        poster.picture.cols, poster.picture.rows);
        if (poster.enlargement > 1)
            words += fmt::format("; the film's picture is {} px tall, so it is enlarged {:.2f} times",
                                 size.brick_height, poster.enlargement);
        return words;
    }

    /// Weaves the film again beside its first tapestry, in high quality, and puts the result in its place. An
    /// interrupted weaving goes on. Where there is no room for larger frames the kept ones serve.
    void sharpen(const Film& film, const WeavePlan& plan, const SharpFrames& size) const {
        const fs::path& directory = request_.directory;
        const fs::path beside = directory / "sharp";  // its frames and index
        const std::string folder = plan.folder + sharp_suffix;
        std::optional<Film> sharp = sharp_film(film, plan);
        if (!sharp) {
            fs::remove_all(beside);
            fs::remove_all(directory / folder);
            keep_sharp_frames(film, plan, size);
            sharp = sharp_film(film, plan);
        }
        fs::create_directories(beside);
        PyramidSettings settings = pyramid_;
        settings.index = beside;
        (void)PyramidWriter(directory, sharp ? *sharp : film, settings, run_)
            .write(head_, {.folder = folder, .levels = sharp ? sharp_levels(plan.levels) : plan.levels});
        replace_tapestry(directory, beside);
    }

    void keep_sharp_frames(const Film& film, const WeavePlan& plan, const SharpFrames& size) const {
        KeptFrames frames(request_.directory / "sharp",
                          request_.max_bytes > 0 ? request_.max_bytes : no_limit, size.brick_height);
        read_sharp_frames(*opened(file_, size.frame_size), *film.candidates, plan.levels.back(),
                          [&](const FilmFrame& frame) { frames.saw(frame); });
        if (!frames.frame().empty())
            frames.finish(record_of(film), content_, active_in(*film.candidates, frames.frame()));
    }

    /// The larger frames that were kept, where they are those of the plan.
    std::optional<Film> sharp_film(const Film& film, const WeavePlan& plan) const {
        std::optional<Film> sharp = film_in(request_.directory / "sharp");
        if (!sharp || !are_frames_of(*sharp->candidates, *film.candidates, plan.levels.back()))
            return std::nullopt;
        return sharp;
    }

    /// The film's record, with its duration as the frames tell it.
    static MediaRecord record_of(const Film& film) {
        MediaRecord record = film.candidates->film();
        record.duration = film.duration;
        return record;
    }

    void draw_zoom(const Film& film, const std::vector<Keyframes>& levels) const {
        if (levels.size() < 2)
            throw std::runtime_error(
                fmt::format("'{}': no zoom, because it has one level only", request_.file.string()));
        write_png(request_.zoom, drawn_zoom(woven_pair(film, levels, {}, run_), run_));
    }

    /// The frames kept in a folder, where they are those of the film.
    std::optional<Film> film_in(const fs::path& folder) const {
        std::optional<UniqueFd> frames = kept_frames(folder);
        if (!frames) return std::nullopt;
        try {
            Film film = film_of(std::move(*frames), faces_.get());
            if (film.candidates->content() == content_) return film;
        } catch (const std::runtime_error& error) {  // loading one record
            log::debug("frames of '{}' unreadable, ignoring: {}", request_.file.string(), error.what());
        }
        return std::nullopt;
    }

    Film kept_film() {
        if (auto film = film_in(request_.directory)) return std::move(*film);
        const auto source = opened(file_, settings_.analyzer.frame_size);
        KeptFrames frames(request_.directory, request_.max_bytes > 0 ? request_.max_bytes : no_limit);
        const MediaRecord film = watched_film(*source, [&](const FilmFrame& frame) { frames.saw(frame); });
        frames.finish(film, content_);
        if (auto film = film_in(request_.directory)) return std::move(*film);
        throw std::runtime_error(fmt::format("'{}': no room for its frames in '{}'", request_.file.string(),
                                             request_.directory.string()));
    }

    const WeaveRequest& request_;  // both outlive this
    const Settings& settings_;
    MediaFile file_;
    Tapestry head_;
    FilmContent content_;
    WeaveChoice choice_;
    PyramidSettings pyramid_;
    int brick_height_;  // px, wanted
    RunTasks run_;
    std::unique_ptr<FaceDetector> faces_;
    std::optional<PageFolder> page_;  // none: no page is asked for
};

}  // namespace

std::string weave_file(const WeaveRequest& request, const Settings& settings) {
    try {
        Weaving weaving(request, settings);
        if (request.is_alone) weaving.enter_sandbox();
        return request.resumes ? weaving.on() : weaving.once();
    } catch (const MediaError& error) {
        throw std::runtime_error(fmt::format("'{}': {}", request.file.string(), error.what()));
    }
}

}  // namespace vitrine::analyzer
