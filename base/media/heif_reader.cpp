#include "base/media/heif_reader.hpp"

#include "base/media/file_bytes.hpp"
#include "base/media/photo_file.hpp"
#include "base/media/picture.hpp"
#include "base/state/media_error.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <new>

namespace vitrine {

namespace {

using Context = Handle<heif_context, &heif_context_free>;
using ImageHandle = Handle<const heif_image_handle, &heif_image_handle_release>;
using Options = Handle<heif_decoding_options, &heif_decoding_options_free>;

void require(const heif_error& error) {
    if (error.code == heif_error_Ok) return;
    if (error.subcode == heif_suberror_Security_limit_exceeded)
        throw picture_failure(PictureFailure::too_large, error.message);
    const bool is_unknown = error.code == heif_error_Unsupported_feature ||
                            error.code == heif_error_Unsupported_filetype ||
                            error.subcode == heif_suberror_Nonexisting_item_referenced;  // an item is missing
    throw picture_failure(is_unknown ? PictureFailure::unknown_coding : PictureFailure::damaged,
                          error.message);
}

ImageHandle main_picture(heif_context* context) {
    heif_image_handle* handle = nullptr;
    const heif_error error = heif_context_get_primary_image_handle(context, &handle);
    ImageHandle picture(handle);
    require(error);
    const int width = heif_image_handle_get_ispe_width(handle);  // the coded width, before the crop
    const int height = heif_image_handle_get_ispe_height(handle);
    if (width <= 0 || height <= 0) throw picture_failure(PictureFailure::damaged, "no size");
    require_within_limits({.width = width, .height = height});
    return picture;
}

std::vector<std::byte> profile_of(const heif_image_handle* picture) {
    const auto type = heif_image_handle_get_color_profile_type(picture);
    if (type != heif_color_profile_type_rICC && type != heif_color_profile_type_prof) return {};
    std::vector<std::byte> profile(heif_image_handle_get_raw_color_profile_size(picture));
    require(heif_image_handle_get_raw_color_profile(picture, profile.data()));
    return profile;
}

Handle<heif_image, &heif_image_release> decoded(const heif_image_handle* picture, int channels) {
    const Options options(heif_decoding_options_alloc());
    if (!options) throw std::bad_alloc();
    options->convert_hdr_to_8bit = 1;
    heif_image* out = nullptr;
    const auto chroma = channels == 4 ? heif_chroma_interleaved_RGBA : heif_chroma_interleaved_RGB;
    const heif_error error = heif_decode_image(picture, &out, heif_colorspace_RGB, chroma, options.get());
    Handle<heif_image, &heif_image_release> image(out);
    require(error);
    return image;
}

// The call-backs by which libheif reads a PhotoFile.
constexpr heif_reader photo_reader{
    .reader_api_version = 1,
    .get_position = [](void* file) { return static_cast<PhotoFile*>(file)->position(); },
    .read =
        [](void* to, std::size_t size, void* file) {
            const auto got = static_cast<PhotoFile*>(file)->read({static_cast<std::byte*>(to), size});
            return got == static_cast<std::int64_t>(size) ? 0 : 1;
        },
    .seek = [](std::int64_t position,
               void* file) { return static_cast<PhotoFile*>(file)->seek(position) == position ? 0 : 1; },
    .wait_for_file_size =
        [](std::int64_t size, void* file) {
            return size <= static_cast<PhotoFile*>(file)->size() ? heif_reader_grow_status_size_reached
                                                                 : heif_reader_grow_status_size_beyond_eof;
        }};

// Reverses the multiplication of colours by their alpha.
void straighten(std::uint8_t* row, int width) {
    for (int x = 0; x < width; ++x, row += 4)
        for (int i = 0; i < 3 && row[3] > 0; ++i)
            row[i] = static_cast<std::uint8_t>(std::min(255, (row[i] * 255 + row[3] / 2) / row[3]));
}

Context opened(PhotoFile& file) {
    Context context(heif_context_alloc());
    if (!context) throw std::bad_alloc();
    heif_context_set_max_decoding_threads(context.get(), 0);  // in this thread
    heif_context_set_maximum_image_size_limit(context.get(), max_still_side);
    require(heif_context_read_from_reader(context.get(), &photo_reader, &file, nullptr));
    return context;
}

/// The place of the TIFF header comes first, in four bytes.
std::vector<std::byte> exif_of(PhotoFile& file) {
    constexpr std::size_t max_exif = std::size_t{1} << 20;  // bytes
    constexpr std::size_t head = 4;
    const Context context = opened(file);
    const ImageHandle picture = main_picture(context.get());
    heif_item_id block = 0;
    if (heif_image_handle_get_list_of_metadata_block_IDs(picture.get(), "Exif", &block, 1) != 1) return {};
    std::vector<std::byte> bytes(heif_image_handle_get_metadata_size(picture.get(), block));
    if (bytes.size() <= head || bytes.size() > max_exif) return {};
    require(heif_image_handle_get_metadata(picture.get(), block, bytes.data()));
    const std::size_t skipped = big_endian(bytes, 0, head);
    if (skipped >= bytes.size() - head) return {};
    bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(head + skipped));
    return bytes;
}

HeifPicture decode_heif(PhotoFile& file) {
    const Context context = opened(file);
    const ImageHandle source = main_picture(context.get());
    HeifPicture picture;
    picture.channels = heif_image_handle_has_alpha_channel(source.get()) != 0 ? 4 : 3;
    const bool is_premultiplied =
        picture.channels == 4 && heif_image_handle_is_premultiplied_alpha(source.get()) != 0;
    picture.profile = profile_of(source.get());
    picture.image = decoded(source.get(), picture.channels);
    // The header's size of a turned picture depends on the order of its boxes; the decoded size is always
    // right.
    picture.width = heif_image_get_width(picture.image.get(), heif_channel_interleaved);
    picture.height = heif_image_get_height(picture.image.get(), heif_channel_interleaved);
    int stride = 0;
    std::uint8_t* plane = heif_image_get_plane(picture.image.get(), heif_channel_interleaved, &stride);
    if (!plane || picture.width <= 0 || picture.height <= 0)
        throw picture_failure(PictureFailure::damaged, "nothing decoded");
    const std::size_t row_bytes =
        static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.channels);
    for (int row = 0; row < picture.height; ++row) {
        std::uint8_t* to = plane + static_cast<std::size_t>(row) * row_bytes;
        std::memmove(to, plane + static_cast<std::ptrdiff_t>(row) * stride, row_bytes);
        if (is_premultiplied) straighten(to, picture.width);
    }
    picture.pixels = {reinterpret_cast<const std::byte*>(plane),
                      row_bytes * static_cast<std::size_t>(picture.height)};
    return picture;
}

/// A fault of the file's transport counts before what libheif makes of it.
template <typename Read> auto read_with(const std::string& path, const Read& read) {
    PhotoFile file(path);
    try {
        return read(file);
    } catch (const MediaError&) {
        file.throw_fault();
        throw;
    }
}

}  // namespace

HeifPicture read_heif(const std::string& path) {
    return read_with(path, decode_heif);
}

std::vector<std::byte> heif_exif(const std::string& path) {
    return read_with(path, exif_of);
}

}  // namespace vitrine
