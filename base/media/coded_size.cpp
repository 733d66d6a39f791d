// VP8: RFC 6386, section 9.1. VP9: "VP9 Bitstream & Decoding Process Specification", sections 6.2 and annex
// B.

#include "base/media/coded_size.hpp"

#include <cstddef>

namespace vitrine {

namespace {

using Bytes = std::span<const std::uint8_t>;

/// The bits of a header, the highest of each byte first. Behind the end all bits are 0.
class HeaderBits {
  public:
    explicit HeaderBits(Bytes bytes) : bytes_(bytes) {}

    unsigned read(int count) {
        unsigned value = 0;
        for (; count > 0; --count, ++at_) {
            const std::size_t byte = at_ / 8;
            const unsigned bit = byte < bytes_.size() ? (bytes_[byte] >> (7 - at_ % 8)) & 1U : 0U;
            value = value << 1U | bit;
        }
        return value;
    }

    bool flag() { return read(1) != 0; }

    bool is_past_end() const { return at_ > bytes_.size() * 8; }

  private:
    Bytes bytes_;
    std::size_t at_ = 0;  // bits
};

std::optional<CodedSize> vp8_size(Bytes picture) {
    constexpr std::size_t header = 10;
    if (picture.size() < header || (picture[0] & 1U) != 0)
        return std::nullopt;  // 1: it refers to another picture
    const auto side = [&](std::size_t at) { return (picture[at] | picture[at + 1] << 8U) & 0x3fff; };
    return CodedSize{.width = side(6), .height = side(8)};
}

void skip_vp9_colours(HeaderBits& bits, unsigned profile) {
    constexpr unsigned rgb = 7;
    const bool has_subsampling = profile == 1 || profile == 3;
    if (profile >= 2) bits.read(1);
    if (bits.read(3) == rgb) {
        if (has_subsampling) bits.read(1);
        return;
    }
    bits.read(has_subsampling ? 4 : 1);
}

CodedSize vp9_frame_size(HeaderBits& bits) {
    const auto side = [&] { return static_cast<int>(bits.read(16)) + 1; };
    const int width = side();
    return {.width = width, .height = side()};
}

/// A picture that refers to others has a size of its own if it takes that of none of them.
bool has_own_vp9_size(HeaderBits& bits) {
    constexpr int refresh = 8, references = 3, reference = 4;
    bits.read(refresh + references * reference);
    for (int i = 0; i < references; ++i)
        if (bits.flag()) return false;
    return true;
}

std::optional<CodedSize> vp9_size(Bytes picture) {
    constexpr int sync_code = 24, refresh = 8;
    HeaderBits bits(picture);
    if (bits.read(2) != 2) return std::nullopt;  // the mark of a picture
    unsigned profile = bits.read(1);
    profile |= bits.read(1) << 1U;
    if (profile == 3) bits.read(1);
    if (bits.flag()) return std::nullopt;  // it shows an earlier picture
    const bool is_key = !bits.flag();
    const bool is_shown = bits.flag(), is_resilient = bits.flag();
    if (is_key) {
        bits.read(sync_code);
        skip_vp9_colours(bits, profile);
    } else {
        const bool is_intra = !is_shown && bits.flag();
        if (!is_resilient) bits.read(2);
        if (is_intra) {
            bits.read(sync_code);
            if (profile > 0) skip_vp9_colours(bits, profile);
            bits.read(refresh);
        } else if (!has_own_vp9_size(bits)) {
            return std::nullopt;
        }
    }
    const CodedSize size = vp9_frame_size(bits);
    return bits.is_past_end() ? std::nullopt : std::optional(size);
}

bool is_larger(const CodedSize& a, const CodedSize& b) {
    return std::int64_t{a.width} * a.height > std::int64_t{b.width} * b.height;
}

/// Looks at each picture of a superframe, whose index stands at the end of the buffer.
std::optional<CodedSize> largest_vp9_size(Bytes buffer) {
    if (buffer.empty()) return std::nullopt;
    const unsigned mark = buffer.back();
    const std::size_t pictures = (mark & 7U) + 1, length = (mark >> 3U & 3U) + 1,
                      index = 2 + pictures * length;
    if ((mark & 0xe0U) != 0xc0U || buffer.size() < index || buffer[buffer.size() - index] != mark)
        return vp9_size(buffer);
    std::optional<CodedSize> largest;
    std::size_t begin = 0;
    for (std::size_t picture = 0; picture < pictures; ++picture) {
        std::size_t size = 0;
        for (std::size_t byte = 0; byte < length; ++byte)
            size |= std::size_t{buffer[buffer.size() - index + 1 + picture * length + byte]} << 8 * byte;
        if (size > buffer.size() - begin) break;
        const auto found = vp9_size(buffer.subspan(begin, size));
        if (found && (!largest || is_larger(*found, *largest))) largest = found;
        begin += size;
    }
    return largest;
}

}  // namespace

std::optional<CodedSize> coded_size(std::string_view codec, Bytes picture) {
    if (codec == "video/x-vp8") return vp8_size(picture);
    if (codec == "video/x-vp9") return largest_vp9_size(picture);
    return std::nullopt;
}

}  // namespace vitrine
