#include "analyzer/weave_file.hpp"

#include "analyzer/saliency/faces.hpp"
#include "analyzer/video/frame_reader.hpp"
#include "analyzer/weave/film_weave.hpp"
#include "analyzer/weave/picture_file.hpp"
#include "analyzer/weave/threads.hpp"
#include "base/catalogue/media_error.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/error.hpp"

#include <sys/stat.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace vitrine {

namespace fs = std::filesystem;

namespace {

constexpr double most_seconds = 1e6;  // of a chosen time

/// Seconds, one a line; empty lines and what follows a # count nothing.
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
        if (*end != '\0' || !(seconds >= 0 && seconds <= most_seconds) || words >> word)
            throw std::runtime_error(
                fmt::format("'{}' line {}: '{}' is no time in seconds", file.string(), number, line));
        times.emplace_back(std::llround(seconds * 1e9));
    }
    if (times.empty()) throw std::runtime_error(fmt::format("'{}': no times in it", file.string()));
    return times;
}

Film film_of(const WeaveRequest& request, const Settings& settings, const fs::path& directory) {
    try {
        const std::unique_ptr<FrameSource> source =
            open_media(request.file.string(), settings.analyzer.frame_size);
        if (source->info().kind == MediaKind::photo)
            throw MediaError(MediaState::unsupported, "a photo has no tapestry");
        const auto faces = face_detector(settings.analyzer.face_model, settings.analyzer.face_cascade);
        return gathered(*source, directory, faces.get());
    } catch (const MediaError& error) {
        throw std::runtime_error(fmt::format("'{}': {}", request.file.string(), error.what()));
    }
}

Tapestry named(const fs::path& file) {
    struct stat status {};

    if (::stat(file.c_str(), &status) < 0) throw_errno("look at '{}'", file.string());
    return {.path = file.filename().string(),
            .bytes = static_cast<std::uint64_t>(status.st_size),
            .mtime_ns = std::int64_t{status.st_mtim.tv_sec} * 1'000'000'000 + status.st_mtim.tv_nsec};
}

}  // namespace

std::string weave_file(const WeaveRequest& request, const Settings& settings) {
    const Tapestry head = named(request.file);
    WeaveChoice choice{.most_levels = request.levels, .is_uniform = request.is_uniform, .times = {}};
    if (!request.times.empty()) choice.times = times_in(request.times);
    const fs::path directory =
        request.directory.empty() ? fs::absolute(request.sheet).parent_path() : request.directory;
    fs::create_directories(directory);
    const RunTasks run = threaded(static_cast<int>(std::thread::hardware_concurrency()));
    const Film film = film_of(request, settings, directory);
    const std::vector<Keyframes> levels = chosen_keyframes(*film.candidates, choice, run);
    if (!request.sheet.empty()) write_png(request.sheet, drawn_weave(film, levels, {}, run));
    if (!request.directory.empty()) write_pyramid(directory, head, film, levels, {}, run);
    return fmt::format("{} levels, {} to {} keyframes", levels.size(), levels.front().size(),
                       levels.back().size());
}

}  // namespace vitrine
