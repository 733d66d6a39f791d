#include "analyzer/film/reduce_frame.hpp"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr int weight_bits = 23;  // bits of a block's weight: a weighted sum fits 32 bits

// One component of a frame: a plane, or every second byte of one (NV12).
struct Component {
    const std::uint8_t* data = nullptr;
    int width = 0;
    int height = 0;
    int stride = 0;  // bytes
    int step = 1;    // samples from one value to the next
    int shift = 0;   // bits beyond eight
};

Component component_of(const GstVideoFrame& frame, guint index) {
    const int bytes = GST_VIDEO_FRAME_COMP_DEPTH(&frame, index) > 8 ? 2 : 1;
    return {.data = static_cast<const std::uint8_t*>(GST_VIDEO_FRAME_COMP_DATA(&frame, index)),
            .width = GST_VIDEO_FRAME_COMP_WIDTH(&frame, index),
            .height = GST_VIDEO_FRAME_COMP_HEIGHT(&frame, index),
            .stride = GST_VIDEO_FRAME_COMP_STRIDE(&frame, index),
            .step = GST_VIDEO_FRAME_COMP_PSTRIDE(&frame, index) / bytes,
            .shift = static_cast<int>(GST_VIDEO_FRAME_COMP_DEPTH(&frame, index)) - 8};
}

template <typename Sample> const Sample* row_of(const Component& plane, int row) {
    return reinterpret_cast<const Sample*>(plane.data + static_cast<std::ptrdiff_t>(row) * plane.stride);
}

// Some rows of a plane, evenly spread.
struct Rows {
    int first = 0;
    int count = 1;
    int step = 1;
};

// Adds rows, whose number is known when this is compiled, into one sum a column. Each sum is stored once. The
// loops are plain so that the compiler vectorises them.
template <int count, typename Sample, typename Sum>
void add_few_rows(const Component& plane, const Rows& rows, std::vector<Sum>& sums) {
    std::array<const Sample*, count> from{};
    for (int row = 0; row < count; ++row)
        from[static_cast<std::size_t>(row)] = row_of<Sample>(plane, rows.first + row * rows.step);
    Sum* const out = sums.data();
    const std::size_t columns = sums.size();
    for (std::size_t i = 0; i < columns; ++i) {
        Sum sum = 0;
        for (const Sample* samples : from)
            sum = static_cast<Sum>(sum + samples[i]);
        out[i] = sum;
    }
}

template <typename Sample, typename Sum>
void add_rows(const Component& plane, const Rows& rows, std::vector<Sum>& sums) {
    if (rows.count == 3) return add_few_rows<3, Sample>(plane, rows, sums);  // 1080p to 320 px
    if (rows.count == 2) return add_few_rows<2, Sample>(plane, rows, sums);  // 720p
    std::fill(sums.begin(), sums.end(), Sum{0});
    for (int row = 0; row < rows.count; ++row) {
        const Sample* samples = row_of<Sample>(plane, rows.first + row * rows.step);
        Sum* out = sums.data();
        for (std::size_t i = 0; i < sums.size(); ++i)
            out[i] = static_cast<Sum>(out[i] + samples[i]);
    }
}

template <int block, typename Sum>
void average_few_columns(const Sum* sums, std::uint32_t scale, std::uint8_t* to, int count) {
    for (int x = 0; x < count; ++x) {
        std::uint32_t sum = 0;
        for (int i = 0; i < block; ++i)
            sum += sums[x * block + i];
        to[x] = static_cast<std::uint8_t>((sum * scale + (1U << (weight_bits - 1))) >> weight_bits);
    }
}

// The blocks side by side in one row of the small picture.
struct BlockRow {
    int width = 1;  // columns of a block
    int step = 1;   // sums from one column to the next
    std::uint32_t scale = 0;
};

// The row of blocks comes by value: then no store of the loop can change it.
template <typename Sum> void average_columns(const Sum* sums, const BlockRow blocks, cv::Mat& out, int row) {
    const auto [block, step, scale] = blocks;
    auto* to = out.ptr<std::uint8_t>(row);
    if (step == 1 && block == 6) return average_few_columns<6>(sums, scale, to, out.cols);
    if (step == 1 && block == 4) return average_few_columns<4>(sums, scale, to, out.cols);
    if (step == 1 && block == 3) return average_few_columns<3>(sums, scale, to, out.cols);
    for (int x = 0; x < out.cols; ++x) {
        std::uint32_t sum = 0;
        for (int i = 0; i < block; ++i)
            sum += sums[static_cast<std::ptrdiff_t>(x * block + i) * step];
        to[x] = static_cast<std::uint8_t>((sum * scale + (1U << (weight_bits - 1))) >> weight_bits);
    }
}

// Averages whole blocks. The rest at the right and bottom, less than a block, is not looked at. Of high
// blocks every second row is left out: fetching a frame from memory takes the time, and no map shows details
// of one row.
template <typename Sample, typename Sum>
cv::Mat average_blocks(const Component& plane, int block_width, int block_height) {
    constexpr int high = 4;
    const int step = block_height >= high ? 2 : 1;
    const int rows = (block_height + step - 1) / step;
    cv::Mat out(plane.height / block_height, plane.width / block_width, CV_8UC1);
    std::vector<Sum> sums(static_cast<std::size_t>(plane.width) * static_cast<std::size_t>(plane.step));
    const double weight = 1.0 / (block_width * rows * (1 << plane.shift));
    const auto scale = static_cast<std::uint32_t>(std::floor(weight * (1 << weight_bits)));
    for (int row = 0; row < out.rows; ++row) {
        add_rows<Sample>(plane, {.first = row * block_height, .count = rows, .step = step}, sums);
        average_columns(sums.data(), {.width = block_width, .step = plane.step, .scale = scale}, out, row);
    }
    return out;
}

cv::Mat shrink(const Component& plane, cv::Size size) {
    const int block_width = std::max(1, plane.width / size.width);
    const int block_height = std::max(1, plane.height / size.height);
    constexpr int max_rows_in_16_bits = 257;
    cv::Mat small;
    if (plane.shift > 0)
        small = average_blocks<std::uint16_t, std::uint32_t>(plane, block_width, block_height);
    else if (block_height <= max_rows_in_16_bits)
        small = average_blocks<std::uint8_t, std::uint16_t>(plane, block_width, block_height);
    else
        small = average_blocks<std::uint8_t, std::uint32_t>(plane, block_width, block_height);
    if (small.size() == size) return small;
    cv::Mat resampled;
    cv::resize(small, resampled, size, 0, 0, cv::INTER_LINEAR);
    return resampled;
}

// Fixed point, 1/4096: blue, green and red from luma and the two colour differences.
struct Matrix {
    int luma = 4096;
    int luma_offset = 0;
    int red_cr = 0;
    int green_cb = 0;
    int green_cr = 0;
    int blue_cb = 0;
};

Matrix matrix_of(const GstVideoInfo& info) {
    constexpr double one = 4096;
    double red = 0.2126;
    double blue = 0.0722;
    if (!gst_video_color_matrix_get_Kr_Kb(info.colorimetry.matrix, &red, &blue)) {
        red = 0.2126;
        blue = 0.0722;
    }
    const bool full = info.colorimetry.range == GST_VIDEO_COLOR_RANGE_0_255;
    const double luma = full ? 1.0 : 255.0 / 219.0;
    const double chroma = full ? 1.0 : 255.0 / 224.0;
    const double green = 1 - red - blue;
    const auto fixed = [](double value) { return static_cast<int>(std::lround(value * one)); };
    return {.luma = fixed(luma),
            .luma_offset = full ? 0 : 16,
            .red_cr = fixed(2 * (1 - red) * chroma),
            .green_cb = fixed(-2 * blue * (1 - blue) / green * chroma),
            .green_cr = fixed(-2 * red * (1 - red) / green * chroma),
            .blue_cb = fixed(2 * (1 - blue) * chroma)};
}

std::uint8_t clamped(int fixed) {
    return static_cast<std::uint8_t>(std::clamp((fixed + 2048) >> 12, 0, 255));
}

cv::Mat to_bgr(const cv::Mat& luma, const cv::Mat& cb, const cv::Mat& cr, const Matrix& m) {
    cv::Mat bgr(luma.size(), CV_8UC3);
    for (int row = 0; row < luma.rows; ++row) {
        const auto* y = luma.ptr<std::uint8_t>(row);
        const auto* u = cb.ptr<std::uint8_t>(row);
        const auto* v = cr.ptr<std::uint8_t>(row);
        auto* out = bgr.ptr<std::uint8_t>(row);
        for (int x = 0; x < luma.cols; ++x, out += 3) {
            const int base = (y[x] - m.luma_offset) * m.luma;
            const int blue_difference = u[x] - 128;
            const int red_difference = v[x] - 128;
            out[0] = clamped(base + m.blue_cb * blue_difference);
            out[1] = clamped(base + m.green_cb * blue_difference + m.green_cr * red_difference);
            out[2] = clamped(base + m.red_cr * red_difference);
        }
    }
    return bgr;
}

void lay_over(cv::Mat& bgr, const cv::Mat& alpha, Colour background) {
    const std::array<int, 3> behind{background.blue, background.green, background.red};
    for (int row = 0; row < bgr.rows; ++row) {
        const auto* opacity = alpha.ptr<std::uint8_t>(row);
        auto* pixel = bgr.ptr<std::uint8_t>(row);
        for (int x = 0; x < bgr.cols; ++x, ++opacity, pixel += 3)
            for (std::size_t i = 0; i < behind.size(); ++i)
                pixel[i] = static_cast<std::uint8_t>(
                    (pixel[i] * *opacity + behind[i] * (255 - *opacity) + 127) / 255);
    }
}

}  // namespace

cv::Mat reduce_frame(const GstVideoFrame& frame, cv::Size size, Colour background) {
    const cv::Mat luma = shrink(component_of(frame, 0), size);
    const Matrix matrix = matrix_of(frame.info);
    if (GST_VIDEO_FRAME_N_COMPONENTS(&frame) < 3) {
        const cv::Mat neutral(size, CV_8UC1, cv::Scalar(128));
        return to_bgr(luma, neutral, neutral, matrix);
    }
    cv::Mat bgr =
        to_bgr(luma, shrink(component_of(frame, 1), size), shrink(component_of(frame, 2), size), matrix);
    constexpr guint alpha = 3;
    if (GST_VIDEO_FRAME_N_COMPONENTS(&frame) > alpha)
        lay_over(bgr, shrink(component_of(frame, alpha), size), background);
    return bgr;
}

}  // namespace vitrine::analyzer
