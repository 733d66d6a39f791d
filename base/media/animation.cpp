#include "base/media/animation.hpp"

#include "base/media/still_picture.hpp"
#include "base/media/vips_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <span>

namespace vitrine {

namespace {

constexpr int channels = 4;

/// A GIF or a WebP. libvips makes one high picture of all pictures, one below the other, and decodes them as
/// its rows are asked for.
class VipsAnimation final : public AnimationReader {
  public:
    VipsAnimation(const std::string& path, MediaFormat format, Colour background) : file_(path) {
        start_vips();
        vips_error_clear();  // errors of earlier calls
        try {
            source_ = open_source(file_);
            read_info(opened(format, 1).get());
            source_ = open_source(file_);
            const VipsPtr<VipsImage> all = opened(format, -1);
            const VipsPtr<VipsImage> colours = opaque(all.get(), background);
            image_ = step([&](auto** out) { return vips_bandjoin_const1(colours.get(), out, 255, nullptr); });
        } catch (const MediaError&) {
            file_.throw_fault();
            throw;
        }
        const auto pictures = static_cast<std::int64_t>(info_.durations.size());
        if (vips_image_get_bands(image_.get()) != channels ||
            vips_image_get_height(image_.get()) != pictures * info_.height)
            throw MediaError(MediaState::failed, "the animation is damaged");
    }

    const AnimationInfo& info() const override { return info_; }

    std::vector<std::byte> next() override {
        const VipsRect rows{
            .left = 0, .top = next_ * info_.height, .width = info_.width, .height = info_.height};
        // A region belongs to the thread that made it, and each picture may be asked for by another one.
        const VipsPtr<VipsRegion> region(vips_region_new(image_.get()));
        if (!region || vips_region_prepare(region.get(), &rows) != 0) {
            file_.throw_fault();
            throw vips_failure();
        }
        ++next_;
        const std::size_t row = static_cast<std::size_t>(info_.width) * channels;
        std::vector<std::byte> pixels(row * static_cast<std::size_t>(info_.height));
        for (int y = 0; y < info_.height; ++y) {
            const auto* from =
                reinterpret_cast<const std::byte*>(VIPS_REGION_ADDR(region.get(), rows.left, rows.top + y));
            std::copy_n(from, row, pixels.begin() + static_cast<std::ptrdiff_t>(row) * y);
        }
        return pixels;
    }

  private:
    /// @param pictures  -1: all
    VipsPtr<VipsImage> opened(MediaFormat format, int pictures) {
        const VipsAccess once = VIPS_ACCESS_SEQUENTIAL;
        const VipsFailOn errors = VIPS_FAIL_ON_ERROR;  // a cut file is an error
        const auto load = format == MediaFormat::animated_gif ? vips_gifload_source : vips_webpload_source;
        return step([&](auto** out) {
            return load(source_.get(), out, "access", once, "fail_on", errors, "n", pictures, nullptr);
        });
    }

    /// @param first  the first picture
    void read_info(VipsImage* first) {
        info_.width = vips_image_get_width(first);
        info_.height = vips_image_get_height(first);
        const int pictures = vips_image_get_n_pages(first);
        require_animation_within_limits(info_.width, info_.height, pictures);
        int* delays = nullptr;  // ms
        int count = 0;
        if (vips_image_get_typeof(first, "delay") != 0)
            vips_image_get_array_int(first, "delay", &delays, &count);
        for (int i = 0; i < pictures; ++i)
            info_.durations.push_back(picture_duration(std::chrono::milliseconds(i < count ? delays[i] : 0)));
    }

    PhotoFile file_;
    VipsPtr<VipsSource> source_;
    AnimationInfo info_;
    VipsPtr<VipsImage> image_;
    int next_ = 0;
};

}  // namespace

std::chrono::nanoseconds AnimationInfo::duration() const {
    return std::accumulate(durations.begin(), durations.end(), std::chrono::nanoseconds(0));
}

std::unique_ptr<AnimationReader> open_vips_animation(const std::string& path, MediaFormat format,
                                                     Colour background) {
    return std::make_unique<VipsAnimation>(path, format, background);
}

void require_animation_within_limits(int width, int height, std::int64_t pictures) {
    if (std::max(width, height) > max_animation_side || std::int64_t{width} * height > max_animation_pixels)
        throw MediaError(MediaState::unsupported,
                         fmt::format("the animation is too large: {} x {} px; up to {} megapixels are played",
                                     width, height, max_animation_pixels / 1'000'000));
    const std::int64_t most =
        std::min<std::int64_t>(max_animation_pictures, max_animation_rows / std::max(height, 1));
    if (pictures > most)
        throw MediaError(
            MediaState::unsupported,
            fmt::format("the animation is too long: {} pictures; up to {} of this height are played; "
                        "H.264 in MP4 may be of any length",
                        pictures, most));
}

std::chrono::nanoseconds picture_duration(std::chrono::nanoseconds said) {
    return said <= mistaken_duration ? usual_duration : said;
}

}  // namespace vitrine
