#pragma once

#include "base/media/gst_ptr.hpp"

#include <gst/allocators/gstdmabuf.h>
#include <gst/video/video.h>

#include <string>
#include <vector>

namespace vitrine::player {

struct PlanePlace {
    gsize offset = 0;  // bytes
    int stride = 0;
};

/// A frame as a hardware decoder hands it over.
/// @param file    descriptor of the memory, given away
/// @param places  of the planes; none: as usual, without saying so
inline GstPtr<GstSample> shared_sample(int file, gsize bytes, const std::string& caps, GstVideoFormat format,
                                       int width, int height, const std::vector<PlanePlace>& places = {}) {
    start_gstreamer();
    GstAllocator* allocator = gst_dmabuf_allocator_new();
    GstBuffer* buffer = gst_buffer_new();
    gst_buffer_append_memory(buffer, gst_dmabuf_allocator_alloc(allocator, file, bytes));
    gst_object_unref(allocator);
    gsize offsets[GST_VIDEO_MAX_PLANES] = {};
    gint strides[GST_VIDEO_MAX_PLANES] = {};
    for (std::size_t i = 0; i < places.size(); ++i) {
        offsets[i] = places[i].offset;
        strides[i] = places[i].stride;
    }
    if (!places.empty())
        gst_buffer_add_video_meta_full(buffer, GST_VIDEO_FRAME_FLAG_NONE, format, static_cast<guint>(width),
                                       static_cast<guint>(height), static_cast<guint>(places.size()), offsets,
                                       strides);
    const GstPtr<GstCaps> parsed(gst_caps_from_string(caps.c_str()));
    GstPtr<GstSample> sample(gst_sample_new(buffer, parsed.get(), nullptr, nullptr));
    gst_buffer_unref(buffer);
    return sample;
}

}  // namespace vitrine::player
