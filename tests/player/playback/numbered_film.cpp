#include "tests/player/playback/numbered_film.hpp"

#include "base/media/gst_ptr.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gst/app/gstappsrc.h>

#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace vitrine::player {

namespace {

constexpr int bits = 10;
constexpr int block = numbered_width / bits;

bool is_bright_at(int index, int x, int y) {
    return y < numbered_height / 2 || ((index >> (x / block)) & 1) != 0;
}

GstBuffer* picture(int index, int rate) {
    constexpr std::size_t bytes = std::size_t{numbered_width} * numbered_height;
    GstBuffer* buffer = gst_buffer_new_allocate(nullptr, bytes, nullptr);
    GstMapInfo map;
    gst_buffer_map(buffer, &map, GST_MAP_WRITE);
    for (int y = 0; y < numbered_height; ++y) {
        for (int x = 0; x < numbered_width; ++x) {
            map.data[y * numbered_width + x] = is_bright_at(index, x, y) ? 220 : 30;
        }
    }
    gst_buffer_unmap(buffer, &map);
    const auto time = [&](int i) {
        return static_cast<GstClockTime>(i) * GST_SECOND / static_cast<GstClockTime>(rate);
    };
    GST_BUFFER_PTS(buffer) = time(index);
    GST_BUFFER_DURATION(buffer) = time(index + 1) - time(index);
    return buffer;
}

/// Brightness in the middle of a part of the picture, given in parts of its size.
int brightness(const Sample& sample, double x, double y) {
    const auto column = static_cast<std::size_t>(x * sample.width);
    const auto row = static_cast<std::size_t>(y * sample.height);
    return std::to_integer<int>(sample.pixels[row * sample.stride + 4 * column + 1]);
}

}  // namespace

Folder::Folder() {
    std::string name = std::filesystem::temp_directory_path() / "vitrine-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot make a folder for the test");
    path = name;
}

Folder::~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
}

void write_film(const std::string& file, const NumberedFilm& film) {
    start_gstreamer();
    const std::string words =
        fmt::format("appsrc name=pictures format=time caps=video/x-raw,format=GRAY8,width={},height={},"
                    "framerate={}/1,pixel-aspect-ratio=1/1 ! videoconvert ! {} ! filesink name=file",
                    numbered_width, numbered_height, film.rate, film.chain);
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    if (!pipeline) throw std::runtime_error("cannot build " + words);
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "pictures"));
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(pipeline.get()), "file"));
    g_object_set(sink.get(), "location", file.c_str(), nullptr);
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    for (int i = 0; i < film.pictures; ++i) {
        gst_app_src_push_buffer(GST_APP_SRC(source.get()), picture(i, film.rate));  // takes the buffer
    }
    gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(
        bus.get(), 60 * GST_SECOND, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    const bool is_written = message && GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS;
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    if (!is_written) throw std::runtime_error("cannot write " + words);
}

int number(const Sample& sample) {
    for (int i = 0; i < bits; ++i) {
        if (brightness(sample, (i + 0.5) / bits, 0.25) < 160) return -1;
    }
    int index = 0;
    for (int i = 0; i < bits; ++i) {
        const int value = brightness(sample, (i + 0.5) / bits, 0.75);
        if (value > 160)
            index |= 1 << i;
        else if (value > 90)
            return -1;
    }
    return index;
}

void write_photo(const std::string& file) {
    std::ofstream stream(file, std::ios::binary);
    const auto number = [&](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            stream.put(static_cast<char>(value >> (8 * i)));
    };
    stream << "BM";
    number(54 + 40 * 20 * 3, 4);
    number(0, 4);
    number(54, 4);
    number(40, 4);
    number(40, 4);
    number(20, 4);
    number(1, 2);
    number(24, 2);
    for (int i = 0; i < 6; ++i)
        number(0, 4);
    for (int i = 0; i < 40 * 20; ++i)
        number(i % 40 < 20 ? 0xff0000 : 0x0000ff, 3);
}

}  // namespace vitrine::player
