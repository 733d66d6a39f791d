#include "player/playback/shared_frame.hpp"

#include <gst/allocators/gstdmabuf.h>
#include <gst/video/video.h>

#include <charconv>
#include <string_view>

namespace vitrine::player {

namespace {

struct Description {
    GstVideoInfo info;
    std::optional<std::uint64_t> modifier;
};

// Reads DRM's name of a format such as "NV12:0x0100000000000001"; without a number: row by row.
bool read_drm_format(std::string_view words, Description& made) {
    const std::string_view name = words.substr(0, words.find(':'));
    if (name != "NV12" && name != "YU12") return false;
    gst_video_info_set_format(&made.info, name == "NV12" ? GST_VIDEO_FORMAT_NV12 : GST_VIDEO_FORMAT_I420,
                              static_cast<guint>(made.info.width), static_cast<guint>(made.info.height));
    if (name.size() == words.size()) return true;
    std::string_view number = words.substr(name.size() + 1);
    if (!number.starts_with("0x")) return false;
    number.remove_prefix(2);
    std::uint64_t modifier = 0;
    const char* const end = number.data() + number.size();
    const auto [stop, error] = std::from_chars(number.data(), end, modifier, 16);
    made.modifier = modifier;
    return error == std::errc() && stop == end;
}

std::optional<Description> described(const GstCaps* caps) {
    Description made{};
    if (caps == nullptr) return std::nullopt;
    const GstStructure* words = gst_caps_get_structure(caps, 0);
    const char* const drm_format = gst_structure_get_string(words, "drm-format");
    if (drm_format == nullptr)
        return gst_video_info_from_caps(&made.info, caps) ? std::optional(made) : std::nullopt;
    gst_video_info_init(&made.info);
    if (!gst_structure_get_int(words, "width", &made.info.width) ||
        !gst_structure_get_int(words, "height", &made.info.height) || !read_drm_format(drm_format, made))
        return std::nullopt;
    const char* const colours = gst_structure_get_string(words, "colorimetry");
    if (colours != nullptr) gst_video_colorimetry_from_string(&made.info.colorimetry, colours);
    return made;
}

// The memory that a plane starts in. None: it is not shared.
std::optional<SharedPlanes::Plane> shared_plane(GstBuffer* buffer, gsize offset, int stride) {
    guint first = 0;
    guint count = 0;
    gsize skipped = 0;
    if (!gst_buffer_find_memory(buffer, offset, 1, &first, &count, &skipped)) return std::nullopt;
    GstMemory* memory = gst_buffer_peek_memory(buffer, first);
    if (!gst_is_dmabuf_memory(memory)) return std::nullopt;
    return SharedPlanes::Plane{.file = gst_dmabuf_memory_get_fd(memory),
                               .offset = static_cast<std::uint32_t>(memory->offset + skipped),
                               .stride = static_cast<std::uint32_t>(stride)};
}

GstPadProbeReturn answer(GstPad*, GstPadProbeInfo* info, gpointer) {
    GstQuery* query = gst_pad_probe_info_get_query(info);
    if (GST_QUERY_TYPE(query) != GST_QUERY_ALLOCATION) return GST_PAD_PROBE_OK;
    gst_query_add_allocation_meta(query, GST_VIDEO_META_API_TYPE, nullptr);
    return GST_PAD_PROBE_HANDLED;
}

}  // namespace

ColourCode colour_code(const GstVideoColorimetry& colours) {
    ColourCode code{.is_full_range = colours.range == GST_VIDEO_COLOR_RANGE_0_255};
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT709) code.matrix = ColourCode::Matrix::bt709;
    if (colours.matrix == GST_VIDEO_COLOR_MATRIX_BT2020) code.matrix = ColourCode::Matrix::bt2020;
    return code;
}

void let_planes_lie(GstPad* pad) {
    gst_pad_add_probe(pad, GST_PAD_PROBE_TYPE_QUERY_DOWNSTREAM, &answer, nullptr, nullptr);
}

std::optional<Sample> shared_frame(GstSample* frame) {
    GstBuffer* buffer = gst_sample_get_buffer(frame);
    if (buffer == nullptr || gst_buffer_n_memory(buffer) == 0 ||
        !gst_is_dmabuf_memory(gst_buffer_peek_memory(buffer, 0)))
        return std::nullopt;
    const std::optional<Description> description = described(gst_sample_get_caps(frame));
    if (!description) return std::nullopt;
    const GstVideoInfo& info = description->info;
    const GstVideoFormat format = GST_VIDEO_INFO_FORMAT(&info);
    if (format != GST_VIDEO_FORMAT_NV12 && format != GST_VIDEO_FORMAT_I420) return std::nullopt;
    const GstVideoMeta* meta = gst_buffer_get_video_meta(buffer);
    SharedPlanes shared{.planes = {}, .modifier = description->modifier};
    for (guint i = 0; i < GST_VIDEO_INFO_N_PLANES(&info); ++i) {
        const auto plane = shared_plane(buffer, meta ? meta->offset[i] : info.offset[i],
                                        meta ? meta->stride[i] : info.stride[i]);
        if (!plane) return std::nullopt;
        shared.planes.at(i) = *plane;
    }
    Sample made{.width = info.width,
                .height = info.height,
                .layout = format == GST_VIDEO_FORMAT_NV12 ? PixelLayout::nv12 : PixelLayout::i420,
                .colours = colour_code(info.colorimetry)};
    made.owner = std::shared_ptr<GstSample>(gst_sample_ref(frame), &gst_sample_unref);
    made.shared = shared;
    return made;
}

}  // namespace vitrine::player
