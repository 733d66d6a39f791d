#include "analyzer/weave/picture_file.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>
#include <vips/vips.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace vitrine {

namespace {

constexpr int jpeg_quality = 90;

struct Unref {
    void operator()(VipsImage* image) const { g_object_unref(image); }

    void operator()(void* bytes) const { g_free(bytes); }
};

/// @param encode  is given the picture, where its bytes and their number go; 0 where it worked
template <typename Encode>
void write_encoded(const std::filesystem::path& file, const cv::Mat& bgr, const Encode& encode) {
    const auto failed = [&] {
        return std::runtime_error(fmt::format("write '{}': {}", file.string(), vips_error_buffer()));
    };
    if (vips_init("vitrine") != 0) throw failed();
    cv::Mat rgb;
    cv::cvtColor(bgr, rgb, cv::COLOR_BGR2RGB);
    const std::unique_ptr<VipsImage, Unref> image(
        vips_image_new_from_memory(rgb.data, rgb.total() * 3, rgb.cols, rgb.rows, 3, VIPS_FORMAT_UCHAR));
    if (!image) throw failed();
    image->Type = VIPS_INTERPRETATION_sRGB;
    void* bytes = nullptr;
    std::size_t count = 0;
    const int code = encode(image.get(), &bytes, &count);
    const std::unique_ptr<void, Unref> owned(bytes);
    if (code != 0) throw failed();
    replace_file(file, {static_cast<const char*>(bytes), count});
}

}  // namespace

void write_jpeg(const std::filesystem::path& file, const cv::Mat& bgr) {
    write_encoded(file, bgr, [](VipsImage* image, void** bytes, std::size_t* count) {
        return vips_jpegsave_buffer(image, bytes, count, "Q", jpeg_quality, "subsample_mode",
                                    VIPS_FOREIGN_SUBSAMPLE_OFF, nullptr);
    });
}

void write_png(const std::filesystem::path& file, const cv::Mat& bgr) {
    write_encoded(file, bgr, [](VipsImage* image, void** bytes, std::size_t* count) {
        return vips_pngsave_buffer(image, bytes, count, "compression", 6, nullptr);
    });
}

}  // namespace vitrine
