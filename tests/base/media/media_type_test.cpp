#include "base/media/media_type.hpp"

#include "base/state/media_error.hpp"

#include <doctest/doctest.h>

#include <string_view>

using namespace vitrine;
using namespace std::string_view_literals;

namespace {

MediaFormat format_of(std::string_view head) {
    return media_format(std::as_bytes(std::span(head)));
}

struct Refusal {
    MediaState state = MediaState::ready;
    std::string reason;
};

Refusal refusal_of(std::string_view head) {
    try {
        format_of(head);
    } catch (const MediaError& error) {
        return {error.state(), error.what()};
    }
    return {};
}

}  // namespace

TEST_CASE("a file is what its first bytes say") {
    CHECK(format_of("\xff\xd8\xff\xe0....JFIF"sv) == MediaFormat::jpeg);
    CHECK(format_of("RIFF....WEBPVP8 "sv) == MediaFormat::webp);
    CHECK(format_of("RIFF....AVI LIST"sv) == MediaFormat::avi);
    CHECK(format_of("\0\0\0\x18"
                    "ftypisom"sv) == MediaFormat::mp4);
    CHECK(format_of("\0\0\0\x18"
                    "ftypavif"sv) == MediaFormat::heif);
    CHECK(format_of("\0\0\0\x08"
                    "wide\0\0\1\0mdat"sv) == MediaFormat::mp4);
    CHECK(kind_of(MediaFormat::bmp) == MediaKind::photo);
    CHECK(kind_of(MediaFormat::mp4) == MediaKind::film);
}

TEST_CASE("a transport stream is known by its packets, with and without time stamps") {
    std::string packets(188 * 5, '\0');
    for (std::size_t i = 0; i < 5; ++i)
        packets[i * 188] = '\x47';
    CHECK(format_of(packets) == MediaFormat::mpeg_ts);
    std::string stamped(192 * 5, '\0');
    for (std::size_t i = 0; i < 5; ++i)
        stamped[4 + i * 192] = '\x47';
    CHECK(format_of(stamped) == MediaFormat::mpeg_ts);
    CHECK(format_of("x" + packets) == MediaFormat::mpeg_ts);  // a recording that begins within a packet
}

TEST_CASE("a text that begins with BM is no bitmap") {
    CHECK(refusal_of("BMW, Audi and all the others"sv).reason == "this is a text, not a picture or film");
    CHECK(format_of("BM....\0\0\0\0\x36\0\0\0\x28\0\0\0...."sv) == MediaFormat::bmp);
}

TEST_CASE("what could lead to other files or the network is refused by name") {
    for (const auto head :
         {"#EXTM3U\nhttp://example.org/a.ts"sv, "ffconcat version 1.0\nfile a"sv, "v=0\no=- 0"sv,
          "<?xml version='1.0'?><svg xmlns='x'/>"sv, "<!DOCTYPE HTML><title>404"sv, "%PDF-1.7"sv})
        CHECK(refusal_of(head).state == MediaState::unsupported);
    CHECK(refusal_of("#EXTM3U\n"sv).reason == "this is a playlist; playlists are not played");
    CHECK(refusal_of("\0\0\0\1Bud1\0"sv).reason ==
          "this is a file of macOS about a folder, not a picture or film");
}

TEST_CASE("containers that no document names are refused, with a way out") {
    for (const std::string_view head :
         {"\0\0\1\xba\x44"sv, "OggS\0\2"sv, "FLV\1\1"sv, "\x30\x26\xb2\x75\x8e\x66\xcf\x11\xa6"sv,
          "\x06\x0e\x2b\x34\x02\x05\x01\x01\x0d"sv, "YUV4MPEG2 W96 H64"sv}) {
        const Refusal refusal = refusal_of(head);
        CAPTURE(refusal.reason);
        CHECK(refusal.state == MediaState::unsupported);
        CHECK(refusal.reason.ends_with("; H.264 in MP4 plays everywhere"));
    }
}

TEST_CASE("nothing and only zeros are waited for") {
    CHECK(refusal_of(""sv).state == MediaState::waiting);
    CHECK(refusal_of(std::string(4096, '\0')).state == MediaState::waiting);
    CHECK(refusal_of(""sv).reason == "the file is empty");
}
