#include "player/playback/picture_scaler.hpp"

#include "player/playback/shared_frame.hpp"

extern "C" {
#include <libswscale/swscale.h>
}

#include <array>
#include <cstdint>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::size_t row_alignment = 64;  // bytes: the scaler's widest words write beyond a row's end
constexpr int max_enlarged = 2;            // planes larger than this many times the size are scaled down

/// The readable memory of a decoded frame. It stays mapped, and its buffer is kept, while this lives.
class MappedFrame {
  public:
    explicit MappedFrame(GstSample* sample) {
        GstVideoInfo info;
        const GstCaps* caps = gst_sample_get_caps(sample);
        if (caps == nullptr || !gst_video_info_from_caps(&info, caps)) return;
        is_mapped_ =
            gst_video_frame_map(&frame_, &info, gst_sample_get_buffer(sample), GST_MAP_READ) != FALSE;
    }

    MappedFrame(const MappedFrame&) = delete;
    MappedFrame& operator=(const MappedFrame&) = delete;
    MappedFrame(MappedFrame&&) = delete;
    MappedFrame& operator=(MappedFrame&&) = delete;

    ~MappedFrame() {
        if (is_mapped_) gst_video_frame_unmap(&frame_);
    }

    bool is_mapped() const { return is_mapped_; }

    const GstVideoFrame& frame() const { return frame_; }

  private:
    GstVideoFrame frame_{};
    bool is_mapped_ = false;
};

std::optional<AVPixelFormat> format_of(GstVideoFormat format) {
    switch (format) {
    case GST_VIDEO_FORMAT_I420:
        return AV_PIX_FMT_YUV420P;
    case GST_VIDEO_FORMAT_NV12:
        return AV_PIX_FMT_NV12;
    case GST_VIDEO_FORMAT_Y42B:
        return AV_PIX_FMT_YUV422P;
    case GST_VIDEO_FORMAT_Y444:
        return AV_PIX_FMT_YUV444P;
    case GST_VIDEO_FORMAT_I420_10LE:
        return AV_PIX_FMT_YUV420P10LE;
    case GST_VIDEO_FORMAT_RGBx:
        return AV_PIX_FMT_RGB0;
    default:
        return std::nullopt;
    }
}

const int* coefficients(ColourCode::Matrix matrix) {
    switch (matrix) {
    case ColourCode::Matrix::bt709:
        return sws_getCoefficients(SWS_CS_ITU709);
    case ColourCode::Matrix::bt2020:
        return sws_getCoefficients(SWS_CS_BT2020);
    case ColourCode::Matrix::bt601:
        break;
    }
    return sws_getCoefficients(SWS_CS_ITU601);
}

std::size_t aligned(std::size_t bytes) {
    return (bytes + row_alignment - 1) / row_alignment * row_alignment;
}

/// An empty picture; its planes lie one after another in one block.
Sample empty_picture(PictureMemory& memory, int width, int height, PixelLayout layout) {
    const auto rows = static_cast<std::size_t>(height);
    const auto columns = static_cast<std::size_t>(width);
    const bool is_bgra = layout == PixelLayout::bgra;
    const std::size_t stride = aligned(is_bgra ? columns * 4 : columns);
    const std::size_t half = aligned((columns + 1) / 2);
    const std::size_t half_bytes = is_bgra ? 0 : half * ((rows + 1) / 2);
    const auto block = memory.block(stride * rows + 2 * half_bytes + row_alignment);
    const std::byte* bytes = block.get();
    Sample picture{.width = width,
                   .height = height,
                   .stride = stride,
                   .pixels = {bytes, stride * rows},
                   .layout = layout,
                   .owner = block};
    if (is_bgra) return picture;
    picture.chroma[0] = {half, {bytes + stride * rows, half_bytes}};
    picture.chroma[1] = {half, {bytes + stride * rows + half_bytes, half_bytes}};
    return picture;
}

Sample lent(std::shared_ptr<const MappedFrame> mapped, PixelLayout layout, const ColourCode& colours) {
    const GstVideoFrame& frame = mapped->frame();
    const auto plane = [&](unsigned index) {
        const auto stride = static_cast<std::size_t>(GST_VIDEO_FRAME_PLANE_STRIDE(&frame, index));
        const int rows = GST_VIDEO_FRAME_COMP_HEIGHT(&frame, index);
        const auto* bytes = static_cast<const std::byte*>(GST_VIDEO_FRAME_PLANE_DATA(&frame, index));
        return Sample::Plane{stride, {bytes, stride * static_cast<std::size_t>(rows)}};
    };
    Sample picture{.width = GST_VIDEO_FRAME_WIDTH(&frame),
                   .height = GST_VIDEO_FRAME_HEIGHT(&frame),
                   .stride = plane(0).stride,
                   .pixels = plane(0).bytes,
                   .layout = layout,
                   .colours = colours};
    picture.chroma[0] = plane(1);
    if (layout == PixelLayout::i420) picture.chroma[1] = plane(2);
    picture.owner = std::move(mapped);
    return picture;
}

bool is_far_larger(const GstVideoFrame& frame, int width, int height) {
    return GST_VIDEO_FRAME_WIDTH(&frame) > max_enlarged * width ||
           GST_VIDEO_FRAME_HEIGHT(&frame) > max_enlarged * height;
}

}  // namespace

void PictureScaler::EndScaler::operator()(SwsContext* scaler) const {
    sws_freeContext(scaler);
}

PictureScaler::PictureScaler(PictureForm form) : form_(form) {}

PictureScaler::~PictureScaler() = default;

std::optional<Sample> PictureScaler::scaled(GstSample* frame, int width, int height,
                                            std::chrono::nanoseconds stream_time) {
    if (form_ == PictureForm::shared && !refusal_->load()) {
        if (std::optional<Sample> picture = shared(frame)) {
            picture->stream_time = stream_time;
            return picture;
        }
    }
    auto mapped = std::make_shared<const MappedFrame>(frame);
    if (!mapped->is_mapped()) return std::nullopt;
    const GstVideoFrame& pixels = mapped->frame();
    follow(pixels.info);
    const GstVideoFormat format = GST_VIDEO_FRAME_FORMAT(&pixels);
    const bool is_drawable = format == GST_VIDEO_FORMAT_I420 || format == GST_VIDEO_FORMAT_NV12;
    std::optional<Sample> picture;
    if (form_ == PictureForm::bgra || tones_ || !is_drawable)
        picture = converted(pixels, width, height, PixelLayout::bgra);
    else if (is_far_larger(pixels, width, height))
        picture = converted(pixels, width, height, PixelLayout::i420);
    else
        picture = lent(std::move(mapped),
                       format == GST_VIDEO_FORMAT_I420 ? PixelLayout::i420 : PixelLayout::nv12, colours_);
    if (picture) picture->stream_time = stream_time;
    return picture;
}

/// None: not in shared memory, or HDR. HDR tones must be changed, which only the processor does here.
std::optional<Sample> PictureScaler::shared(GstSample* frame) {
    std::optional<Sample> picture = shared_frame(frame);
    if (!picture) return std::nullopt;
    GstVideoInfo info;
    if (gst_video_info_from_caps(&info, gst_sample_get_caps(frame))) follow(info);
    if (tones_) return std::nullopt;
    const auto held = std::static_pointer_cast<const GstSample>(picture->owner);
    picture->copied = [held, refusal = refusal_, layout = picture->layout,
                       colours = picture->colours]() -> std::optional<Sample> {
        refusal->store(true);
        auto mapped = std::make_shared<const MappedFrame>(const_cast<GstSample*>(held.get()));
        if (!mapped->is_mapped()) return std::nullopt;
        return lent(std::move(mapped), layout, colours);
    };
    return picture;
}

/// Follows the film's colours, which may change with any frame.
void PictureScaler::follow(const GstVideoInfo& video) {
    if (gst_video_colorimetry_is_equal(&video.colorimetry, &followed_)) return;
    followed_ = video.colorimetry;
    colours_ = colour_code(followed_);
    tones_ = ToneMap::of(followed_);
    scaler_.reset();
}

/// False: this format cannot be converted.
bool PictureScaler::prepare(const Task& task) {
    if (scaler_ && task == prepared_) return true;
    const auto format = format_of(task.format);
    if (!format) return false;
    const bool shrinks = task.from_width > task.width || task.from_height > task.height;
    const bool is_bgra = task.layout == PixelLayout::bgra;
    scaler_.reset(sws_getContext(task.from_width, task.from_height, *format, task.width, task.height,
                                 is_bgra ? AV_PIX_FMT_BGRA : AV_PIX_FMT_YUV420P,
                                 shrinks ? SWS_AREA : SWS_BILINEAR, nullptr, nullptr, nullptr));
    if (!scaler_) return false;
    prepared_ = task;
    const int* table = coefficients(colours_.matrix);
    const int range = colours_.is_full_range ? 1 : 0;
    sws_setColorspaceDetails(scaler_.get(), table, range, table, is_bgra ? 1 : range, 0, 1 << 16,
                             1 << 16);  // fails if nothing can be set for these formats
    return true;
}

std::optional<Sample> PictureScaler::converted(const GstVideoFrame& frame, int width, int height,
                                               PixelLayout layout) {
    if (!prepare({.format = GST_VIDEO_FRAME_FORMAT(&frame),
                  .from_width = GST_VIDEO_FRAME_WIDTH(&frame),
                  .from_height = GST_VIDEO_FRAME_HEIGHT(&frame),
                  .width = width,
                  .height = height,
                  .layout = layout}))
        return std::nullopt;
    Sample picture = empty_picture(memory_, width, height, layout);
    picture.colours = colours_;
    std::array<const std::uint8_t*, 4> from{};
    std::array<int, 4> from_strides{};
    for (unsigned i = 0; i < GST_VIDEO_FRAME_N_PLANES(&frame); ++i) {
        from[i] = static_cast<const std::uint8_t*>(GST_VIDEO_FRAME_PLANE_DATA(&frame, i));
        from_strides[i] = GST_VIDEO_FRAME_PLANE_STRIDE(&frame, i);
    }
    // The block is new and has no other owner.
    const auto bytes = [](std::span<const std::byte> plane) {
        return reinterpret_cast<std::uint8_t*>(const_cast<std::byte*>(plane.data()));
    };
    const std::array<std::uint8_t*, 4> to{bytes(picture.pixels), bytes(picture.chroma[0].bytes),
                                          bytes(picture.chroma[1].bytes)};
    const std::array<int, 4> to_strides{static_cast<int>(picture.stride),
                                        static_cast<int>(picture.chroma[0].stride),
                                        static_cast<int>(picture.chroma[1].stride)};
    const int rows = sws_scale(scaler_.get(), from.data(), from_strides.data(), 0,
                               GST_VIDEO_FRAME_HEIGHT(&frame), to.data(), to_strides.data());
    if (rows <= 0) return std::nullopt;
    constexpr int channels = 4;
    if (tones_) tones_->apply({to[0], picture.pixels.size()}, channels, true);
    return picture;
}

}  // namespace vitrine::player
