#include "base/media/stream_end.hpp"

#include "base/state/media_error.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

using namespace vitrine;

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

TEST_CASE("formats that say how long they are, are not looked at") {
    CHECK_FALSE(is_cut("half", MediaFormat::mp4));
    CHECK_FALSE(is_cut("half", MediaFormat::jpeg));
}
