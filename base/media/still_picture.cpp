// libvips reads all photo formats but BMP and HEIF. It shrinks a photo while it decodes it, so that a hundred
// megapixels cost as much as their thumbnail.

#include "base/media/still_picture.hpp"

#include "base/media/bitmap_reader.hpp"
#include "base/media/completeness.hpp"
#include "base/media/heif_reader.hpp"
#include "base/media/media_type.hpp"
#include "base/media/photo_file.hpp"
#include "base/media/picture.hpp"
#include "base/media/vips_steps.hpp"
#include "base/state/media_error.hpp"

#include <fmt/format.h>
#include <vips/vips.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <mutex>
#include <span>
#include <stdexcept>
#include <string_view>

namespace vitrine {

namespace {

// Opens a picture, at 1/shrink of its size if the format is then cheaper to decode. It can be read once, from
// the top down.
VipsPtr<VipsImage> open_picture(PhotoFile& file, MediaFormat format, int shrink = 1) {
    const VipsPtr<VipsSource> source = open_source(file);
    VipsSource* from = source.get();
    const VipsAccess once = VIPS_ACCESS_SEQUENTIAL;
    const VipsFailOn errors = VIPS_FAIL_ON_ERROR;  // a cut file is an error
    return step([&](auto** out) {
        switch (format) {
        case MediaFormat::jpeg:
            return vips_jpegload_source(from, out, "access", once, "fail_on", errors, "shrink", shrink,
                                        nullptr);
        case MediaFormat::webp:
            return vips_webpload_source(from, out, "access", once, "fail_on", errors, "scale", 1.0 / shrink,
                                        nullptr);
        case MediaFormat::png:
            return vips_pngload_source(from, out, "access", once, "fail_on", errors, nullptr);
        case MediaFormat::gif:
            return vips_gifload_source(from, out, "access", once, "fail_on", errors, nullptr);
        case MediaFormat::tiff:
            return vips_tiffload_source(from, out, "access", once, "fail_on", errors, nullptr);
        default:
            throw MediaError(MediaState::unsupported, "this is a film, not a picture");
        }
    });
}

// The part of the shrinking that the decoder does. The resampler does the last factor of two, for better
// quality.
int decoder_shrink(const StillInfo& info, int max_width, int max_height) {
    const double wanted =
        std::max(static_cast<double>(info.width) / max_width, static_cast<double>(info.height) / max_height);
    int shrink = 1;
    while (shrink < 8 && shrink * 4 <= wanted)
        shrink *= 2;
    return shrink;
}

// The upright size from the header, for the formats that libvips reads.
StillInfo header_size(PhotoFile& file, MediaFormat format) {
    const VipsPtr<VipsImage> image = open_picture(file, format);
    StillInfo info{.width = vips_image_get_width(image.get()), .height = vips_image_get_height(image.get())};
    if (vips_image_get_orientation_swap(image.get())) std::swap(info.width, info.height);
    require_within_limits(info);
    return info;
}

// Shrinks a picture and turns it upright. Converts its colours to sRGB if the file has a profile; else they
// keep their space.
VipsPtr<VipsImage> shrunk(VipsImage* image, int max_width, int max_height) {
    // Without a profile the conversion only costs accuracy: ten levels of a plain red.
    const char* profile = vips_image_get_typeof(image, VIPS_META_ICC_NAME) != 0 ? "srgb" : nullptr;
    return step([&](auto** out) {
        return vips_thumbnail_image(image, out, max_width, "height", max_height, "size", VIPS_SIZE_DOWN,
                                    profile ? "export_profile" : nullptr, profile, nullptr);
    });
}

StillPicture in_memory(VipsImage* any, StillInfo full, Colour background) {
    const VipsPtr<VipsImage> colours = opaque(any, background);
    constexpr int bands = 4;
    if (vips_image_get_bands(colours.get()) != bands - 1)
        throw MediaError(MediaState::unsupported, "the picture has an unusual number of channels");
    const VipsPtr<VipsImage> image =
        step([&](auto** out) { return vips_bandjoin_const1(colours.get(), out, 255, nullptr); });
    std::size_t bytes = 0;
    const std::unique_ptr<void, void (*)(void*)> pixels(vips_image_write_to_memory(image.get(), &bytes),
                                                        g_free);
    if (!pixels) throw vips_failure();
    const auto* first = static_cast<const std::byte*>(pixels.get());
    return {.width = vips_image_get_width(image.get()),
            .height = vips_image_get_height(image.get()),
            .full = full,
            .pixels = std::vector<std::byte>(first, first + bytes)};
}

VipsPtr<VipsImage> lent_heif(const HeifPicture& picture) {
    VipsPtr<VipsImage> image = lent_image(picture.pixels, picture.width, picture.height, picture.channels);
    if (!picture.profile.empty())
        vips_image_set_blob_copy(image.get(), VIPS_META_ICC_NAME, picture.profile.data(),
                                 picture.profile.size());
    return image;
}

/// Writes a picture into a file, in colours that any reader takes for sRGB, with its transparency and without
/// the camera's metadata: a WebP if it is transparent, else a JPEG.
void save(VipsImage* any, const std::string& to) {
    constexpr int quality = 90;
    VipsPtr<VipsImage> image =
        step([&](auto** out) { return vips_colourspace(any, out, VIPS_INTERPRETATION_sRGB, nullptr); });
    image = step([&](auto** out) { return vips_cast_uchar(image.get(), out, nullptr); });
    const VipsPtr<VipsTarget> target(vips_target_new_to_file(to.c_str()));
    if (!target) throw vips_failure();
    constexpr int min_effort = 1;
    const int failed =
        vips_image_hasalpha(image.get())
            ? vips_webpsave_target(image.get(), target.get(), "Q", quality, "effort", min_effort, "strip",
                                   TRUE, nullptr)
            : vips_jpegsave_target(image.get(), target.get(), "Q", quality, "strip", TRUE, nullptr);
    if (failed != 0) throw vips_failure();
}

/// Opens a photo, upright and shrunk, calls `use` with it and its full size, and returns the result.
template <typename Use>
auto with_still(const std::string& path, int max_width, int max_height, const Use& use) {
    const MediaFormat format = still_format(media_format(path));
    require_complete(path, format);
    start_vips();
    vips_error_clear();  // errors of earlier calls
    const auto finished = [&](VipsImage* image, StillInfo full) {
        return use(shrunk(image, max_width, max_height).get(), full);
    };
    if (format == MediaFormat::bmp) {
        const StillPicture all = read_bitmap(path);
        return finished(lent_image(all.pixels, all.width, all.height, 4).get(), all.full);
    }
    if (format == MediaFormat::heif) {
        const HeifPicture all = read_heif(path);
        return finished(lent_heif(all).get(), {.width = all.width, .height = all.height});
    }
    PhotoFile file(path);
    try {
        const StillInfo full = header_size(file, format);  // checks the limits before anything is decoded
        return finished(open_picture(file, format, decoder_shrink(full, max_width, max_height)).get(), full);
    } catch (const MediaError&) {
        file.throw_fault();
        throw;
    }
}

}  // namespace

void init_vips() {
    static std::once_flag once;
    std::call_once(once, [] {
        // libvips looks for its modules below this folder. None is needed: they would bring ImageMagick, PDF
        // and slides of microscopes into this process, and a tenth of a second for loading them.
        ::setenv("VIPSHOME", "/var/empty", 1);
        if (vips_init("vitrine") != 0)
            throw std::runtime_error(fmt::format("start libvips: {}", vips_error_buffer()));
    });
}

void start_vips() {
    static std::once_flag once;
    std::call_once(once, [] {
        init_vips();
        vips_block_untrusted_set(TRUE);  // only loaders that are fuzzed: no SVG, PDF, ImageMagick
        vips_cache_set_max(0);           // no file is read twice
        vips_concurrency_set(1);
        g_log_set_handler(
            "VIPS", static_cast<GLogLevelFlags>(G_LOG_LEVEL_WARNING | G_LOG_LEVEL_INFO),
            [](const gchar*, GLogLevelFlags, const gchar*, gpointer) {}, nullptr);
    });
}

StillPicture load_still(const std::string& path, int max_width, int max_height, Colour background) {
    return with_still(path, max_width, max_height,
                      [&](VipsImage* image, StillInfo full) { return in_memory(image, full, background); });
}

void save_smaller(const std::string& path, int max_side, const std::string& to) {
    with_still(path, max_side, max_side, [&](VipsImage* image, StillInfo) { save(image, to); });
}

}  // namespace vitrine
