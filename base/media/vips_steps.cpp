#include "base/media/vips_steps.hpp"

#include "base/media/picture.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace vitrine {

namespace {

// The libraries' texts for a JPEG or GIF that ends too soon. Other formats declare their length
// (completeness.hpp). "Premature end of data segment" means damage.
constexpr std::array signs_of_a_cut{"premature end of jpeg", "premature end of input", "unexpected end of",
                                    "vipssource: end of file"};

gint64 read_photo(VipsSourceCustom* /*source*/, void* to, gint64 length, gpointer file) {
    return static_cast<PhotoFile*>(file)->read(
        {static_cast<std::byte*>(to), static_cast<std::size_t>(length)});
}

gint64 seek_photo(VipsSourceCustom* /*source*/, gint64 offset, int whence, gpointer file) {
    return static_cast<PhotoFile*>(file)->seek(offset, whence);
}

}  // namespace

MediaError vips_failure() {
    const std::string said = vips_error_buffer();
    vips_error_clear();
    const std::unique_ptr<gchar, void (*)(void*)> lower(g_ascii_strdown(said.c_str(), -1), g_free);
    const std::string_view words = lower.get();
    const bool is_cut =
        std::ranges::any_of(signs_of_a_cut, [&](auto sign) { return words.find(sign) != words.npos; });
    return picture_failure(is_cut ? PictureFailure::cut_short : PictureFailure::damaged, said);
}

VipsPtr<VipsSource> open_source(PhotoFile& file) {
    file.seek(0);
    VipsSourceCustom* const source = vips_source_custom_new();
    g_signal_connect(source, "read", G_CALLBACK(read_photo), &file);
    g_signal_connect(source, "seek", G_CALLBACK(seek_photo), &file);
    return VipsPtr<VipsSource>(VIPS_SOURCE(source));
}

VipsPtr<VipsImage> lent_image(std::span<const std::byte> pixels, int width, int height, int bands) {
    VipsPtr<VipsImage> image = step([&](auto** out) {
        *out =
            vips_image_new_from_memory(pixels.data(), pixels.size(), width, height, bands, VIPS_FORMAT_UCHAR);
        return *out ? 0 : -1;
    });
    image->Type = VIPS_INTERPRETATION_sRGB;
    return image;
}

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

}  // namespace vitrine
