#include "base/media/stream_end.hpp"

#include "base/media/file_bytes.hpp"

#include <string_view>

namespace vitrine {

namespace {

using namespace std::string_view_literals;

constexpr std::size_t looked_at = 1U << 18;  // bytes before the end; more than the largest packet

std::uint64_t byte_at(std::string_view bytes, std::size_t at) {
    return static_cast<unsigned char>(bytes[at]);
}

std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value = value << 8 | byte_at(bytes, at + i);
    return value;
}

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

// A pack has its own head, followed by packets, each with its length.
bool is_program_stream_cut(std::string_view tail) {
    constexpr std::uint64_t pack = 0xba, end = 0xb9, first_packet = 0xbb;
    const std::size_t last = tail.rfind("\0\0\1\xba"sv);
    for (std::size_t at = last; last != tail.npos;) {
        if (at + 4 > tail.size()) return at > tail.size();
        const std::uint64_t kind = byte_at(tail, at + 3);
        if (tail.substr(at, 3) != "\0\0\1"sv || kind == end || (kind < first_packet && kind != pack))
            return false;
        const std::size_t head = kind == pack ? 14 : 6;
        if (at + head > tail.size()) return true;
        const bool is_old = (byte_at(tail, at + 4) & 0xc0) != 0x40;  // MPEG-1
        if (kind != pack)
            at += head + big_endian(tail, at + 4, 2);
        else
            at += is_old ? 12 : head + (byte_at(tail, at + 13) & 7);
    }
    return false;
}

// The last page has the mark for the stream's end.
bool is_ogg_cut(std::string_view tail) {
    constexpr std::size_t head = 27;
    constexpr std::uint64_t is_last = 4;
    const std::size_t at = tail.rfind("OggS"sv);
    if (at == tail.npos) return false;
    if (at + head > tail.size()) return true;
    const auto segments = static_cast<std::size_t>(byte_at(tail, at + 26));
    if (at + head + segments > tail.size()) return true;
    std::size_t bytes = head + segments;
    for (std::size_t i = 0; i < segments; ++i)
        bytes += static_cast<std::size_t>(byte_at(tail, at + head + i));
    return at + bytes > tail.size() || (byte_at(tail, at + 5) & is_last) == 0;
}

// The length of each tag is in its head and again after it.
bool is_flv_cut(const FileBytes& file) {
    constexpr std::uint64_t tag_head = 11, length_bytes = 4, smallest = 13;
    if (file.size() <= smallest) return true;
    const auto length = file.at<4>(file.size() - length_bytes);
    if (!length) return true;
    std::uint64_t bytes = 0;
    for (const std::uint8_t byte : *length)
        bytes = bytes << 8 | byte;
    if (bytes < tag_head || bytes + length_bytes + smallest > file.size()) return true;
    const auto tag = file.at<4>(file.size() - length_bytes - bytes);
    return !tag ||
           (std::uint64_t{(*tag)[1]} << 16 | std::uint64_t{(*tag)[2]} << 8 | (*tag)[3]) + tag_head != bytes;
}

bool is_cut(const FileBytes& file, MediaFormat format) {
    switch (format) {
    case MediaFormat::mpeg_ts:
        return is_transport_stream_cut(file);
    case MediaFormat::mpeg_ps:
        return is_program_stream_cut(file.tail(looked_at));
    case MediaFormat::ogg:
        return is_ogg_cut(file.tail(looked_at));
    case MediaFormat::flv:
        return is_flv_cut(file);
    default:
        return false;
    }
}

}  // namespace

void require_whole_packets(const std::string& path, MediaFormat format) {
    if (is_cut(FileBytes(path), format))
        throw MediaError(MediaState::waiting,
                         "the copy is not complete: the film breaks off inside a packet");
}

}  // namespace vitrine
