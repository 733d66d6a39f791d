#include "base/media/media_type.hpp"

#include "base/media/animation_marks.hpp"
#include "base/state/media_error.hpp"
#include "base/system/unique_fd.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <string_view>

namespace vitrine {

namespace {

using namespace std::string_view_literals;

/// The facts about one format that do not depend on a file.
struct FormatRow {
    MediaFormat format;
    MediaKind kind = MediaKind::film;
    bool is_fast_to_decode = false;
};

constexpr std::array formats{
    FormatRow{MediaFormat::jpeg, MediaKind::photo, true}, FormatRow{MediaFormat::png, MediaKind::photo, true},
    FormatRow{MediaFormat::webp, MediaKind::photo, true}, FormatRow{MediaFormat::heif, MediaKind::photo},
    FormatRow{MediaFormat::gif, MediaKind::photo},        FormatRow{MediaFormat::tiff, MediaKind::photo},
    FormatRow{MediaFormat::bmp, MediaKind::photo},
};

/// Bytes at a fixed place in the file that tell its format.
struct Magic {
    std::size_t at;  // byte
    std::string_view bytes;
    MediaFormat format;
};

constexpr std::array magics{
    Magic{0, "\xff\xd8\xff"sv, MediaFormat::jpeg}, Magic{0, "\x89PNG\r\n\x1a\n"sv, MediaFormat::png},
    Magic{8, "WEBPVP8"sv, MediaFormat::webp},      Magic{0, "GIF87a"sv, MediaFormat::gif},
    Magic{0, "GIF89a"sv, MediaFormat::gif},        Magic{0, "II*\0"sv, MediaFormat::tiff},
    Magic{0, "MM\0*"sv, MediaFormat::tiff},        Magic{0, "II+\0"sv, MediaFormat::tiff},  // BigTIFF
    Magic{0, "MM\0+"sv, MediaFormat::tiff},        Magic{0, "\x1a\x45\xdf\xa3"sv, MediaFormat::matroska},
    Magic{8, "AVI LIST"sv, MediaFormat::avi},
};

struct RejectedType {
    std::string_view bytes;  // at the start, letters in lower case
    std::string_view name;
};

// Formats that refer to other files (playlists, drawings, pages) are never followed.
constexpr std::array rejected_types{
    RejectedType{"#extm3u", "a playlist; playlists are not played"},
    RejectedType{"ffconcat", "a playlist; playlists are not played"},
    RejectedType{"[playlist]", "a playlist; playlists are not played"},
    RejectedType{"#!", "a script, not a picture or film"},
    RejectedType{"v=0", "a network session description, not a film"},
    RejectedType{"<!doctype html", "a web page, not a picture or film"},
    RejectedType{"<html", "a web page, not a picture or film"},
    RejectedType{"<svg", "an SVG drawing; drawings are not shown"},
    RejectedType{"<!doctype svg", "an SVG drawing; drawings are not shown"},
    RejectedType{"%pdf", "a PDF document; documents are not shown"},
    RejectedType{"%!ps", "a PostScript document; documents are not shown"},
    RejectedType{"pk\3\4", "an archive (ZIP or an office document), not a picture or film"},
    RejectedType{"pk\5\6", "an empty ZIP archive, not a picture or film"},
    RejectedType{"7z\xbc\xaf", "a 7z archive, not a picture or film"},
    RejectedType{"rar!", "a RAR archive, not a picture or film"},
    RejectedType{"\x1f\x8b", "a compressed file, not a picture or film"},
    RejectedType{"\x7f"
                 "elf",
                 "a program, not a picture or film"},
    RejectedType{"mz", "a program, not a picture or film"},
    RejectedType{"\0\0\1\xba"sv,
                 "an MPEG program stream, which is not played; H.264 in MP4 plays everywhere"},
    RejectedType{"oggs", "an Ogg file, which is not played; H.264 in MP4 plays everywhere"},
    RejectedType{"flv\1", "a Flash video, which is not played; H.264 in MP4 plays everywhere"},
    RejectedType{"\x30\x26\xb2\x75\x8e\x66\xcf\x11",
                 "a Windows Media file, which is not played; H.264 in MP4 plays everywhere"},
    RejectedType{"\x06\x0e\x2b\x34\x02\x05\x01\x01",
                 "an MXF file, which is not played; H.264 in MP4 plays everywhere"},
    RejectedType{"yuv4mpeg2", "a film without a container; H.264 in MP4 plays everywhere"},
    RejectedType{"dkif", "a bare video stream (IVF); put it into an MP4 or MKV container"},
    RejectedType{"id3", "only sound"},
    RejectedType{"flac", "only sound"},
    RejectedType{"\xff\x0a", "a JPEG XL picture; JPEG XL is not shown"},
    RejectedType{"8bps", "a Photoshop file; save it as JPEG or PNG"},
    RejectedType{"\0\0\0\x0cjxl "sv, "a JPEG XL picture; JPEG XL is not shown"},
    RejectedType{"\0\0\0\x0cjp  "sv, "a JPEG 2000 picture; JPEG 2000 is not shown"},
    RejectedType{"\0\0\1\xb3"sv, "a bare video stream; put it into an MP4 or MKV container"},
    RejectedType{"\0\0\0\1bud1"sv, "a file of macOS about a folder, not a picture or film"},
    RejectedType{"\0\0\0\1"sv, "a bare video stream; put it into an MP4 or MKV container"},
    RejectedType{"\0\5\x16\7"sv, "a file of macOS about another file, not a picture or film"},
};

bool has_at(std::string_view head, std::size_t at, std::string_view bytes) {
    return head.size() >= at + bytes.size() && head.substr(at, bytes.size()) == bytes;
}

// The format of an ISO base media file. Photos and films share the container and differ by brand.
std::optional<MediaFormat> iso_format(std::string_view head) {
    constexpr std::array film_boxes{"moov"sv, "mdat"sv, "free"sv, "skip"sv, "wide"sv, "pnot"sv, "styp"sv};
    if (std::ranges::any_of(film_boxes, [&](auto box) { return has_at(head, 4, box); }))
        return MediaFormat::mp4;
    if (!has_at(head, 4, "ftyp")) return std::nullopt;
    constexpr std::array still_brands{"heic"sv, "heix"sv, "heim"sv, "heis"sv, "hevc"sv, "hevx"sv,
                                      "mif1"sv, "msf1"sv, "avif"sv, "avis"sv, "miaf"sv};
    const auto brand = head.size() >= 12 ? head.substr(8, 4) : ""sv;
    const bool still = std::ranges::find(still_brands, brand) != still_brands.end();
    return still ? MediaFormat::heif : MediaFormat::mp4;
}

// Transport streams have no magic: a sync byte every 188 bytes, or every 192 behind 4 bytes of time stamp. A
// recording may begin within a packet.
bool is_transport_stream(std::string_view head) {
    constexpr int packets = 4;
    constexpr std::size_t packet = 188;
    const auto synced = [&](std::size_t start, std::size_t step) {
        for (int i = 0; i < packets; ++i) {
            const std::size_t at = start + static_cast<std::size_t>(i) * step;
            if (at >= head.size() || head[at] != '\x47') return false;
        }
        return true;
    };
    for (std::size_t begin = 0; begin < packet; ++begin)
        if (synced(begin, packet)) return true;
    return synced(4, packet + 4);
}

bool is_bitmap(std::string_view head) {
    // "BM" alone opens many texts: the header size that follows must be one of the known ones.
    constexpr std::array header_sizes{12, 40, 52, 56, 64, 108, 124};
    if (!has_at(head, 0, "BM") || head.size() < 18) return false;
    return std::ranges::find(header_sizes, static_cast<int>(static_cast<unsigned char>(head[14]))) !=
               header_sizes.end() &&
           head.substr(15, 3) == "\0\0\0"sv;
}

std::string lower_start(std::string_view head) {
    constexpr std::size_t looked_at = 512;
    std::string start(head.substr(0, looked_at));
    for (char& letter : start)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return start;
}

bool is_text(std::string_view head) {
    return std::ranges::all_of(head, [](char letter) {
        const auto code = static_cast<unsigned char>(letter);
        return code >= 32 || code == '\n' || code == '\r' || code == '\t' || code == '\f';
    });
}

std::string reason_for_rejection(std::string_view head) {
    const std::string start = lower_start(head);
    for (const RejectedType& type : rejected_types)
        if (start.starts_with(type.bytes)) return fmt::format("this is {}", type.name);
    if (has_at(head, 8, "WAVE")) return "this is only sound";
    if (start.find("<svg") != std::string::npos) return "this is an SVG drawing; drawings are not shown";
    if (start.find("<html") != std::string::npos) return "this is a web page, not a picture or film";
    if (is_text(head)) return "this is a text, not a picture or film";
    return "this is neither a picture nor a film that is known here";
}

std::string read_head(int fd) {
    std::string head(media_head_bytes, '\0');
    std::size_t filled = 0;
    while (filled < head.size()) {
        const ssize_t got = ::read(fd, head.data() + filled, head.size() - filled);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) throw failed_call("the file cannot be read", errno);
        if (got == 0) break;
        filled += static_cast<std::size_t>(got);
    }
    head.resize(filled);
    return head;
}

/// The format with regard to its pictures: they may be an animation.
MediaFormat with_animation(const std::string& path, MediaFormat format) {
    switch (format) {
    case MediaFormat::gif:
        return is_animated_gif(FileBytes(path)) ? MediaFormat::animated_gif : format;
    case MediaFormat::webp:
        return is_animated_webp(FileBytes(path)) ? MediaFormat::animated_webp : format;
    case MediaFormat::png:
        return is_animated_png(FileBytes(path)) ? MediaFormat::animated_png : format;
    default:
        return format;
    }
}

/// A format without a row is a container of films, or an animation.
FormatRow row_of(MediaFormat format) {
    const auto row = std::ranges::find(formats, format, &FormatRow::format);
    return row != formats.end() ? *row : FormatRow{.format = format};
}

}  // namespace

MediaKind kind_of(MediaFormat format) {
    return row_of(format).kind;
}

bool is_animation(MediaFormat format) {
    return still_format(format) != format;
}

MediaFormat still_format(MediaFormat format) {
    switch (format) {
    case MediaFormat::animated_gif:
        return MediaFormat::gif;
    case MediaFormat::animated_webp:
        return MediaFormat::webp;
    case MediaFormat::animated_png:
        return MediaFormat::png;
    default:
        return format;
    }
}

bool is_fast_to_decode(MediaFormat format) {
    return row_of(format).is_fast_to_decode;
}

MediaFormat media_format(std::span<const std::byte> bytes) {
    std::string text(bytes.size(), '\0');
    if (!bytes.empty()) std::memcpy(text.data(), bytes.data(), bytes.size());
    const std::string_view head = text;
    if (head.empty()) throw MediaError(MediaState::waiting, "the file is empty");
    for (const Magic& magic : magics)
        if (has_at(head, magic.at, magic.bytes)) return magic.format;
    if (const auto iso = iso_format(head)) return *iso;
    if (is_transport_stream(head)) return MediaFormat::mpeg_ts;
    if (is_bitmap(head)) return MediaFormat::bmp;
    if (std::ranges::all_of(head, [](char letter) { return letter == '\0'; }))
        throw MediaError(MediaState::waiting, "the copy is not complete: the file holds only zeros so far");
    throw MediaError(MediaState::unsupported, reason_for_rejection(head));
}

MediaFormat media_format(const std::string& path) {
    const UniqueFd fd(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!fd.is_open()) throw failed_call("the file cannot be opened", errno);

    struct stat status {};

    if (::fstat(fd.get(), &status) != 0 || !S_ISREG(status.st_mode))
        throw MediaError(MediaState::unsupported, "this is not a regular file");
    const std::string head = read_head(fd.get());
    return with_animation(path, media_format(std::as_bytes(std::span(head))));
}

}  // namespace vitrine
