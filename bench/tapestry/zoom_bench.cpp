// Measures the cost and the quality of the zoom between two levels of a film's tapestry, bent by a flow and
// synthesised, in processor time.
//   zoom_bench FILM... [--pictures DIR]

#include "analyzer/film/frame_reader.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/tapestry/weave/picture_file.hpp"
#include "analyzer/tapestry/weave/strip_zoom.hpp"
#include "bench/tapestry/measures.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <filesystem>

namespace vitrine::analyzer {
namespace {

cv::Mat bent_to(const ZoomWarp& warp, const cv::Mat& picture, int width, double share, double there) {
    return bent(picture, warp.places({0, width}, share, there));
}

/// Grey levels.
double mean_difference(const cv::Mat& a, const cv::Mat& b) {
    cv::Mat difference;
    cv::absdiff(a, b, difference);
    const cv::Scalar means = cv::mean(difference);
    return (means[0] + means[1] + means[2]) / 3;
}

/// The difference between pictures and the mean of their neighbours, both bent to the picture's moment: mean
/// grey levels. An even change counts nothing.
double flicker(const StripZoom& zoom, const ZoomPictures& strips) {
    double sum = 0;
    const double step = 1.0 / static_cast<double>(strips.size() - 1);
    for (std::size_t i = 1; i + 1 < strips.size(); ++i) {
        const double share = static_cast<double>(i) * step;
        const int width = strips[i].cols;
        cv::Mat mean;
        cv::addWeighted(bent_to(zoom.fine(), strips[i - 1], width, share, share - step), 0.5,
                        bent_to(zoom.fine(), strips[i + 1], width, share, share + step), 0.5, 0, mean);
        sum += mean_difference(strips[i], mean);
    }
    return sum / static_cast<double>(strips.size() - 2);
}

/// The largest mean step from one picture to the next, the earlier one bent to the later one's moment.
double largest_step(const StripZoom& zoom, const ZoomPictures& strips) {
    double largest = 0;
    const double step = 1.0 / static_cast<double>(strips.size() - 1);
    for (std::size_t i = 1; i < strips.size(); ++i) {
        const double share = static_cast<double>(i) * step;
        largest = std::max(largest, mean_difference(strips[i], bent_to(zoom.fine(), strips[i - 1],
                                                                       strips[i].cols, share, share - step)));
    }
    return largest;
}

/// The distance of the patches of a picture from the nearest patches of both levels: mean squared difference
/// a channel value. A picture that neither level shows is far.
double strangeness(const LevelPair& pair, const cv::Mat& strip) {
    constexpr int rounds = 4;
    constexpr int radius = 128;
    const PatchImage target(strip);
    cv::Mat nearest;
    for (const cv::Mat* level : {&pair.coarse, &pair.fine}) {
        const PatchImage source(*level);
        const PatchRules rules = free_rules(source);
        PatchMatch matches(source, target, rules);
        MatchField& field = matches.of_target();
        for (int y = 0; y < field.rows; ++y)
            for (int x = 0; x < field.columns; ++x)
                field.at(x, y) = {.x = static_cast<std::int16_t>(x * source.patch_columns() / field.columns),
                                  .y = static_cast<std::int16_t>(y)};
        matches.refresh(run_in_order);
        for (int round = 0; round < rounds; ++round)
            matches.search(radius, static_cast<std::uint32_t>(round), run_in_order);
        cv::Mat costs(field.rows, field.columns, CV_32SC1);
        for (int y = 0; y < field.rows; ++y)
            for (int x = 0; x < field.columns; ++x)
                costs.at<int>(y, x) = field.at(x, y).cost;
        nearest = nearest.empty() ? costs : cv::Mat(cv::min(nearest, costs));
    }
    return cv::mean(nearest)[0] / patch_values;
}

void print(const char* what, const LevelPair& pair, const StripZoom& zoom, const ZoomPictures& strips,
           double seconds) {
    double strange = 0;
    for (const int quarter : {1, 2, 3})
        strange += strangeness(pair, strips[static_cast<std::size_t>(quarter) * (strips.size() - 1) / 4]) / 3;
    const auto parts = static_cast<double>(zoom.parts().size());
    std::size_t bytes = 0;
    for (const cv::Mat& strip : strips)
        bytes += to_jpeg(strip, 85).size();
    fmt::print("  {}: {:.2f} s of CPU a part; flicker {:.2f}, largest step {:.1f} grey levels; patches that "
               "neither level has {:.0f}; as JPEGs {:.0f} kB a part\n",
               what, seconds / parts, flicker(zoom, strips), largest_step(zoom, strips), strange,
               static_cast<double>(bytes) / parts / 1000);
}

void measure(const std::string& path, const std::filesystem::path& pictures) {
    const auto source = open_media(path);
    const Film film = gathered(*source, std::filesystem::temp_directory_path(), nullptr);
    const auto levels = chosen_keyframes(*film.candidates, {.max_levels = 2}, run_in_order);
    if (levels.size() < 2) return fmt::print("{}: one level only\n", path);
    const LevelPair pair = woven_pair(film, levels, {}, run_in_order);
    const CpuTime matching;
    const StripZoom zoom(pair, run_in_order);
    fmt::print("{}: {} to {} px, {} parts, matched in {:.2f} s a part\n", path, pair.coarse.cols,
               pair.fine.cols, zoom.parts().size(),
               matching.seconds() / static_cast<double>(zoom.parts().size()));
    const ZoomRules rules;
    const CpuTime bending;
    const ZoomPictures bent = zoom.bent(rules.between);
    print("bent", pair, zoom, bent, bending.seconds());
    const CpuTime synthesis;
    const ZoomPictures synthesised = zoom.synthesised(rules, run_in_order);
    print("synthesised", pair, zoom, synthesised, synthesis.seconds());
    if (pictures.empty()) return;
    const std::string name = std::filesystem::path(path).stem().string();
    for (std::size_t i = 0; i < bent.size(); ++i) {
        cv::Mat both;
        cv::vconcat(bent[i], synthesised[i], both);
        write_png(pictures / fmt::format("{}-{:02}.png", name, i), both);
    }
}

int run(int argc, char** argv) {
    std::vector<std::string> films;
    std::filesystem::path pictures;
    CLI::App app("Cost and quality of the zoom between two levels.");
    app.add_option("FILM", films)->required();
    app.add_option("--pictures", pictures, "Where all pictures go, bent above synthesised");
    CLI11_PARSE(app, argc, argv);
    for (const std::string& film : films)
        measure(film, pictures);
    return 0;
}

}  // namespace
}  // namespace vitrine::analyzer

int main(int argc, char** argv) {
    return vitrine::analyzer::run(argc, argv);
}
