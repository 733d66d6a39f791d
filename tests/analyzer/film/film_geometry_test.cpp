// Known places in the stored picture, and where the analysis sees them.

#include "tests/analyzer/film/drawn_film.hpp"

#include <gst/gst.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

using namespace vitrine;
using namespace vitrine::analyzer;

namespace {

constexpr int width = 128;
constexpr int height = 64;
// Grey levels of the stored picture: top left, top right, bottom ...
constexpr std::array<int, 4> quarters{40, 100, 160, 220};

DrawnFilm drawn(const std::string& more, const std::string& chain, const auto& grey_at) {
    DrawnFilm film{.caps = fmt::format("width={},height={},format=I420,colorimetry=(string)1:3:5:1{}", width,
                                       height, more),
                   .chain = chain};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            film.picture.push_back(static_cast<std::uint8_t>(grey_at(x, y)));
    film.picture.insert(film.picture.end(), width * height / 2, 128);
    return film;
}

int quarter_at(int x, int y) {
    return quarters[static_cast<std::size_t>((x < width / 2 ? 0 : 1) + (y < height / 2 ? 0 : 2))];
}

constexpr const char* lossless = "avenc_ffv1 ! matroskamux";
constexpr const char* mp4 = "avenc_mpeg4 bitrate=2000000 ! qtmux";

/// The matrix that a track is shown by, without its last column: x' = a x + c y, y' = b x + d y. ISO
/// 14496-12, 8.3.2.
struct Matrix {
    int a, b, c, d;
};

void set_matrix(const std::string& path, const Matrix& matrix) {
    std::ifstream in(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    const std::size_t header = bytes.find("tkhd");
    REQUIRE(header != std::string::npos);
    const auto put = [&](std::size_t index, int value) {
        for (std::size_t i = 0; i < 4; ++i)
            bytes[header + 44 + 4 * index + i] =
                static_cast<char>(value * 65536 >> (24 - 8 * static_cast<int>(i)) & 255);
    };
    put(0, matrix.a);
    put(1, matrix.b);
    put(3, matrix.c);
    put(4, matrix.d);
    std::ofstream(path, std::ios::binary) << bytes;
}

/// The film's orientation as the demuxer tells it: "flip-rotate-0", ...; "" where it says nothing.
std::string told_orientation(const std::string& path) {
    const std::string line = fmt::format("filesrc location={} ! qtdemux ! fakesink", path);
    GstElement* pipeline = gst_parse_launch(line.c_str(), nullptr);
    REQUIRE(pipeline != nullptr);
    gst_element_set_state(pipeline, GST_STATE_PLAYING);
    GstBus* bus = gst_element_get_bus(pipeline);
    std::string told;
    constexpr auto wanted =
        static_cast<GstMessageType>(GST_MESSAGE_TAG | GST_MESSAGE_EOS | GST_MESSAGE_ERROR);
    bool is_over = false;
    while (!is_over) {
        GstMessage* message = gst_bus_timed_pop_filtered(bus, 60 * GST_SECOND, wanted);
        REQUIRE(message != nullptr);
        is_over = GST_MESSAGE_TYPE(message) != GST_MESSAGE_TAG;
        if (!is_over) {
            GstTagList* tags = nullptr;
            gst_message_parse_tag(message, &tags);
            gchar* value = nullptr;
            if (gst_tag_list_get_string(tags, GST_TAG_IMAGE_ORIENTATION, &value) != 0) told = value;
            g_free(value);
            gst_tag_list_unref(tags);
        }
        gst_message_unref(message);
    }
    gst_object_unref(bus);
    gst_element_set_state(pipeline, GST_STATE_NULL);
    gst_object_unref(pipeline);
    return told;
}

int grey(const cv::Mat& picture, double x, double y) {
    return picture.at<cv::Vec3b>(static_cast<int>(y * picture.rows), static_cast<int>(x * picture.cols))[1];
}

}  // namespace

// All but the eighth, mirrored along the rising diagonal: qtdemux 1.22 does not know it.
TEST_CASE("a film is upright under the matrices of its track, mirrored ones too") {
    const TemporaryDirectory folder;
    const std::string path = written(folder, drawn("", mp4, quarter_at));
    for (const Matrix& m :
         {Matrix{1, 0, 0, 1}, Matrix{0, 1, -1, 0}, Matrix{-1, 0, 0, -1}, Matrix{0, -1, 1, 0},
          Matrix{-1, 0, 0, 1}, Matrix{1, 0, 0, -1}, Matrix{0, 1, 1, 0}}) {
        CAPTURE(m.a);
        CAPTURE(m.b);
        CAPTURE(m.c);
        CAPTURE(m.d);
        set_matrix(path, m);
        const bool is_mirrored = m.a * m.d - m.b * m.c < 0;
        if (is_mirrored && !told_orientation(path).starts_with("flip")) {
            MESSAGE("this qtdemux does not know mirrored tracks");  // Debian's before 1.22.0-5+deb12u4
            continue;
        }
        FilmSource source(path, 64);
        CHECK(source.info().width == (m.a != 0 ? width : height));
        CHECK(source.info().height == (m.a != 0 ? height : width));
        const std::optional<FilmFrame> frame = source.next();
        REQUIRE(frame.has_value());
        for (const int x : {-1, 1})
            for (const int y : {-1, 1}) {
                const int stored = quarter_at((x + 1) * width / 3, (y + 1) * height / 3);
                const int seen =
                    grey(frame->picture, 0.5 + 0.25 * (m.a * x + m.c * y), 0.5 + 0.25 * (m.b * x + m.d * y));
                CHECK(std::abs(seen - stored) <= 25);  // the encoder narrows the range
            }
    }
}

TEST_CASE("a film of wide pixels is as wide as it is shown") {
    const TemporaryDirectory folder;
    FilmSource source(written(folder, drawn(",pixel-aspect-ratio=2/1", lossless, quarter_at)), 64);
    CHECK(source.info().width == 2 * width);
    CHECK(source.info().height == height);
    const std::optional<FilmFrame> frame = source.next();
    REQUIRE(frame.has_value());
    CHECK(frame->picture.size() == cv::Size(64, 16));
}

TEST_CASE("of an interlaced film the top field is seen") {
    const TemporaryDirectory folder;
    const auto woven = [](int, int y) { return y % 2 == 0 ? 200 : 60; };
    FilmSource source(
        written(folder, drawn(",interlace-mode=interleaved,field-order=top-field-first", lossless, woven)),
        64);
    const std::optional<FilmFrame> frame = source.next();
    REQUIRE(frame.has_value());
    for (const double y : {0.3, 0.5, 0.7})
        CHECK(std::abs(grey(frame->picture, 0.5, y) - 200) <= 3);
}

TEST_CASE("a frame has a finer picture, upright too, where the film has more px than are wanted") {
    const TemporaryDirectory folder;
    const std::string path = written(folder, drawn("", mp4, quarter_at));
    set_matrix(path, Matrix{0, 1, -1, 0});
    FilmSource source(path, 32);
    const std::optional<FilmFrame> frame = source.next();
    REQUIRE(frame.has_value());
    REQUIRE(frame->finer);
    const cv::Mat finer = frame->finer();
    CHECK(frame->picture.size() == cv::Size(16, 32));
    CHECK(finer.size() == cv::Size(32, 64));
    for (const double x : {0.25, 0.75})
        for (const double y : {0.25, 0.75})
            CHECK(std::abs(grey(finer, x, y) - grey(frame->picture, x, y)) <= 3);

    FilmSource small(path, width);
    CHECK(!small.next()->finer);
}
