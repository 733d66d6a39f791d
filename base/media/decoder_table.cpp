#include "base/media/decoder_table.hpp"

#include <array>
#include <cassert>
#include <span>

namespace vitrine {

namespace {

// These are the codecs of docs/operator.md, with MPEG-1 and DivX, which the decoders of MPEG-2 and MPEG-4
// read, and pictures without a codec. Each further row would give hostile files one more decoder to attack.
// FFmpeg's decoders come first: measured two times faster than libvpx and openh264.
constexpr std::array rows{
    DecoderRow{"video/x-h264", "h264parse", "avdec_h264"},
    DecoderRow{"video/x-h265", "h265parse", "avdec_h265"},
    DecoderRow{"video/x-vp8", nullptr, "avdec_vp8"},
    DecoderRow{"video/x-vp9", nullptr, "avdec_vp9"},
    DecoderRow{"video/x-av1", "av1parse", "av1dec"},
    DecoderRow{"video/mpeg,mpegversion=(int)[1,2],systemstream=(boolean)false", "mpegvideoparse",
               "avdec_mpeg2video"},
    DecoderRow{"video/mpeg,mpegversion=(int)4,systemstream=(boolean)false", "mpeg4videoparse", "avdec_mpeg4"},
    DecoderRow{"video/x-divx,divxversion=(int)[4,5]", nullptr, "avdec_mpeg4"},
    DecoderRow{"image/jpeg", "jpegparse", "avdec_mjpeg"},
    DecoderRow{"video/x-ffv", nullptr, "avdec_ffv1"},
    DecoderRow{"video/x-raw", nullptr, nullptr},
};

constexpr std::array sounds{
    DecoderRow{"audio/mpeg,mpegversion=(int){2,4}", "aacparse", "avdec_aac"},
    DecoderRow{"audio/mpeg,mpegversion=(int)1", "mpegaudioparse", "mpg123audiodec"},
    DecoderRow{"audio/x-opus", "opusparse", "opusdec"},
    DecoderRow{"audio/x-vorbis", nullptr, "vorbisdec"},
    DecoderRow{"audio/x-flac", "flacparse", "flacdec"},
    DecoderRow{"audio/x-ac3", "ac3parse", "avdec_ac3"},
    DecoderRow{"audio/x-eac3", "ac3parse", "avdec_eac3"},
    DecoderRow{"audio/x-alac", nullptr, "avdec_alac"},
    DecoderRow{"audio/x-raw", nullptr, nullptr},
};

std::optional<DecoderRow> row_for(std::span<const DecoderRow> table, const GstCaps* stream) {
    for (const DecoderRow& row : table) {
        const GstPtr<GstCaps> wanted(gst_caps_from_string(row.caps));
        if (gst_caps_can_intersect(stream, wanted.get())) return row;
    }
    return std::nullopt;
}

void add_name(std::vector<std::string>& names, const char* factory) {
    if (factory != nullptr) names.emplace_back(factory);
}

/// The names of the elements for coded streams of any kind. @param decodes_sound  false: sound is parsed only
std::vector<std::string> stream_elements(bool decodes_sound) {
    std::vector<std::string> names;
    for (const DecoderRow& row : rows)
        for (const char* factory : {row.parser, row.decoder})
            add_name(names, factory);
    for (const DecoderRow& row : sounds)
        for (const char* factory : {row.parser, decodes_sound ? row.decoder : nullptr})
            add_name(names, factory);
    return names;
}

}  // namespace

std::optional<DecoderRow> decoder_for(const GstCaps* stream) {
    return row_for(rows, stream);
}

std::optional<DecoderRow> sound_decoder_for(const GstCaps* stream) {
    return row_for(sounds, stream);
}

void load_decoders(MediaFormat container) {
    load_element(is_animation(container) ? "appsrc" : demuxer_for(container));
    for (const std::string& name : stream_elements(false))
        load_element(name.c_str());
    for (const char* factory : {"filesrc", "deinterlace"})
        load_element(factory);
}

const char* demuxer_for(MediaFormat container) {
    switch (container) {
    case MediaFormat::mp4:
        return "qtdemux";
    case MediaFormat::matroska:
        return "matroskademux";
    case MediaFormat::avi:
        return "avidemux";
    case MediaFormat::mpeg_ts:
        return "tsdemux";
    default:
        break;
    }
    assert(false && "a photo has no demuxer");
    return "";
}

std::vector<std::string> decoding_elements() {
    std::vector<std::string> names = stream_elements(true);
    for (const char* factory : {"filesrc", "appsrc", "deinterlace"})
        names.emplace_back(factory);
    for (const MediaFormat container :
         {MediaFormat::mp4, MediaFormat::matroska, MediaFormat::avi, MediaFormat::mpeg_ts})
        names.emplace_back(demuxer_for(container));
    return names;
}

}  // namespace vitrine
