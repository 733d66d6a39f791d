#include "analyzer/saliency/subject_windows.hpp"

#include "analyzer/saliency/subject_cues.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

// A photograph's subject is a thing, not a set of pixels: cues that are right about each pixel still say
// little about the place where a person ends. So whole windows are judged instead, all rectangles of a coarse
// grid, and the map is their weighted sum. Where the cues agree few windows count and the map is sharp; where
// they do not, many count and the map is broad, so that the region keeps more.

namespace vitrine::analyzer {
namespace {

constexpr int grid = 12;          // cells along each side
constexpr double ring = 0.06;     // width of the surroundings of a window, share of each side
constexpr double faint = 0.02;    // added before logarithms are taken
constexpr double contrast = 1.8;  // power of the likelihoods: little is left of what is hardly likely

// A head around a face box, and the body below, as shares of the face box.
constexpr double hair = 0.35;
constexpr double ear = 0.15;
constexpr double chin = 0.15;
constexpr double shoulder = 0.7;
constexpr double body_length = 4;

constexpr std::array<float, window_facts> weights{
    // size, its square, area, off the middle across and down, down, aspect
    -2.038F,
    -0.281F,
    -1.099F,
    0.244F,
    0.013F,
    1.434F,
    -0.537F,
    // sides, top, bottom, both sides, top and bottom touched
    0.293F,
    0.096F,
    0.255F,
    0.076F,
    0.116F,
    // heads, bodies; with faces: size, bottom touched, size by the face's size
    5.000F,
    0.204F,
    -0.038F,
    0.745F,
    0.483F,
    // enclosed: share, rest, density, edge
    0.560F,
    1.756F,
    1.085F,
    0.896F,
    // enclosed cubed: share, rest, density, edge
    1.606F,
    -0.074F,
    0.075F,
    -0.008F,
    // sharp: share, rest, density, edge
    1.028F,
    -0.151F,
    0.403F,
    0.179F,
    // central: share, rest, density, edge
    1.553F,
    -0.504F,
    -0.360F,
    0.374F,
    // enclosed and central: share, rest, density, edge
    2.106F,
    -2.666F,
    1.122F,
    -0.845F,
};

/// The grid's lines along one side, px, and the same lines moved to either side by the ring.
struct GridLines {
    std::array<int, grid + 1> at{};
    std::array<int, grid + 1> before{};
    std::array<int, grid + 1> after{};

    explicit GridLines(int side) {
        const int width = std::max(1, static_cast<int>(std::lround(ring * side)));
        for (std::size_t k = 0; k <= grid; ++k) {
            at[k] = static_cast<int>(std::lround(static_cast<double>(k) * side / grid));
            before[k] = std::max(0, at[k] - width);
            after[k] = std::min(side, at[k] + width);
        }
    }
};

/// Sums of a map over rectangles.
class Sums {
  public:
    explicit Sums(const cv::Mat& map) { cv::integral(map, table_, CV_64F); }

    double in(int left, int top, int right, int bottom) const {
        const auto* above = table_.ptr<double>(top);
        const auto* below = table_.ptr<double>(bottom);
        return below[right] - below[left] - above[right] + above[left];
    }

    double whole() const { return table_.at<double>(table_.rows - 1, table_.cols - 1); }

    double mean() const { return whole() / ((table_.rows - 1.0) * (table_.cols - 1.0)); }

  private:
    cv::Mat table_;
};

/// The evidence in one picture that judges all its windows.
struct PictureEvidence {
    GridLines across;
    GridLines down;
    double aspect = 1;  // width by height
    std::vector<Sums> cues;
    std::vector<Box> heads;  // shares of the picture's sides
    std::vector<Box> bodies;
    double tallest_face = 0;  // share of the picture's height
};

Box part_of_picture(const Box& box) {
    return intersection(box, {{0, 0}, {1, 1}});
}

PictureEvidence evidence(const cv::Mat& bgr, std::span<const Face> faces) {
    const SubjectCues found = subject_cues(bgr);
    PictureEvidence e{.across = GridLines(found.sharp.cols),
                      .down = GridLines(found.sharp.rows),
                      .aspect = static_cast<double>(found.sharp.cols) / found.sharp.rows};
    e.cues.emplace_back(found.enclosed);
    e.cues.emplace_back(found.enclosed.mul(found.enclosed).mul(found.enclosed));
    e.cues.emplace_back(found.sharp);
    e.cues.emplace_back(found.central);
    e.cues.emplace_back(found.enclosed.mul(found.central));
    for (const Face& face : faces) {
        const Box b{{face.box.min.x / bgr.cols, face.box.min.y / bgr.rows},
                    {face.box.max.x / bgr.cols, face.box.max.y / bgr.rows}};
        const double w = b.width();
        const double h = b.height();
        e.heads.push_back(
            part_of_picture({b.min - Vec2{ear * w, hair * h}, b.max + Vec2{ear * w, chin * h}}));
        e.bodies.push_back(part_of_picture(
            {b.min - Vec2{shoulder * w, hair * h}, b.max + Vec2{shoulder * w, body_length * h}}));
        e.tallest_face = std::max(e.tallest_face, h);
    }
    return e;
}

double mean_share(std::span<const Box> boxes, const Box& window) {
    double sum = 0;
    for (const Box& box : boxes)
        sum += box.area() > 0 ? std::max(0.0, intersection(box, window).area()) / box.area() : 0;
    return boxes.empty() ? 0 : sum / static_cast<double>(boxes.size());
}

/// Writes facts of a window one after the other.
class FactWriter {
  public:
    explicit FactWriter(SubjectWindow& window) : window_(window) {}

    void add(double fact) { window_.facts[count_++] = static_cast<float>(fact); }

  private:
    SubjectWindow& window_;  // outlives this
    std::size_t count_ = 0;
};

void add_place(FactWriter& to, const SubjectWindow& w, double aspect) {
    const double width = static_cast<double>(w.right - w.left) / grid;
    const double height = static_cast<double>(w.bottom - w.top) / grid;
    const double size = std::log(width * height);
    const double x = (w.left + w.right) / (2.0 * grid) - 0.5;
    const double y = (w.top + w.bottom) / (2.0 * grid) - 0.5;
    const double shape = std::log(width * aspect / height);
    const bool is_left = w.left == 0;
    const bool is_right = w.right == grid;
    const bool is_top = w.top == 0;
    const bool is_bottom = w.bottom == grid;
    for (const double fact : {size, size * size, width * height, x * x, y * y, y, shape * shape})
        to.add(fact);
    to.add(static_cast<int>(is_left) + static_cast<int>(is_right));
    to.add(static_cast<int>(is_top));
    to.add(static_cast<int>(is_bottom));
    to.add(static_cast<int>(is_left && is_right));
    to.add(static_cast<int>(is_top && is_bottom));
}

void add_people(FactWriter& to, const SubjectWindow& w, const PictureEvidence& e) {
    if (e.heads.empty()) {
        for (int i = 0; i < 5; ++i)
            to.add(0);
        return;
    }
    const Box window{{static_cast<double>(w.left) / grid, static_cast<double>(w.top) / grid},
                     {static_cast<double>(w.right) / grid, static_cast<double>(w.bottom) / grid}};
    const double size = std::log(window.area());
    to.add(mean_share(e.heads, window));
    to.add(mean_share(e.bodies, window));
    to.add(size);
    to.add(static_cast<int>(w.bottom == grid));
    to.add(size * std::log(e.tallest_face));
}

void add_cue(FactWriter& to, const SubjectWindow& w, const PictureEvidence& e, const Sums& cue) {
    const auto [l, t, r, b] =
        std::array{static_cast<std::size_t>(w.left), static_cast<std::size_t>(w.top),
                   static_cast<std::size_t>(w.right), static_cast<std::size_t>(w.bottom)};
    const double inside = cue.in(e.across.at[l], e.down.at[t], e.across.at[r], e.down.at[b]);
    const double pixels = (e.across.at[r] - e.across.at[l]) * (e.down.at[b] - e.down.at[t]);
    const double wider = cue.in(e.across.before[l], e.down.before[t], e.across.after[r], e.down.after[b]);
    const double more = (e.across.after[r] - e.across.before[l]) * (e.down.after[b] - e.down.before[t]);
    const double mean = cue.mean();
    const double dense = inside / std::max(1.0, pixels);
    const double around = more > pixels ? (wider - inside) / (more - pixels) : dense;
    const double share = inside / cue.whole();
    to.add(share);
    to.add(std::log(1 - share + faint));
    to.add(std::log(dense / mean + faint));
    to.add(std::log((dense + faint * mean) / (around + faint * mean)));
}

}  // namespace

std::vector<SubjectWindow> subject_windows(const cv::Mat& bgr, std::span<const Face> faces) {
    const PictureEvidence e = evidence(bgr, faces);
    std::vector<SubjectWindow> windows;
    for (int top = 0; top < grid; ++top) {
        for (int bottom = top + 1; bottom <= grid; ++bottom) {
            for (int left = 0; left < grid; ++left) {
                for (int right = left + 1; right <= grid; ++right) {
                    SubjectWindow& w = windows.emplace_back(
                        SubjectWindow{.left = left, .top = top, .right = right, .bottom = bottom});
                    FactWriter to(w);
                    add_place(to, w, e.aspect);
                    add_people(to, w, e);
                    for (const Sums& cue : e.cues)
                        add_cue(to, w, e, cue);
                }
            }
        }
    }
    return windows;
}

SaliencyMap subject_likelihood(const cv::Mat& bgr, std::span<const Face> faces) {
    const std::vector<SubjectWindow> windows = subject_windows(bgr, faces);
    std::vector<float> scores;
    scores.reserve(windows.size());
    for (const SubjectWindow& w : windows) {
        float score = 0;
        for (std::size_t i = 0; i < window_facts; ++i)
            score += weights[i] * w.facts[i];
        scores.push_back(score);
    }
    const float best = *std::max_element(scores.begin(), scores.end());
    double sum = 0;
    cv::Mat steps = cv::Mat::zeros(grid + 1, grid + 1, CV_64F);  // summed from the top left gives the map
    for (std::size_t i = 0; i < windows.size(); ++i) {
        const auto weight = static_cast<double>(std::exp(scores[i] - best));
        const SubjectWindow& w = windows[i];
        sum += weight;
        steps.at<double>(w.top, w.left) += weight;
        steps.at<double>(w.bottom, w.right) += weight;
        steps.at<double>(w.top, w.right) -= weight;
        steps.at<double>(w.bottom, w.left) -= weight;
    }
    cv::Mat summed;
    cv::integral(steps, summed, CV_64F);
    cv::Mat cells = summed(cv::Rect(1, 1, grid, grid)) / sum;
    cells.convertTo(cells, CV_32F);
    SaliencyMap map;
    cv::resize(cells, map, bgr.size(), 0, 0, cv::INTER_LINEAR);
    cv::pow(cv::max(cv::min(map, 1.0), 0.0), contrast, map);
    return map;
}

}  // namespace vitrine::analyzer
