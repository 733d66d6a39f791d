#include "analyzer/tapestry/weave/picture_file.hpp"

#include "base/media/still_picture.hpp"
#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <memory>
#include <stdexcept>

namespace vitrine::analyzer {

namespace {

constexpr int tile_quality = 90;

struct Unref {
    void operator()(VipsImage* image) const { g_object_unref(image); }

    void operator()(void* bytes) const { g_free(bytes); }
};

using VipsPicture = std::unique_ptr<VipsImage, Unref>;
using VipsBytes = std::unique_ptr<void, Unref>;

std::runtime_error failure(const char* what) {
    const std::string reason = vips_error_buffer();
    vips_error_clear();
    return std::runtime_error(fmt::format("{}: {}", what, reason));
}

/// @param encode  receives the picture and the places for its bytes and their number; returns 0 for success
template <typename Encode> std::string encoded(const cv::Mat& bgr, const Encode& encode) {
    init_vips();
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    const VipsPicture image(
        vips_image_new_from_memory(rgb.data, rgb.total() * 3, rgb.cols, rgb.rows, 3, VIPS_FORMAT_UCHAR));
    if (!image) throw failure("encode a picture");
    image->Type = VIPS_INTERPRETATION_sRGB;
    void* bytes = nullptr;
    std::size_t count = 0;
    const int code = encode(image.get(), &bytes, &count);
    const VipsBytes owned(bytes);
    if (code != 0) throw failure("encode a picture");
    return {static_cast<const char*>(bytes), count};
}

cv::Mat decoded(std::string_view bytes) {
    init_vips();
    const VipsPicture image(vips_image_new_from_buffer(bytes.data(), bytes.size(), "", nullptr));
    if (!image) throw failure("decode a picture");
    std::size_t count = 0;
    const VipsBytes rgb(vips_image_write_to_memory(image.get(), &count));
    const int width = vips_image_get_width(image.get());
    const int height = vips_image_get_height(image.get());
    if (!rgb) throw failure("decode a picture");
    const cv::Mat picture(height, width, CV_8UC3, rgb.get());
    if (count != picture.total() * picture.elemSize())
        throw std::runtime_error("decode a picture: it is not RGB of eight bits a channel");
    cv::Mat bgr;
    cv::cvtColor(picture, bgr, cv::COLOR_RGB2BGR);
    return bgr;
}

/// Runs a task and names the file in its errors.
template <typename Work> auto named(const std::filesystem::path& file, const Work& work) {
    try {
        return work();
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(fmt::format("'{}': {}", file.string(), error.what()));
    }
}

std::string to_png(const cv::Mat& bgr) {
    return encoded(bgr, [](VipsImage* image, void** bytes, std::size_t* count) {
        return vips_pngsave_buffer(image, bytes, count, "compression", 6, nullptr);
    });
}

}  // namespace

std::string to_jpeg(const cv::Mat& bgr, int quality) {
    return encoded(bgr, [&](VipsImage* image, void** bytes, std::size_t* count) {
        return vips_jpegsave_buffer(image, bytes, count, "Q", quality, "subsample_mode",
                                    VIPS_FOREIGN_SUBSAMPLE_OFF, nullptr);
    });
}

cv::Mat from_jpeg(std::string_view jpeg) {
    return decoded(jpeg);
}

void write_jpeg(const std::filesystem::path& file, const cv::Mat& bgr) {
    replace_file(file, named(file, [&] { return to_jpeg(bgr, tile_quality); }));
}

void write_png(const std::filesystem::path& file, const cv::Mat& bgr) {
    replace_file(file, named(file, [&] { return to_png(bgr); }));
}

cv::Mat read_png(const std::filesystem::path& file) {
    const std::string bytes = read_file(file);
    return named(file, [&] { return decoded(bytes); });
}

}  // namespace vitrine::analyzer
