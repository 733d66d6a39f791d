#include "base/media/completeness.hpp"

#include "base/state/media_error.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string_view>

using namespace vitrine;
using namespace std::string_literals;
using namespace std::string_view_literals;

namespace {

struct TempFile {
    std::string path =
        std::filesystem::temp_directory_path() / fmt::format("vitrine-complete-{}", ::getpid());

    explicit TempFile(std::string_view bytes) { std::ofstream(path, std::ios::binary) << bytes; }

    TempFile(const TempFile&) = delete;
    TempFile& operator=(const TempFile&) = delete;

    ~TempFile() { std::filesystem::remove(path); }
};

std::string refusal_of(std::string_view bytes, MediaFormat format) {
    const TempFile file(bytes);
    try {
        require_complete(file.path, format);
    } catch (const MediaError& error) {
        CHECK(error.state() == MediaState::waiting);
        return error.what();
    }
    return {};
}

constexpr auto ftyp = "\0\0\0\x10"
                      "ftypisom\0\0\0\0"sv;
constexpr auto moov = "\0\0\0\x10"
                      "moov........"sv;
constexpr auto mdat_of_20 = "\0\0\0\x14"
                            "mdat............"sv;

}  // namespace

TEST_CASE("an mp4 is complete with all its boxes, index first or last") {
    CHECK(refusal_of(fmt::format("{}{}{}", ftyp, moov, mdat_of_20), MediaFormat::mp4).empty());
    CHECK(refusal_of(fmt::format("{}{}{}", ftyp, mdat_of_20, moov), MediaFormat::mp4).empty());
}

TEST_CASE("an mp4 cut inside its data is waited for") {
    const std::string cut = fmt::format("{}{}{}", ftyp, moov, "\0\0\1\0mdat............"sv);
    CHECK(refusal_of(cut, MediaFormat::mp4) == "the copy is not complete: 18 % of it is here");
}

TEST_CASE("an mp4 whose index has not arrived is waited for") {
    CHECK(refusal_of(fmt::format("{}{}", ftyp, mdat_of_20), MediaFormat::mp4) ==
          "the copy is not complete: the film's index is missing so far");
}

TEST_CASE("a size beyond all sense does not overflow") {
    const std::string huge = fmt::format("{}{}", ftyp, "\0\0\0\1mdat\xff\xff\xff\xff\xff\xff\xff\xf0"sv);
    CHECK(refusal_of(huge, MediaFormat::mp4) == "the copy is not complete: less than 1 % of it is here");
}

TEST_CASE("a live matroska recording that does not know its size is taken as it is") {
    constexpr auto header = "\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\x01\xff\xff\xff\xff\xff\xff\xff......"sv;
    CHECK(refusal_of(header, MediaFormat::matroska).empty());
}

TEST_CASE("half a matroska file is waited for") {
    constexpr auto header = "\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\x88........"sv;
    CHECK(refusal_of(header, MediaFormat::matroska).empty());
    constexpr auto half = "\x1a\x45\xdf\xa3\x80\x18\x53\x80\x67\xb0........"sv;
    CHECK(refusal_of(half, MediaFormat::matroska) == "the copy is not complete: 31 % of it is here");
}

TEST_CASE("a copy that took its whole space first is waited for, one with zeros inside is not") {
    const TempFile file(fmt::format("{}{}", ftyp, moov));
    constexpr std::uintmax_t megabyte = 1 << 20;
    std::filesystem::resize_file(file.path, megabyte);  // a box "to the end" of zeros
    CHECK_THROWS_WITH_AS(require_complete(file.path, MediaFormat::mp4),
                         "the copy is not complete: less than 1 % of it is written so far", MediaError);
    std::ofstream(file.path, std::ios::binary | std::ios::app) << "end";
    CHECK_NOTHROW(require_complete(file.path, MediaFormat::mp4));
}

TEST_CASE("a BigTIFF cut before its directory, or inside its pixels, is waited for") {
    const auto number = [](std::uint64_t value, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i, value >>= 8)
            text += static_cast<char>(value & 0xff);
        return text;
    };
    const auto entry = [&](int tag, std::uint64_t value) {
        constexpr int is_64_bit = 16;
        return number(static_cast<std::uint64_t>(tag), 2) + number(is_64_bit, 2) + number(1, 8) +
               number(value, 8);
    };
    const std::string directory =
        number(2, 8) + entry(273, 80) + entry(279, 40);  // one strip: bytes 80 to 120
    const std::string front =
        fmt::format("II+{}{}", number(0, 1), number(8, 2) + number(0, 2) + number(16, 8));
    const std::string whole = front + directory + std::string(120 - front.size() - directory.size(), 'x');
    CHECK(refusal_of(whole, MediaFormat::tiff).empty());
    CHECK(refusal_of(whole.substr(0, 90), MediaFormat::tiff) ==
          "the copy is not complete: 75 % of it is here");
    CHECK(refusal_of(front, MediaFormat::tiff) == "the copy is not complete: 36 % of it is here");
}

TEST_CASE("a PNG is waited for until its end is marked, a few bytes before the end of a chunk too") {
    constexpr auto head = "\x89PNG\r\n\x1a\n"sv;
    constexpr auto data = "\0\0\0\x08IDAT........crcs"sv;
    constexpr auto end = "\0\0\0\0IENDcrcs"sv;
    const std::string whole = fmt::format("{}{}{}{}", head, data, data, end);
    CHECK(refusal_of(whole, MediaFormat::png).empty());
    CHECK(refusal_of(whole + "what follows", MediaFormat::png).empty());
    for (const std::size_t missing : {12, 13, 15, 20, 32, 40})
        CHECK(refusal_of(whole.substr(0, whole.size() - missing), MediaFormat::png)
                  .starts_with("the copy is not complete"));
}

TEST_CASE("an animated GIF is waited for until its last picture is there") {
    constexpr auto screen = "GIF89a\x02\0\x02\0\x80\0\0......"sv;  // a table of two colours
    constexpr auto loops = "!\xff\x0bNETSCAPE2.0\x03\x01\0\0\0"sv;
    constexpr auto picture = ",\0\0\0\0\x02\0\x02\0\0\x02\x04wxyz\0"sv;
    const std::string whole = fmt::format("{}{}{}{};", screen, loops, picture, picture);
    CHECK(refusal_of(whole, MediaFormat::gif).empty());
    CHECK(refusal_of(whole + "what follows", MediaFormat::gif).empty());
    const std::size_t in_second = whole.size() - 4;
    CHECK(refusal_of(whole.substr(0, in_second), MediaFormat::gif).starts_with("the copy is not complete"));
    const std::size_t before_second_data = whole.size() - 7;  // before any of its pixels
    CHECK(refusal_of(whole.substr(0, before_second_data), MediaFormat::gif)
              .starts_with("the copy is not complete"));
    CHECK(refusal_of(whole.substr(0, whole.size() - 1), MediaFormat::gif).empty());  // some leave the end out
    CHECK(refusal_of(fmt::format("{}nonsense", screen), MediaFormat::gif).empty());  // a decoder's to say
}
