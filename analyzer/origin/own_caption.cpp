#include "analyzer/origin/own_caption.hpp"

#include "base/hints/caption.hpp"
#include "base/state/path_text.hpp"
#include "base/system/log.hpp"

#include <exiv2/exiv2.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <vector>

namespace vitrine::analyzer {

namespace {

// 0x80 to 0x9f in Windows-1252; 0 where it has no letter.
constexpr std::array<std::uint16_t, 32> windows_letters{
    0x20ac, 0,      0x201a, 0x0192, 0x201e, 0x2026, 0x2020, 0x2021, 0x02c6, 0x2030, 0x0160,
    0x2039, 0x0152, 0,      0x017d, 0,      0,      0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x02dc, 0x2122, 0x0161, 0x203a, 0x0153, 0,      0x017e, 0x0178};

constexpr std::array<std::string_view, 34> camera_texts{"default",
                                                        "untitled",
                                                        "digital camera",
                                                        "digital still camera",
                                                        "dcim",
                                                        "image",
                                                        "picture",
                                                        "photo",
                                                        "exif_jpeg_picture",
                                                        "exif_jpeg_t422",
                                                        "jpeg",
                                                        "sony dsc",
                                                        "samsung",
                                                        "screenshot",
                                                        "dav",
                                                        "sdr",
                                                        "cof",
                                                        "hdr",
                                                        "rhdr",
                                                        "ptr",
                                                        "mde",
                                                        "edf",
                                                        "nor",
                                                        "oznor",
                                                        "bty",
                                                        "rbt",
                                                        "hdrpl",
                                                        "dig",
                                                        "fbt",
                                                        "ozedf",
                                                        "btf",
                                                        "burst",
                                                        "my beautiful picture",
                                                        "user comments"};

bool has_metadata(MediaFormat format) {
    return format == MediaFormat::jpeg || format == MediaFormat::heif || format == MediaFormat::png ||
           format == MediaFormat::tiff || format == MediaFormat::webp;
}

template <typename Data, typename Key> std::string text_at(const Data& data, const char* key) {
    const auto found = data.findKey(Key(key));
    return found == data.end() ? std::string() : found->toString();
}

/// The caption in the language that counts where no other is asked for, else in the first one.
std::string xmp_text(const Exiv2::XmpData& data) {
    const auto found = data.findKey(Exiv2::XmpKey("Xmp.dc.description"));
    if (found == data.end()) return {};
    const auto* texts = dynamic_cast<const Exiv2::LangAltValue*>(&found->value());
    if (texts == nullptr) return found->toString();
    const auto usual = texts->value_.find("x-default");
    if (usual != texts->value_.end()) return usual->second;
    return texts->value_.empty() ? std::string() : texts->value_.begin()->second;
}

std::string comment_text(const Exiv2::ExifData& data) {
    const auto found = data.findKey(Exiv2::ExifKey("Exif.Photo.UserComment"));
    if (found == data.end()) return {};
    const auto* comment = dynamic_cast<const Exiv2::CommentValue*>(&found->value());
    if (comment == nullptr || comment->charsetId() == Exiv2::CommentValue::jis) return {};
    return comment->comment();
}

/// The texts of a photo, the one that counts most first.
std::vector<std::string> texts_in(const std::string& path) {
    Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
    Exiv2::enableBMFF(true);
    const auto image = Exiv2::ImageFactory::open(path);
    image->readMetadata();
    const Exiv2::ExifData& exif = image->exifData();
    return {text_at<Exiv2::IptcData, Exiv2::IptcKey>(image->iptcData(), "Iptc.Application2.Caption"),
            xmp_text(image->xmpData()),
            text_at<Exiv2::ExifData, Exiv2::ExifKey>(exif, "Exif.Image.ImageDescription"),
            comment_text(exif)};
}

}  // namespace

std::string to_utf8(std::string_view text) {
    if (is_utf8(text)) return std::string(text);
    std::string result;
    for (const char c : text) {
        unsigned letter = static_cast<unsigned char>(c);
        if (letter >= 0x80 && letter < 0xa0) letter = windows_letters.at(letter - 0x80);
        if (letter == 0) continue;
        if (letter < 0x80) {
            result += static_cast<char>(letter);
        } else if (letter < 0x800) {
            result += {static_cast<char>(0xc0U | letter >> 6U), static_cast<char>(0x80U | (letter & 0x3fU))};
        } else {
            result +=
                {static_cast<char>(0xe0U | letter >> 12U), static_cast<char>(0x80U | (letter >> 6U & 0x3fU)),
                 static_cast<char>(0x80U | (letter & 0x3fU))};
        }
    }
    return result;
}

bool is_camera_text(std::string_view text) {
    const std::string lower = lower_case(text);
    return lower.ends_with(" digital camera") || lower.ends_with(" camera pictures") ||
           lower.starts_with("<") || lower.starts_with("filter: ") || lower.starts_with("charset=") ||
           std::ranges::find(camera_texts, lower) != camera_texts.end();
}

std::string own_caption(const std::string& path, MediaFormat format) {
    if (!has_metadata(format)) return {};
    try {
        for (const std::string& written : texts_in(path)) {
            const std::string_view text = std::string_view(written).substr(0, written.find('\0'));
            std::string caption = caption_text(to_utf8(text)).text;
            if (!caption.empty() && !is_camera_text(caption)) return caption;
        }
    } catch (const std::exception& error) {  // whoever decodes the file says so
        log::debug("no caption in a photo: {}", error.what());
    }
    return {};
}

}  // namespace vitrine::analyzer
