#pragma once

#include "analyzer/film/film_source.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <gst/app/gstappsrc.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// The format of a film of three equal pictures.
struct DrawnFilm {
    std::string caps;                                // caps of the raw pictures, behind "video/x-raw,"
    std::string chain = "avenc_ffv1 ! matroskamux";  // encoder and container: without loss
    std::vector<std::uint8_t> picture;               // all planes, rows without gaps
};

/// Writes it into the folder. @return its path
inline std::string written(const TemporaryDirectory& folder, const DrawnFilm& film) {
    start_gstreamer();
    const std::string path = (folder.path / "film").string();
    const std::string words =
        fmt::format("appsrc name=pictures format=time caps=video/x-raw,framerate=25/1,{} ! {} ! "
                    "filesink location={}",
                    film.caps, film.chain, path);
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    REQUIRE(pipeline);
    const GstPtr<GstElement> source(gst_bin_get_by_name(GST_BIN(pipeline.get()), "pictures"));
    gst_element_set_state(pipeline.get(), GST_STATE_PLAYING);
    for (GstClockTime i = 0; i < 3; ++i) {
        GstBuffer* buffer = gst_buffer_new_memdup(film.picture.data(), film.picture.size());
        GST_BUFFER_PTS(buffer) = i * 40 * GST_MSECOND;
        GST_BUFFER_DURATION(buffer) = 40 * GST_MSECOND;
        gst_app_src_push_buffer(GST_APP_SRC(source.get()), buffer);  // takes the buffer
    }
    gst_app_src_end_of_stream(GST_APP_SRC(source.get()));
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline.get()));
    const GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(
        bus.get(), 60 * GST_SECOND, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    REQUIRE(message);
    REQUIRE(GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS);
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    return path;
}

}  // namespace vitrine::analyzer
