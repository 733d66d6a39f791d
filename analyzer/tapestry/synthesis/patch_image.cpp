#include "analyzer/tapestry/synthesis/patch_image.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace vitrine::analyzer {

namespace {

constexpr std::size_t bytes_behind = 32;  // a row of a patch is read as 32 bytes
constexpr int first_rows = 3;             // rows of a patch, after which the sum is compared with the bound

int plain_rows(const std::uint8_t* a, std::size_t a_stride, const std::uint8_t* b, std::size_t b_stride,
               int rows) {
    int sum = 0;
    for (int y = 0; y < rows; ++y) {
        for (int i = 0; i < patch_row_bytes; ++i) {
            const int difference = a[i] - b[i];
            sum += difference * difference;
        }
        a += a_stride;
        b += b_stride;
    }
    return sum;
}

int plain_distance(const std::uint8_t* a, std::size_t a_stride, const std::uint8_t* b, std::size_t b_stride,
                   int bound) {
    const int sum = plain_rows(a, a_stride, b, b_stride, first_rows);
    if (sum > bound) return sum;
    return sum + plain_rows(a + first_rows * a_stride, a_stride, b + first_rows * b_stride, b_stride,
                            patch_side - first_rows);
}

#if defined(__x86_64__)

__attribute__((target("avx2"))) int horizontal_sum(__m256i sums) {
    const __m128i four = _mm_add_epi32(_mm256_castsi256_si128(sums), _mm256_extracti128_si256(sums, 1));
    const __m128i two = _mm_add_epi32(four, _mm_shuffle_epi32(four, 0x4E));
    return _mm_cvtsi128_si32(_mm_add_epi32(two, _mm_shuffle_epi32(two, 0xB1)));
}

__attribute__((target("avx2"))) __m256i wide(const std::uint8_t* bytes) {
    __m128i narrow;
    __builtin_memcpy(&narrow, bytes, sizeof narrow);
    return _mm256_cvtepu8_epi16(narrow);
}

__attribute__((target("avx2"))) __m256i row_difference(const std::uint8_t* a, const std::uint8_t* b) {
    const __m256i seven =
        _mm256_set_epi32(0, 0, -1, -1, -1, -1, -1, -1);  // the eighth pixel is not the patch's
    const __m256i left = _mm256_sub_epi16(wide(a), wide(b));
    const __m256i right = _mm256_and_si256(_mm256_sub_epi16(wide(a + 16), wide(b + 16)), seven);
    return _mm256_add_epi32(_mm256_madd_epi16(left, left), _mm256_madd_epi16(right, right));
}

__attribute__((target("avx2"))) int avx2_distance(const std::uint8_t* a, std::size_t a_stride,
                                                  const std::uint8_t* b, std::size_t b_stride, int bound) {
    __m256i sums = _mm256_setzero_si256();
    for (int y = 0; y < first_rows; ++y, a += a_stride, b += b_stride)
        sums = _mm256_add_epi32(sums, row_difference(a, b));
    const int sum = horizontal_sum(sums);
    if (sum > bound) return sum;
    for (int y = first_rows; y < patch_side; ++y, a += a_stride, b += b_stride)
        sums = _mm256_add_epi32(sums, row_difference(a, b));
    return horizontal_sum(sums);
}

#endif

}  // namespace

PatchImage::PatchImage(int width, int height)
    : width_(width),
      height_(height),
      bytes_(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height) + bytes_behind, 1) {}

PatchImage::PatchImage(const cv::Mat& bgr) : PatchImage(bgr.cols, bgr.rows) {
    for (int y = 0; y < height_; ++y) {
        const auto* from = bgr.ptr<std::uint8_t>(y);
        std::uint8_t* to = at(0, y);
        for (int x = 0; x < width_; ++x, from += 3, to += 4)
            std::copy(from, from + 3, to);
    }
}

cv::Mat PatchImage::bgr() const {
    cv::Mat picture(height_, width_, CV_8UC3);
    for (int y = 0; y < height_; ++y) {
        const std::uint8_t* from = at(0, y);
        auto* to = picture.ptr<std::uint8_t>(y);
        for (int x = 0; x < width_; ++x, from += 4, to += 3)
            std::copy(from, from + 3, to);
    }
    return picture;
}

PatchDistance patch_distance() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return avx2_distance;
#endif
    return plain_distance;
}

}  // namespace vitrine::analyzer
