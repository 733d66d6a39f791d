#include "base/media/stream_end.hpp"

#include "base/state/media_error.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;
using namespace std::string_literals;

namespace {

bool is_cut(const std::string& bytes, MediaFormat format) {
    const TemporaryDirectory folder;
    try {
        require_whole_packets(folder.write("stream", bytes).string(), format);
    } catch (const MediaError& error) {
        CHECK(error.state() == MediaState::waiting);
        return true;
    }
    return false;
}

std::string packets(int count, std::size_t stamp) {
    std::string stream;
    for (int i = 0; i < count; ++i)
        stream += std::string(stamp, '\0') + "G" + std::string(187, 'x');
    return stream;
}

/// The number of places where a break of the stream is not noticed: the places between two packets.
int unseen(const std::string& stream, MediaFormat format) {
    int places = 0;
    for (std::size_t end = 20; end < stream.size(); ++end)
        places += is_cut(stream.substr(0, end), format) ? 0 : 1;
    return places;
}

}  // namespace

TEST_CASE("a transport stream breaks off wherever its last packet is not whole") {
    for (const std::size_t stamp : {std::size_t{0}, std::size_t{4}}) {
        const std::string stream = packets(4, stamp);
        CHECK_FALSE(is_cut(stream, MediaFormat::mpeg_ts));
        CHECK(unseen(stream, MediaFormat::mpeg_ts) == 3);
    }
    CHECK_FALSE(is_cut(packets(4, 0) + "something else", MediaFormat::mpeg_ts));
}

TEST_CASE("a program stream breaks off wherever its last packet is not whole") {
    const std::string packet = "\0\0\1\xe0\0\x20"s + std::string(32, 'v');
    for (const std::string& head :
         {"\0\0\1\xba\x44"s + std::string(8, 'p') + "\xf8", "\0\0\1\xba\x21"s + std::string(7, 'p')}) {
        const std::string stream = head + packet + packet + head + packet;
        CHECK_FALSE(is_cut(stream, MediaFormat::mpeg_ps));
        CHECK_FALSE(is_cut(stream + "\0\0\1\xb9"s, MediaFormat::mpeg_ps));
        CHECK_FALSE(is_cut(stream + std::string(100, '\0'), MediaFormat::mpeg_ps));
        CHECK(is_cut(stream.substr(0, stream.size() - 1), MediaFormat::mpeg_ps));
        CHECK(is_cut(stream.substr(0, head.size() + packet.size() + 10), MediaFormat::mpeg_ps));
        CHECK(is_cut(stream.substr(0, head.size() + 5), MediaFormat::mpeg_ps));
    }
    CHECK_FALSE(is_cut("no pack at all", MediaFormat::mpeg_ps));
}

TEST_CASE("an Ogg stream ends with a page that says so") {
    const auto page = [](char kind) {
        return "OggS\0"s + kind + std::string(20, 'x') + "\x02\x03\x02"s + "12345";
    };
    const std::string stream = page(2) + page(0) + page(4);
    CHECK_FALSE(is_cut(stream, MediaFormat::ogg));
    CHECK(unseen(stream, MediaFormat::ogg) == 0);
}

TEST_CASE("an FLV file ends with the length of its last tag") {
    const auto tag = [](char bytes) {
        return "\x09\0\0"s + bytes + std::string(7, '\0') +
               std::string(static_cast<std::size_t>(bytes), 'v') + "\0\0\0"s + static_cast<char>(bytes + 11);
    };
    const std::string stream = "FLV\1\1\0\0\0\x09\0\0\0\0"s + tag(20) + tag(30);
    CHECK_FALSE(is_cut(stream, MediaFormat::flv));
    CHECK(unseen(stream, MediaFormat::flv) == 1);
}

TEST_CASE("formats that say how long they are, are not looked at") {
    CHECK_FALSE(is_cut("half", MediaFormat::mp4));
    CHECK_FALSE(is_cut("half", MediaFormat::jpeg));
}
