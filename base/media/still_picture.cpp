// libvips reads all still formats but BMP with one set of rules: shrinking while it decodes, so that a photo
// of a hundred megapixels costs what its thumbnail costs. Files go in as sources, never by name, because
// libvips and its loaders read options, patterns and protocols in names.

#include "base/media/still_picture.hpp"

#include "base/catalogue/media_error.hpp"
#include "base/media/bitmap_reader.hpp"
#include "base/media/completeness.hpp"
#include "base/media/media_type.hpp"

#include <fmt/format.h>
#include <vips/vips.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string_view>

namespace vitrine {

namespace {

struct VipsUnref {
    void operator()(VipsImage* image) const { g_object_unref(image); }

    void operator()(VipsSource* source) const { g_object_unref(source); }
};

template <typename T> using VipsPtr = std::unique_ptr<T, VipsUnref>;

void start_vips() {
    static std::once_flag once;
    std::call_once(once, [] {
        if (vips_init("vitrine") != 0)
            throw std::runtime_error(fmt::format("start libvips: {}", vips_error_buffer()));
        vips_block_untrusted_set(TRUE);  // only loaders that are fuzzed: no SVG, PDF, ImageMagick
        vips_cache_set_max(0);           // no file is read twice
        vips_concurrency_set(1);
        g_log_set_handler(
            "VIPS", static_cast<GLogLevelFlags>(G_LOG_LEVEL_WARNING | G_LOG_LEVEL_INFO),
            [](const gchar*, GLogLevelFlags, const gchar*, gpointer) {}, nullptr);
    });
}

// libvips says in words what each library underneath said: what they say of files that end too soon.
constexpr std::array signs_of_a_cut{"premature end", "truncated",      "unexpected end", "end of file",
                                    "end of input",  "unexpected eof", "bad seek to",    "not enough",
                                    "out of data",   "too short"};

MediaError vips_failure() {
    const std::string said = vips_error_buffer();
    vips_error_clear();
    const std::unique_ptr<gchar, void (*)(void*)> lower(g_ascii_strdown(said.c_str(), -1), g_free);
    const std::string_view words = lower.get();
    if (std::ranges::any_of(signs_of_a_cut, [&](auto sign) { return words.find(sign) != words.npos; }))
        return {MediaState::waiting, "the copy is not complete: part of the picture is missing"};
    return {MediaState::failed, fmt::format("the picture is damaged: {}", said.substr(0, said.find('\n')))};
}

/// One libvips call: `call` is given the place for its picture and returns 0 where it worked.
/// @throws MediaError where it failed
template <typename Call> VipsPtr<VipsImage> step(const Call& call) {
    VipsImage* out = nullptr;
    const int failed = call(&out);
    VipsPtr<VipsImage> image(out);
    if (failed != 0 || !image) throw vips_failure();
    return image;
}

VipsPtr<VipsSource> open_source(const std::string& path) {
    VipsPtr<VipsSource> source(vips_source_new_from_file(path.c_str()));
    if (!source) throw vips_failure();
    return source;
}

// Opens a picture 1/shrink of its size where its format is decoded cheaper so; read from top to bottom, once.
VipsPtr<VipsImage> open_picture(const std::string& path, MediaFormat format, int shrink = 1) {
    const VipsPtr<VipsSource> source = open_source(path);
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
        case MediaFormat::heif:
            return vips_heifload_source(from, out, "access", once, "fail_on", errors, nullptr);
        default:
            throw MediaError(MediaState::unsupported, "this is a film, not a picture");
        }
    });
}

// How much of the shrinking the decoder can do; the last factor of two is the resampler's, for a clean
// picture.
int decoder_shrink(const StillInfo& info, int max_width, int max_height) {
    const double wanted =
        std::max(static_cast<double>(info.width) / max_width, static_cast<double>(info.height) / max_height);
    int shrink = 1;
    while (shrink < 8 && shrink * 4 <= wanted)
        shrink *= 2;
    return shrink;
}

void require_within_limits(const StillInfo& info) {
    if (info.width > max_still_side || info.height > max_still_side ||
        std::int64_t{info.width} * info.height > max_still_pixels)
        throw MediaError(MediaState::unsupported,
                         fmt::format("the picture is too large: {} x {} px; up to {} megapixels are shown",
                                     info.width, info.height, max_still_pixels / 1'000'000));
}

StillInfo probe(const std::string& path, MediaFormat format) {
    if (format == MediaFormat::bmp) return probe_bitmap(path);
    require_complete(path, format);
    start_vips();
    vips_error_clear();  // what others left
    const VipsPtr<VipsImage> image = open_picture(path, format);
    StillInfo info{.width = vips_image_get_width(image.get()), .height = vips_image_get_height(image.get())};
    if (vips_image_get_orientation_swap(image.get())) std::swap(info.width, info.height);
    require_within_limits(info);
    return info;
}

// No larger than asked, upright, in sRGB where the file says what its colours are, in its own space where
// not.
VipsPtr<VipsImage> shrunk(VipsImage* image, int max_width, int max_height) {
    // Without a profile in the file the conversion would only cost accuracy: ten levels of a plain red.
    const char* profile = vips_image_get_typeof(image, VIPS_META_ICC_NAME) != 0 ? "srgb" : nullptr;
    return step([&](auto** out) {
        return vips_thumbnail_image(image, out, max_width, "height", max_height, "size", VIPS_SIZE_DOWN,
                                    profile ? "export_profile" : nullptr, profile, nullptr);
    });
}

// `picture` is lent to what is returned.
VipsPtr<VipsImage> lent_image(const StillPicture& picture) {
    VipsPtr<VipsImage> image = step([&](auto** out) {
        *out = vips_image_new_from_memory(picture.pixels.data(), picture.pixels.size(), picture.width,
                                          picture.height, 4, VIPS_FORMAT_UCHAR);
        return *out ? 0 : -1;
    });
    image->Type = VIPS_INTERPRETATION_sRGB;
    return image;
}

// Any number of bands, depth and colour space to three bands of 8-bit sRGB over the background.
VipsPtr<VipsImage> opaque(VipsImage* any, Colour background) {
    VipsPtr<VipsImage> image =
        step([&](auto** out) { return vips_colourspace(any, out, VIPS_INTERPRETATION_sRGB, nullptr); });
    image = step([&](auto** out) { return vips_cast_uchar(image.get(), out, nullptr); });
    if (!vips_image_hasalpha(image.get())) return image;
    const std::array<double, 3> colour{double(background.red), double(background.green),
                                       double(background.blue)};
    const std::unique_ptr<VipsArrayDouble, void (*)(VipsArrayDouble*)> array(
        vips_array_double_new(colour.data(), 3),
        [](VipsArrayDouble* owned) { vips_area_unref(VIPS_AREA(owned)); });
    return step(
        [&](auto** out) { return vips_flatten(image.get(), out, "background", array.get(), nullptr); });
}

StillPicture in_memory(VipsImage* any, Colour background) {
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
            .pixels = std::vector<std::byte>(first, first + bytes)};
}

}  // namespace

StillInfo probe_still(const std::string& path) {
    return probe(path, media_format(path));
}

StillPicture load_still(const std::string& path, int max_width, int max_height, Colour background) {
    const MediaFormat format = media_format(path);
    const StillInfo info = probe(path, format);  // the limits, before anything is decoded
    start_vips();
    if (format == MediaFormat::bmp) {
        const StillPicture full = read_bitmap(path);
        return in_memory(shrunk(lent_image(full).get(), max_width, max_height).get(), background);
    }
    const auto image = open_picture(path, format, decoder_shrink(info, max_width, max_height));
    return in_memory(shrunk(image.get(), max_width, max_height).get(), background);
}

}  // namespace vitrine
