// Measures regions by masks that people have drawn, on photographs that no value of the network's region was
// judged by before: masked_photos.py makes the folder. Of each group the even photographs are there to tune
// on, the odd ones are held back.

#include "analyzer/one_file/subject_network.hpp"
#include "analyzer/saliency/analysis_settings.hpp"
#include "analyzer/saliency/faces.hpp"
#include "analyzer/saliency/sample.hpp"
#include "analyzer/saliency/shot_region.hpp"
#include "bench/analysis/peer_crops.hpp"
#include "bench/analysis/region_score.hpp"
#include "bench/analysis/subject_scores.hpp"
#include "bench/analysis/tables.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace vitrine::analyzer {

namespace fs = std::filesystem;

namespace {

constexpr int photo_side = 640;  // px, as photographs are analysed

/// A photograph, seen once by all that looks at it.
struct MaskedPhoto {
    std::string name;
    cv::Mat picture;
    cv::Mat mask;         // CV_8UC1, 255 where the subjects are
    Sample plain;         // without a network
    SaliencyMap subject;  // by the network
    SaliencyMap student;  // by its student
    bool is_held_back = false;
};

/// The edges of the picture that the subjects touch.
int touched_edges(const cv::Mat& mask) {
    const int reach = std::max(1, std::max(mask.cols, mask.rows) / 100);
    const std::array<cv::Rect, 4> strips{
        cv::Rect(0, 0, mask.cols, reach), cv::Rect(0, mask.rows - reach, mask.cols, reach),
        cv::Rect(0, 0, reach, mask.rows), cv::Rect(mask.cols - reach, 0, reach, mask.rows)};
    return static_cast<int>(std::ranges::count_if(
        strips, [&](const cv::Rect& strip) { return cv::countNonZero(mask(strip)) > 0; }));
}

Polygon region_of(const MaskedPhoto& photo, const SaliencyMap& subject) {
    Sample sample = photo.plain;
    sample.subject = subject;
    const cv::Size size = photo.picture.size();
    return shot_region({sample}, {}, map_size(size), size, {}).shot.region.polygon;
}

/// The networks that look at photographs.
struct Networks {
    std::unique_ptr<SubjectNetwork> network;
    std::unique_ptr<SubjectNetwork> student;
};

/// The regions of a photograph: plain, with the network, with its student, and a box of the second one's
/// area.
using WayRegions = std::array<Polygon, 4>;

/// The rows of a table, each by four ways.
class MaskRows {
  public:
    void add(const std::string& row, const MaskedPhoto& photo, const WayRegions& regions) {
        if (!scores_.contains(row)) order_.push_back(row);
        const cv::Size size = photo.picture.size();
        const double subject = cv::countNonZero(photo.mask) / static_cast<double>(size.area());
        for (std::size_t way = 0; way < regions.size(); ++way)
            scores_[row][way].add(
                region_score(regions[way], size, photo.mask, cv::Mat::zeros(size, CV_8UC1), {}), subject);
    }

    void print() {
        constexpr std::array<const char*, 4> names{"plain", "with the network", "with the student",
                                                   "box, network's area"};
        for (const std::string& row : order_) {
            fmt::print("{}: {} photographs\n", row, scores_[row][0].coverage.size());
            for (std::size_t way = 0; way < names.size(); ++way)
                print_scores(names[way], scores_[row][way]);
        }
    }

  private:
    std::vector<std::string> order_;
    std::map<std::string, std::array<SubjectScores, 4>> scores_;
};

std::vector<fs::path> photos_in(const fs::path& folder) {
    std::vector<fs::path> result;
    for (const fs::path& file : fs::directory_iterator(folder))
        if (file.extension() == ".jpg") result.push_back(file);
    std::sort(result.begin(), result.end());
    return result;
}

MaskedPhoto read_photo(const fs::path& file, FaceDetector& detector, Networks& networks) {
    MaskedPhoto photo{.name = file.filename().string(), .picture = picture(file, photo_side)};
    cv::cvtColor(picture(fs::path(file).replace_extension(".png"), photo_side), photo.mask,
                 cv::COLOR_BGR2GRAY);
    photo.mask = photo.mask > 127;
    const AnalysisSettings settings;
    const std::vector<Face> faces = find_faces(detector, photo.picture, settings.only_prominent_faces);
    photo.plain = sample_of({photo.picture, {}, 1}, settings, faces);
    photo.plain.faces = faces;
    photo.subject = networks.network->find({photo.picture, {}, 1});
    photo.student = networks.student->find({photo.picture, {}, 1});
    return photo;
}

void add_photo(const std::string& group, const MaskedPhoto& photo, MaskRows& rows, bool is_verbose) {
    const Polygon ours = region_of(photo, photo.subject);
    const cv::Size size = photo.picture.size();
    const WayRegions regions{region_of(photo, {}), ours, region_of(photo, photo.student),
                             to_polygon(centre_crop(size, area(ours) / static_cast<double>(size.area())))};
    const char* half = photo.is_held_back ? "held back" : "tuned on";
    rows.add(fmt::format("{}, {}", group, half), photo, regions);
    if (touched_edges(photo.mask) >= 2) rows.add(fmt::format("touching two edges, {}", half), photo, regions);
    if (!is_verbose) return;
    const RegionScore s = region_score(ours, size, photo.mask, cv::Mat::zeros(size, CV_8UC1), {});
    fmt::print("  {:50} iou {:.2f} coverage {:.2f} area {:.2f}\n", photo.name, s.iou, s.coverage, s.area);
}

}  // namespace

void masks_table(const TableInput& input) {
    if (!fs::is_directory(input.masks)) {
        fmt::print("photographs with masks: not here\n");
        return;
    }
    const auto faces = face_detector(input.face_model, AnalysisSettings{}.face_cascade);
    Networks networks{.network =
                          photo_network({.saliency_model = input.saliency_model, .looks_at_photos = true}),
                      .student = photo_network({.saliency_model = input.student_model, .is_student = true})};
    MaskRows rows;
    for (const char* group : {"pet", "cat", "cats"}) {
        const std::vector<fs::path> files = photos_in(input.masks / group);
        for (std::size_t i = 0; i < files.size(); ++i) {
            MaskedPhoto photo = read_photo(files[i], *faces, networks);
            photo.is_held_back = i % 2 == 1;
            add_photo(group, photo, rows, input.is_verbose);
        }
    }
    print_scores_head();
    rows.print();
}

}  // namespace vitrine::analyzer
