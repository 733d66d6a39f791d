#include "analyzer/origin/own_caption.hpp"

#include "tests/analyzer/origin/drawn_exif.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <exiv2/exiv2.hpp>

#include <filesystem>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

std::filesystem::path photo_saying(const TemporaryDirectory& house, const std::string& description) {
    const DrawnExif exif{.main = {{0x010e, 2, description}}};
    return house.write("a.jpg", jpeg_with(exif.bytes()));
}

std::string caption_in(const std::filesystem::path& file) {
    return own_caption(file.string(), MediaFormat::jpeg);
}

void write_texts(const std::filesystem::path& file, const char* iptc, const char* xmp, const char* comment) {
    const auto image = Exiv2::ImageFactory::open(file.string());
    image->readMetadata();
    if (iptc != nullptr) image->iptcData()["Iptc.Application2.Caption"] = iptc;
    if (xmp != nullptr) image->xmpData()["Xmp.dc.description"] = xmp;
    if (comment != nullptr) image->exifData()["Exif.Photo.UserComment"] = comment;
    image->writeMetadata();
}

}  // namespace

TEST_CASE("a photo's own caption is IPTC's, else that of XMP, else EXIF's description or comment") {
    const TemporaryDirectory house;
    const auto file = photo_saying(house, "described");
    CHECK(caption_in(file) == "described");
    write_texts(file, nullptr, "lang=x-default in XMP", "charset=Ascii commented");
    CHECK(caption_in(file) == "in XMP");
    write_texts(file, "in IPTC", nullptr, nullptr);
    CHECK(caption_in(file) == "in IPTC");
    const auto silent = photo_saying(house, "OLYMPUS DIGITAL CAMERA         ");
    CHECK(caption_in(silent).empty());
    write_texts(silent, nullptr, nullptr, "charset=Unicode Grüße");
    CHECK(caption_in(silent) == "Grüße");
}

TEST_CASE("captions that cameras write, blank ones and those that are too long are none") {
    const TemporaryDirectory house;
    for (const char* text : {"SONY DSC", "Minolta DIGITAL CAMERA", "   ", "Exif_JPEG_PICTURE", "dav"})
        CHECK_MESSAGE(caption_in(photo_saying(house, text)).empty(), text);
    CHECK(caption_in(photo_saying(house, std::string(501, 'x'))).empty());
    CHECK(caption_in(photo_saying(house, "My digital camera and I")) == "My digital camera and I");
}

TEST_CASE("a caption that is no UTF-8 is Latin-1") {
    const TemporaryDirectory house;
    CHECK(caption_in(photo_saying(house, "caf\xe9 \x96 a\x81")) == "café – a");
    CHECK(caption_in(photo_saying(house, "café")) == "café");
}

TEST_CASE("a photo without a caption has none, however it is damaged") {
    const TemporaryDirectory house;
    const std::string bytes = jpeg_with(DrawnExif{.main = {{0x010e, 2, "described"}}}.bytes());
    CHECK(caption_in(house.path / "gone.jpg").empty());
    for (std::size_t length = 2; length + 3 < bytes.size(); length += 7)
        CHECK_NOTHROW((void)caption_in(house.write("cut.jpg", bytes.substr(0, length))));
    for (std::size_t at = 20; at < bytes.size(); ++at) {
        std::string damaged = bytes;
        damaged[at] = '\xff';
        CHECK_NOTHROW((void)caption_in(house.write("damaged.jpg", damaged)));
    }
    CHECK(own_caption((house.path / "cut.jpg").string(), MediaFormat::gif).empty());
}
