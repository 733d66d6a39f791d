#include "base/media/coded_size.hpp"

#include <doctest/doctest.h>

#include <cstddef>
#include <random>
#include <vector>

using namespace vitrine;

namespace {

/// Writes numbers bit by bit, the highest bit first.
class BitWriter {
  public:
    BitWriter& add(unsigned value, int count) {
        for (int i = count - 1; i >= 0; --i, ++bits_) {
            if (bits_ % 8 == 0) bytes_.push_back(0);
            bytes_.back() = static_cast<std::uint8_t>(bytes_.back() | ((value >> i & 1U) << (7 - bits_ % 8)));
        }
        return *this;
    }

    BitWriter& size(unsigned width, unsigned height) { return add(width - 1, 16).add(height - 1, 16); }

    const std::vector<std::uint8_t>& bytes() const { return bytes_; }

  private:
    std::vector<std::uint8_t> bytes_;
    std::size_t bits_ = 0;
};

constexpr const char* vp8 = "video/x-vp8";
constexpr const char* vp9 = "video/x-vp9";

/// Begins a picture of profile 0: mark, profile, not an earlier picture, key or not, shown or not, not
/// resilient.
BitWriter vp9_begin(bool is_key, bool is_shown) {
    return BitWriter()
        .add(2, 2)
        .add(0, 2)
        .add(0, 1)
        .add(is_key ? 0 : 1, 1)
        .add(is_shown ? 1 : 0, 1)
        .add(0, 1);
}

std::vector<std::uint8_t> vp9_key(unsigned width, unsigned height) {
    return vp9_begin(true, true).add(0x498342, 24).add(1, 3).add(0, 1).size(width, height).bytes();
}

/// A picture that refers to others.
std::vector<std::uint8_t> vp9_inter(bool has_own_size, unsigned width, unsigned height) {
    BitWriter bits = vp9_begin(false, true);
    bits.add(0, 2).add(0, 8).add(0, 12).add(0, 2).add(has_own_size ? 0 : 1, 1);
    return bits.size(width, height).bytes();
}

}  // namespace

TEST_CASE("a key picture of VP8 tells its size") {
    const std::vector<std::uint8_t> key{0x10, 0, 0, 0x9d, 0x01, 0x2a, 0x80, 0x3e, 0x40, 0x41};
    CHECK(coded_size(vp8, key) ==
          CodedSize{.width = 16'000, .height = 320});  // the highest two bits are a scale
    std::vector<std::uint8_t> other = key;
    other[0] = 0x11;
    CHECK_FALSE(coded_size(vp8, other));
    CHECK_FALSE(coded_size(vp8, std::span(key).first(9)));
}

TEST_CASE("a key picture of VP9 tells its size") {
    CHECK(coded_size(vp9, vp9_key(16'000, 9'000)) == CodedSize{.width = 16'000, .height = 9'000});
    CHECK(coded_size(vp9, vp9_key(65'536, 1)) == CodedSize{.width = 65'536, .height = 1});
    const auto key = vp9_key(320, 240);
    CHECK_FALSE(coded_size(vp9, std::span(key).first(6)));
}

TEST_CASE("a VP9 picture of 10 bits, in RGB or with all colours has its size elsewhere") {
    const auto key = [](unsigned profile) {
        return BitWriter()
            .add(2, 2)
            .add(profile & 1U, 1)
            .add(profile >> 1U, 1)
            .add(0, profile == 3 ? 1 : 0)
            .add(0b0010, 4)
            .add(0x498342, 24);
    };
    const CodedSize size{.width = 700, .height = 500};
    CHECK(coded_size(vp9, key(1).add(1, 3).add(0, 4).size(700, 500).bytes()) == size);
    CHECK(coded_size(vp9, key(2).add(0, 1).add(1, 3).add(0, 1).size(700, 500).bytes()) == size);
    CHECK(coded_size(vp9, key(3).add(0, 1).add(1, 3).add(0, 4).size(700, 500).bytes()) == size);
    CHECK(coded_size(vp9, key(1).add(7, 3).add(0, 1).size(700, 500).bytes()) == size);
}

TEST_CASE("a VP9 picture that refers to others may have a size of its own") {
    CHECK(coded_size(vp9, vp9_inter(true, 8'000, 8'000)) == CodedSize{.width = 8'000, .height = 8'000});
    CHECK_FALSE(coded_size(vp9, vp9_inter(false, 8'000, 8'000)));
    BitWriter intra = vp9_begin(false, false);
    intra.add(1, 1).add(0, 2).add(0x498342, 24).add(0, 8).size(640, 360);
    CHECK(coded_size(vp9, intra.bytes()) == CodedSize{.width = 640, .height = 360});
}

TEST_CASE("of several VP9 pictures in one buffer the largest counts") {
    const auto small = vp9_key(32, 32), large = vp9_key(9'000, 9'000);
    std::vector<std::uint8_t> buffer = small;
    buffer.insert(buffer.end(), large.begin(), large.end());
    const std::uint8_t mark = 0xc0 | 1;  // two pictures, lengths of one byte
    buffer.insert(buffer.end(), {mark, static_cast<std::uint8_t>(small.size()),
                                 static_cast<std::uint8_t>(large.size()), mark});
    CHECK(coded_size(vp9, buffer) == CodedSize{.width = 9'000, .height = 9'000});
}

TEST_CASE("any bytes give a size or none") {
    std::mt19937 random(7);
    for (int i = 0; i < 20'000; ++i) {
        std::vector<std::uint8_t> bytes(random() % 40);
        for (std::uint8_t& byte : bytes)
            byte = static_cast<std::uint8_t>(random());
        if (!bytes.empty() && i % 2 == 0) bytes.back() = static_cast<std::uint8_t>(0xc0 | (random() & 0x1fU));
        for (const char* codec : {vp8, vp9})
            if (const auto size = coded_size(codec, bytes)) CHECK(size->width >= 0);
    }
    CHECK_FALSE(coded_size("video/x-h264", std::vector<std::uint8_t>(100)));
}
