#include "analyzer/film/frame_features.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr int counted_side = 100;   // about so many columns and rows are counted; more tell nothing new
constexpr int row_step = 2;         // every second row is enough for a cell's mean
constexpr int max_cell_rows = 257;  // rows of a cell: a sum of so many bytes fits 16 bits

void count_colours(const cv::Mat& picture, FrameFeatures& features) {
    std::array<std::uint32_t, FrameFeatures::bins * FrameFeatures::bins * FrameFeatures::bins> counts{};
    const int step = std::max(1, std::max(picture.cols, picture.rows) / counted_side);
    std::uint32_t total = 0;
    for (int row = 0; row < picture.rows; row += step) {
        const auto* pixel = picture.ptr<std::uint8_t>(row);
        for (int x = 0; x < picture.cols; x += step, pixel += static_cast<std::ptrdiff_t>(3) * step)
            ++counts[static_cast<std::size_t>(pixel[0] >> 5 << 6 | pixel[1] >> 5 << 3 | pixel[2] >> 5)];
        total += static_cast<std::uint32_t>((picture.cols + step - 1) / step);
    }
    const float share = 65535.F / static_cast<float>(total);
    for (std::size_t i = 0; i < counts.size(); ++i)
        features.histogram[i] = static_cast<std::uint16_t>(cvRound(static_cast<float>(counts[i]) * share));
}

constexpr std::size_t channels = 3;
constexpr int detail_width = static_cast<int>(FrameFeatures::detail_width);
constexpr int detail_height = static_cast<int>(FrameFeatures::detail_height);
constexpr std::size_t cells = channels * FrameFeatures::detail_width;  // values of a row of the detail

// The first column or row of a cell. The last cell ends where the picture ends. Cells of a small picture
// share rows and columns.
int begin_of(int cell, int cell_count, int length) {
    return std::min(cell * length / cell_count, length - 1);
}

int end_of(int cell, int cell_count, int length) {
    return std::max((cell + 1) * length / cell_count, begin_of(cell, cell_count, length) + 1);
}

// Adds up every second of the picture's rows [begin, end); returns the number of rows.
int add_rows(const cv::Mat& picture, int begin, int end, std::vector<std::uint16_t>& sums) {
    std::ranges::fill(sums, std::uint16_t{0});
    const std::size_t values = sums.size();
    for (int row = begin; row < end; row += row_step) {
        const auto* value = picture.ptr<std::uint8_t>(row);
        for (std::size_t i = 0; i < values; ++i)
            sums[i] = static_cast<std::uint16_t>(sums[i] + value[i]);
    }
    return (end - begin + row_step - 1) / row_step;
}

// The places of the cells in a row of pixels.
class Columns {
  public:
    explicit Columns(int width) {
        for (int x = 0; x < detail_width; ++x) {
            const auto i = static_cast<std::size_t>(x);
            begin_[i] = static_cast<int>(channels) * begin_of(x, detail_width, width);
            end_[i] = static_cast<int>(channels) * end_of(x, detail_width, width);
        }
    }

    // The means of a row of cells, from the sums of `rows` rows of pixels.
    std::array<std::uint8_t, cells> means(const std::vector<std::uint16_t>& sums, int rows) const {
        std::array<std::uint8_t, cells> out{};
        for (std::size_t x = 0; x < begin_.size(); ++x) {
            std::uint32_t blue = 0;
            std::uint32_t green = 0;
            std::uint32_t red = 0;
            for (auto i = static_cast<std::size_t>(begin_[x]); i < static_cast<std::size_t>(end_[x]);
                 i += channels) {
                blue += sums[i];
                green += sums[i + 1];
                red += sums[i + 2];
            }
            const float share =
                static_cast<float>(channels) / static_cast<float>(rows * (end_[x] - begin_[x]));
            out[channels * x] = rounded(blue, share);
            out[channels * x + 1] = rounded(green, share);
            out[channels * x + 2] = rounded(red, share);
        }
        return out;
    }

  private:
    static std::uint8_t rounded(std::uint32_t sum, float share) {
        return static_cast<std::uint8_t>(cvRound(static_cast<float>(sum) * share));
    }

    std::array<int, FrameFeatures::detail_width> begin_{};
    std::array<int, FrameFeatures::detail_width> end_{};
};

using Row = std::array<std::uint8_t, cells>;

void make_grey(const Row& colours, std::span<std::uint8_t, FrameFeatures::detail_width> grey) {
    for (std::size_t x = 0; x < grey.size(); ++x) {  // BT.601 in 1/256
        const std::size_t i = x * channels;
        grey[x] = static_cast<std::uint8_t>(
            (29 * colours[i] + 150 * colours[i + 1] + 77 * colours[i + 2] + 128) / 256);
    }
}

// Each place is the mean of two by two cells.
void make_places(const Row& above, const Row& below, std::span<std::uint8_t, cells / 2> places) {
    for (std::size_t x = 0; x < places.size() / channels; ++x) {
        for (std::size_t c = 0; c < channels; ++c) {
            const std::size_t i = 2 * x * channels + c;
            places[x * channels + c] = static_cast<std::uint8_t>(
                (above[i] + above[i + channels] + below[i] + below[i + channels] + 2) / 4);
        }
    }
}

// Passes over the picture once. Adds up the rows of a cell as they lie, which a compiler turns into vector
// code.
void sign(const cv::Mat& picture, FrameFeatures& features) {
    std::vector<std::uint16_t> sums(static_cast<std::size_t>(picture.cols) * channels);
    const Columns columns(picture.cols);
    const std::span detail(features.detail);
    const std::span signature(features.signature);
    Row above{};
    for (int y = 0; y < detail_height; ++y) {
        const int begin = begin_of(y, detail_height, picture.rows);
        const int end = std::min(end_of(y, detail_height, picture.rows), begin + max_cell_rows);
        const auto colours = columns.means(sums, add_rows(picture, begin, end, sums));
        const auto line = static_cast<std::size_t>(y);
        make_grey(colours,
                  detail.subspan(line * FrameFeatures::detail_width).first<FrameFeatures::detail_width>());
        if (y % 2 == 1)
            make_places(above, colours, signature.subspan(line / 2 * cells / 2).first<cells / 2>());
        above = colours;
    }
    std::uint32_t sum = 0;
    std::uint32_t squares = 0;
    for (const std::uint8_t value : features.detail) {
        sum += value;
        squares += std::uint32_t{value} * value;
    }
    const auto count = static_cast<double>(features.detail.size());
    features.mean = sum / count;
    features.deviation = std::sqrt(std::max(0.0, squares / count - features.mean * features.mean));
    features.margins = black_margins(features.detail, {detail_width, detail_height});
}

}  // namespace

FrameFeatures features_of(const FilmFrame& frame) {
    FrameFeatures features;
    features.time = frame.time;
    features.aspect = static_cast<double>(frame.picture.cols) / frame.picture.rows;
    count_colours(frame.picture, features);
    sign(frame.picture, features);
    return features;
}

cv::Rect common_part(const FrameFeatures& a, const FrameFeatures& b) {
    return common_part(a.margins, b.margins, {detail_width / 2, detail_height / 2});
}

double colour_difference(const FrameFeatures& a, const FrameFeatures& b) {
    int sum = 0;
    for (std::size_t i = 0; i < a.histogram.size(); ++i)
        sum += std::abs(int{a.histogram[i]} - int{b.histogram[i]});
    const double part = static_cast<double>(common_part(a, b).area()) / (detail_width * detail_height / 4.0);
    return std::min(1.0, sum / (2 * 65535.0 * part));
}

double picture_difference(const FrameFeatures& a, const FrameFeatures& b) {
    const cv::Rect part = common_part(a, b);
    const auto first = static_cast<std::size_t>(part.y) * cells / 2;  // black columns differ by nothing
    const auto end = static_cast<std::size_t>(part.br().y) * cells / 2;
    int sum = 0;
    for (std::size_t i = first; i < end; ++i)
        sum += std::abs(int{a.signature[i]} - int{b.signature[i]});
    return static_cast<double>(sum) / (static_cast<double>(channels) * part.area());
}

}  // namespace vitrine::analyzer
