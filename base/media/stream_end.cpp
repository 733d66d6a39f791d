#include "base/media/stream_end.hpp"

#include "base/media/file_bytes.hpp"

namespace vitrine {

namespace {

// Packets of 188 bytes, or of 192 with a time stamp before each.
bool is_transport_stream_cut(const FileBytes& file) {
    const auto head = file.at<1>(0);
    const bool has_times = head && (*head)[0] != 0x47;
    const std::uint64_t stamp = has_times ? 4 : 0;
    const std::uint64_t rest = file.size() % (stamp + 188);
    if (rest <= stamp) return rest != 0;
    const auto sync = file.at<1>(file.size() - rest + stamp);
    return sync && (*sync)[0] == 0x47;  // false: other data follows the stream
}

}  // namespace

void require_whole_packets(const std::string& path, MediaFormat format) {
    if (format == MediaFormat::mpeg_ts && is_transport_stream_cut(FileBytes(path)))
        throw MediaError(MediaState::waiting,
                         "the copy is not complete: the film breaks off inside a packet");
}

}  // namespace vitrine
