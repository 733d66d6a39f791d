// Measures the active picture on real films and photos: as they are, where nothing may be cut off, and with
// bars of many sizes and colours drawn around them, which must be found. The drawn bars have the noise of a
// coder.

#include "analyzer/film/active_picture.hpp"
#include "analyzer/film/frame_reader.hpp"
#include "analyzer/one_file/analyze.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "base/state/media_error.hpp"
#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int analysis_side = 320;     // px, as films are analysed
constexpr double max_left = 0.004;     // share of the picture's side: what may be left of a bar
constexpr double max_cut_off = 0.025;  // share of the picture's side that may be cut off the picture
constexpr int max_frames = 1500;       // of a film
constexpr int jpeg_quality = 75;
constexpr int full_size = 3;  // the film's pictures are larger than those analysed; there they are coded

/// The bars drawn around a medium; shares of the picture's sides.
struct Bars {
    const char* name;
    double left, top, right, bottom;
    cv::Scalar colour;
    bool is_for_photos;
};

const std::array<Bars, 7> drawn_bars{{
    {"2.39 in 16:9", 0, .128, 0, .128, {16, 16, 16}, false},
    {"1.85 in 16:9", 0, .019, 0, .019, {0, 0, 0}, false},
    {"4:3 in 16:9", .125, 0, .125, 0, {0, 0, 0}, false},
    {"9:16 in 16:9", .3, 0, .3, 0, {2, 2, 2}, false},
    {"windowbox", .1, .1, .1, .1, {22, 20, 18}, false},
    {"scan, white", .04, .05, .05, .04, {244, 248, 250}, true},
    {"scan, black", .06, .04, .06, .05, {12, 10, 10}, true},
}};

/// The frames of a medium that are searched, and its shots.
struct Medium {
    std::string name;
    std::vector<FilmFrame> frames;
    std::vector<Shot> shots;
};

/// Keeps the frames that a source gives, five a second.
class KeepingSource : public FrameSource {
  public:
    KeepingSource(std::unique_ptr<FrameSource> source, std::vector<FilmFrame>& kept)
        : source_(std::move(source)), kept_(kept) {}

    const MediaInfo& info() const override { return source_->info(); }

    std::optional<FilmFrame> next() override {
        if (count_++ == max_frames) return std::nullopt;
        std::optional<FilmFrame> frame = source_->next();
        if (frame && (kept_.empty() || frame->time >= kept_.back().time + std::chrono::milliseconds(200)))
            kept_.push_back({.picture = frame->picture.clone(), .time = frame->time});
        return frame;
    }

  private:
    std::unique_ptr<FrameSource> source_;
    std::vector<FilmFrame>& kept_;  // outlives the source
    int count_ = 0;
};

Medium read_medium(const fs::path& file) {
    Medium medium{.name = file.filename().string(), .frames = {}, .shots = {}};
    AnalysisSettings settings;
    settings.face_cascade.clear();
    KeepingSource source(open_media(file.string(), analysis_side, {}), medium.frames);
    medium.shots = analyze(source, settings).shots;
    return medium;
}

cv::Mat with_bars(const cv::Mat& picture, const Bars& bars) {
    const int left = cvRound(bars.left * picture.cols), top = cvRound(bars.top * picture.rows);
    const cv::Rect active(left, top, picture.cols - left - cvRound(bars.right * picture.cols),
                          picture.rows - top - cvRound(bars.bottom * picture.rows));
    cv::Mat result(picture.size() * full_size, CV_8UC3, bars.colour), inner, seen;
    const cv::Rect full(active.tl() * full_size, active.size() * full_size);
    cv::resize(picture, inner, full.size(), 0, 0, cv::INTER_CUBIC);
    inner.copyTo(result(full));
    cv::resize(from_jpeg(to_jpeg(result, jpeg_quality)), seen, picture.size(), 0, 0, cv::INTER_AREA);
    return seen;
}

/// The shares of a picture's sides that its active part leaves out: left, top, right, bottom.
std::array<double, 4> left_out(const cv::Rect& active, cv::Size size) {
    const double width = size.width, height = size.height;
    return {active.x / width, active.y / height, 1 - active.br().x / width, 1 - active.br().y / height};
}

/// @param most  the largest shares that may be left out, but for max_cut_off
bool is_found(const std::array<double, 4>& out, const Bars& bars, const std::array<double, 4>& most) {
    const std::array drawn{bars.left, bars.top, bars.right, bars.bottom};
    for (std::size_t i = 0; i < out.size(); ++i)
        if (out[i] < drawn[i] - max_left || out[i] > most[i] + max_cut_off) return false;
    return true;
}

/// The bars of a medium that has some of its own, with others around it: at most so much may be left out.
std::array<double, 4> with_own(const Bars& bars, const std::array<double, 4>& own) {
    const double width = 1 - bars.left - bars.right, height = 1 - bars.top - bars.bottom;
    return {bars.left + own[0] * width, bars.top + own[1] * height, bars.right + own[2] * width,
            bars.bottom + own[3] * height};
}

/// True if the shot ends in the bars' colour at a side that has a bar, in all its pictures: there is no line.
bool hides(const std::vector<SideBands>& shot, const Bars& bars) {
    constexpr double alike = 24;     // largest difference of a channel: the bars have a coder's noise
    constexpr double min_row = .01;  // share of the side
    const std::array drawn{bars.left, bars.top, bars.right, bars.bottom};
    const auto is_alike = [&](const SideBand& band) {
        for (int channel = 0; channel < 3; ++channel)
            if (std::abs(band.colour[channel] - bars.colour[channel]) > alike) return false;
        return band.depth >= min_row * analysis_side;
    };
    for (std::size_t side = 0; side < drawn.size(); ++side)
        if (drawn[side] > 0 &&
            std::ranges::all_of(shot, [&](const SideBands& bands) { return is_alike(bands[side]); }))
            return true;
    return false;
}

struct Count {
    int shots = 0;
    int found = 0;
    int hidden = 0;  // not found, and there was no line to be found
};

/// The active picture of each shot. @param bars  drawn around it; null: none
std::vector<cv::Rect> active_pictures(const Medium& medium, const Bars* bars, cv::Size& size) {
    ActivePictureFinder finder;
    std::size_t frame = 0;
    for (const Shot& shot : medium.shots) {
        const auto end = std::max(shot.end, shot.begin + std::chrono::nanoseconds(1));
        for (; frame < medium.frames.size() && medium.frames[frame].time < end; ++frame) {
            const cv::Mat& picture = medium.frames[frame].picture;
            finder.add_picture(bars == nullptr ? picture : with_bars(picture, *bars),
                               medium.frames[frame].time);
        }
        finder.close_shot(shot.begin, end);
    }
    size = finder.whole().size();
    return finder.all_shots();
}

/// The bands of a shot's pictures as they are.
std::vector<SideBands> bands_of(const Medium& medium, const Shot& shot) {
    std::vector<SideBands> bands;
    for (const FilmFrame& frame : medium.frames)
        if (frame.time >= shot.begin && frame.time <= shot.end) bands.push_back(side_bands(frame.picture));
    return bands;
}

/// Counts the shots of a medium whose bars were found; without bars, those of which something was cut off.
Count count_shots(const Medium& medium, const Bars* bars, bool is_verbose) {
    cv::Size size;
    const std::vector<cv::Rect> own = active_pictures(medium, nullptr, size);
    const std::vector<cv::Rect> all = bars == nullptr ? own : active_pictures(medium, bars, size);
    Count count;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto out = left_out(all[i], size);
        const bool is_hit = bars == nullptr ? all[i].size() != size
                                            : is_found(out, *bars, with_own(*bars, left_out(own[i], size)));
        ++count.shots;
        count.found += is_hit ? 1 : 0;
        if (is_hit != (bars == nullptr)) continue;
        const Shot& shot = medium.shots[i];
        const bool is_hidden = bars != nullptr && hides(bands_of(medium, shot), *bars);
        count.hidden += is_hidden ? 1 : 0;
        if (!is_verbose) continue;
        fmt::print("  {} at {:.1f} s, {}: {:.3f} {:.3f} {:.3f} {:.3f}{}\n", medium.name,
                   std::chrono::duration<double>(shot.begin).count(),
                   bars == nullptr ? "as it is" : bars->name, out[0], out[1], out[2], out[3],
                   is_hidden ? ", of the bars' colour itself" : "");
    }
    return count;
}

std::vector<fs::path> files_in(const fs::path& media, std::initializer_list<const char*> folders) {
    std::set<fs::path> files;
    for (const char* folder : folders)
        if (fs::is_directory(media / folder))
            for (const fs::directory_entry& entry : fs::directory_iterator(media / folder))
                if (entry.is_regular_file()) files.insert(entry.path());
    return {files.begin(), files.end()};
}

std::vector<Medium> read_media(const std::vector<fs::path>& files) {
    std::vector<Medium> media;
    for (const fs::path& file : files) {
        try {
            media.push_back(read_medium(file));
        } catch (const MediaError&) {  // not a medium
        }
    }
    return media;
}

void print_count(const char* name, const std::vector<Medium>& media, const Bars* bars, bool is_verbose) {
    Count all;
    for (const Medium& medium : media) {
        const Count count = count_shots(medium, bars, is_verbose);
        all = {all.shots + count.shots, all.found + count.found, all.hidden + count.hidden};
    }
    const int seen = all.shots - all.hidden;
    fmt::print("{:<24} {:>6} {:>6} {:>6} {:>8} {:>8.3f}\n", name, media.size(), all.shots, all.found,
               all.hidden, seen > 0 ? static_cast<double>(all.found) / seen : 0.0);
}

}  // namespace

void bars_table(const TableInput& input) {
    fmt::print(
        "\nbars: shots of films and photos whose bars are found; without bars, that were cut. Shares are "
        "of those with a line to be found\n{:<24} {:>6} {:>6} {:>6} {:>8} {:>8}\n",
        "", "media", "shots", "found", "no line", "share");
    const auto print_all = [&](const std::vector<Medium>& films, const std::vector<Medium>& photos) {
        print_count("films as they are", films, nullptr, input.is_verbose);
        print_count("photos as they are", photos, nullptr, input.is_verbose);
        for (const Bars& bars : drawn_bars)
            print_count(bars.name, bars.is_for_photos ? photos : films, &bars, input.is_verbose);
    };
    print_all(read_media(files_in(input.media, {"single", "edited", "composites"})),
              read_media(files_in(input.media, {"photos"})));
    fmt::print("kept back for judging: nothing was fitted to these\n");
    print_all(read_media(files_in(input.media, {"codecs"})),
              read_media(files_in(input.media, {"formats", "orientation"})));
}

}  // namespace vitrine::analyzer
