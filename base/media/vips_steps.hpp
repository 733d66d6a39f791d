#pragma once

#include "base/media/colour.hpp"
#include "base/media/photo_file.hpp"
#include "base/state/media_error.hpp"

#include <vips/vips.h>

#include <cstddef>
#include <memory>
#include <span>

namespace vitrine {

// The parts of reading pictures with libvips. Files are passed as sources, never by name, because libvips and
// its loaders find options, patterns and protocols in names.

struct VipsUnref {
    void operator()(VipsImage* image) const { g_object_unref(image); }

    void operator()(VipsSource* source) const { g_object_unref(source); }

    void operator()(VipsTarget* target) const { g_object_unref(target); }

    void operator()(VipsRegion* region) const { g_object_unref(region); }
};

/// The only owner of one reference.
template <typename T> using VipsPtr = std::unique_ptr<T, VipsUnref>;

/// The failure that libvips has noted, in plain words.
MediaError vips_failure();

/// Runs one libvips call. `call` gets the place for its picture and returns 0 for success.
/// @throws MediaError if the call fails
template <typename Call> VipsPtr<VipsImage> step(const Call& call) {
    VipsImage* out = nullptr;
    const int failed = call(&out);
    VipsPtr<VipsImage> image(out);
    if (failed != 0 || !image) throw vips_failure();
    return image;
}

/// A source that begins at the file's first byte.
/// @param file  outlives it
VipsPtr<VipsSource> open_source(PhotoFile& file);

/// Wraps pixels without a copy; they must outlive the returned picture. 8-bit sRGB.
VipsPtr<VipsImage> lent_image(std::span<const std::byte> pixels, int width, int height, int bands);

/// Converts any number of bands, depth and colour space to three bands of 8-bit sRGB over the background.
VipsPtr<VipsImage> opaque(VipsImage* any, Colour background);

}  // namespace vitrine
