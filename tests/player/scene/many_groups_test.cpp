#include "analyzer/one_file/picture_print.hpp"
#include "base/media/still_picture.hpp"
#include "player/scene/files/file_groups.hpp"
#include "tests/player/scene/made_pictures.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <set>

using namespace vitrine;
using namespace vitrine::player;
using namespace std::chrono_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::chrono::sys_days day = std::chrono::year(2023) / 5 / 1;

ShotLook look_of(const cv::Mat& picture) {
    ShotLook look;
    cv::Mat grey, steps, fields;
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
    cv::resize(grey, steps, {9, 8}, 0, 0, cv::INTER_AREA);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            look.hash = look.hash << 1U | static_cast<unsigned>(steps.at<std::uint8_t>(y, x) >
                                                                steps.at<std::uint8_t>(y, x + 1));
    cv::resize(picture, fields, {3, 3}, 0, 0, cv::INTER_AREA);
    std::size_t i = 0;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x)
            for (const int channel : {2, 1, 0})
                look.colours[i++] = fields.at<cv::Vec3b>(y, x)[channel];
    return look;
}

/// Quarters of every second photo: the others were used to choose the limits.
std::vector<cv::Mat> real_scenes() {
    std::vector<cv::Mat> scenes;
    const fs::path folder = fs::path(VITRINE_MEDIA) / "photos";
    std::set<fs::path> files;
    std::error_code missing;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, missing))
        if (entry.path().extension() != ".json") files.insert(entry.path());
    int number = 0;
    for (const fs::path& file : files) {
        if (number++ % 2 == 0) continue;
        StillPicture still = load_still(file.string(), 1280, 1280, {});
        cv::Mat picture;
        cv::cvtColor(cv::Mat(still.height, still.width, CV_8UC4, still.pixels.data()), picture,
                     cv::COLOR_RGBA2BGR);
        const cv::Size half(picture.cols / 2, picture.rows / 2);
        for (const cv::Point corner : {cv::Point(0, 0), cv::Point(half.width, 0), cv::Point(0, half.height),
                                       cv::Point(half.width, half.height)})
            scenes.push_back(picture({corner, half}).clone());
    }
    return scenes;
}

/// Takes, each with three near-copies and the same room a month later.
class Library {
  public:
    Library(std::vector<cv::Mat> scenes, std::size_t takes, unsigned seed) : made_(seed) {
        while (scenes.size() < takes)
            scenes.push_back(made_.scene());
        for (std::size_t i = 0; i < takes; ++i)
            add_take(scenes[i], i);
        const std::clock_t begin = std::clock();
        groups_.set_files(records_);
        milliseconds_ = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC /
                        static_cast<double>(records_.size());
    }

    /// The share of a kind of near-copies that were found. @param of_camera  with times of a camera
    double found(const char* kind, bool of_camera) const {
        double all = 0, found = 0;
        for (std::size_t i = of_camera ? 0 : 1; i < takes_; i += 2) {
            all += 1;
            const auto take = groups_.groups().find(name("take", i));
            const auto copy = groups_.groups().find(name(kind, i));
            if (take && copy && take->group == copy->group) found += 1;
        }
        return found / all;
    }

    /// The share of takes that were merged with a different picture.
    double merged() const {
        double merged = 0;
        for (std::size_t i = 0; i < takes_; ++i) {
            const auto take = groups_.groups().find(name("take", i));
            if (!take) continue;
            const std::set<std::string> own{name("take", i), name("crop", i), name("exposure", i),
                                            name("next", i)};
            for (const std::string& path : take->group->photos)
                if (!own.contains(path)) {
                    merged += 1;
                    break;
                }
        }
        return merged / static_cast<double>(takes_);
    }

    double milliseconds() const { return milliseconds_; }

  private:
    static std::string name(const char* kind, std::size_t take) {
        return fmt::format("{}{:05}.jpg", kind, take);
    }

    void add(const cv::Mat& picture, const std::string& path, const TimeTaken& taken) {
        cv::Mat seen;
        const double scale = 640.0 / std::max(picture.cols, picture.rows);
        cv::resize(picture, seen, {}, scale, scale, cv::INTER_AREA);
        MediaRecord record{.path = path,
                           .state = MediaState::ready,
                           .width = picture.cols,
                           .height = picture.rows,
                           .shots = {Shot{}}};
        record.shots.front().print = analyzer::print_of(seen);
        record.shots.front().look = look_of(picture);
        record.origin.taken = taken;
        records_.push_back(std::move(record));
    }

    void add_take(const cv::Mat& scene, std::size_t i) {
        const bool is_camera = i % 2 == 0;
        TimeTaken taken{.at = day + std::chrono::milliseconds(is_camera ? i * 10'800'000 : i * 7),
                        .zone = {},
                        .source = is_camera ? TimeSource::camera : TimeSource::file};
        add(scene, name("take", i), taken);
        add(made_.cropped(scene, 0.8), name("crop", i), taken);
        taken.at += 1s;
        add(made_.exposed(scene), name("exposure", i), taken);
        add(made_.next_frame(scene), name("next", i), taken);
        taken.at += 24h * 30;
        add(made_.another_day(scene), name("month", i), taken);
        ++takes_;
    }

    MadePictures made_;
    std::vector<MediaRecord> records_;
    FileGroups groups_;
    std::size_t takes_ = 0;
    double milliseconds_ = 0;
};

void check(const Library& library) {
    for (const char* kind : {"crop", "exposure", "next"}) {
        CAPTURE(kind);
        MESSAGE(fmt::format("{}: found {:.3f} with times, {:.3f} without", kind, library.found(kind, true),
                            library.found(kind, false)));
        CHECK(library.found(kind, true) >= 0.95);
        CHECK(library.found(kind, false) >= 0.95);
    }
    MESSAGE(fmt::format("different pictures merged {:.4f}, {:.2f} ms of CPU a photo", library.merged(),
                        library.milliseconds()));
    CHECK(library.merged() <= 0.005);
}

}  // namespace

TEST_CASE("near-copies are found and different pictures are not merged, also those of the same room") {
    const char* given = std::getenv("VITRINE_GROUPS");
    const std::size_t pictures = given == nullptr ? 300 : std::strtoul(given, nullptr, 10);
    check(Library({}, pictures / 5, 3));
    if (given != nullptr) check(Library(real_scenes(), pictures / 5, 2));
}
