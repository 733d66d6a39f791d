#include "analyzer/store/stored_sound.hpp"

#include "base/media/sound_chain.hpp"
#include "tests/temporary_directory.hpp"

#include <cstdlib>
#include <limits>

using namespace vitrine;
using namespace vitrine::analyzer;
namespace fs = std::filesystem;

namespace {

constexpr GstClockTime patience = 60 * GST_SECOND;

void run(GstElement* pipeline) {
    const GstPtr<GstBus> bus(gst_element_get_bus(pipeline));
    gst_element_set_state(pipeline, GST_STATE_PLAYING);
    const GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(
        bus.get(), patience, static_cast<GstMessageType>(GST_MESSAGE_EOS | GST_MESSAGE_ERROR)));
    const bool is_over = message && GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS;
    REQUIRE(is_over);
}

/// Three seconds of pictures, and of a tone where a coder of sound is named.
std::string write_film(const fs::path& path, const std::string& sound) {
    start_gstreamer();
    const std::string tone =
        sound.empty() ? "" : "audiotestsrc num-buffers=129 ! audioconvert ! " + sound + " ! queue ! m. ";
    const std::string words =
        tone +
        "videotestsrc num-buffers=30 ! video/x-raw,format=I420,width=64,height=48,framerate=10/1"
        " ! jpegenc ! queue ! qtmux name=m ! filesink location=" +
        path.string();
    const GstPtr<GstElement> pipeline(gst_parse_launch(words.c_str(), nullptr));
    REQUIRE(pipeline);
    run(pipeline.get());
    gst_element_set_state(pipeline.get(), GST_STATE_NULL);
    return path.string();
}

/// Seconds of sound in a file, decoded.
double seconds_of_sound(const fs::path& path) {
    GstPtr<GstElement> tail =
        make_bin("audioconvert ! audioresample ! audio/x-raw,format=S16LE,rate=8000,channels=1"
                 " ! identity silent=false ! fakesink name=sink signal-handoffs=true");
    const GstPtr<GstElement> sink(gst_bin_get_by_name(GST_BIN(tail.get()), "sink"));
    std::size_t bytes = 0;
    const auto count = +[](GstElement*, GstBuffer* buffer, GstPad*, gpointer into) {
        *static_cast<std::size_t*>(into) += gst_buffer_get_size(buffer);
    };
    g_signal_connect(sink.get(), "handoff", G_CALLBACK(count), &bytes);
    const SoundChain chain(path.string(), std::move(tail), SoundChain::Form::raw);
    run(chain.pipeline());
    return static_cast<double>(bytes) / 2 / 8000;
}

struct Shelf {
    TemporaryDirectory home;
    StorePlace place{.store = home.path / "store", .id = std::string(16, 'a'), .max_bytes = 1U << 20};
};

}  // namespace

TEST_CASE("the sound of a film is kept as it is coded there") {
    const Shelf shelf;
    const std::string film = write_film(shelf.home.path / "a.mp4", "avenc_aac");

    const StoredSound sound = store_sound(film, shelf.place);

    CHECK(sound == StoredSound{.file = shelf.place.id + "/sound"});
    const fs::path kept = shelf.place.store / sound.file;
    CHECK(seconds_of_sound(kept) == doctest::Approx(3).epsilon(0.05));
    CHECK(fs::file_size(kept) < fs::file_size(film));
    CHECK_FALSE(fs::exists(kept.string() + ".new"));
}

TEST_CASE("a film without sound is known to have none") {
    const Shelf shelf;
    const std::string film = write_film(shelf.home.path / "a.mp4", "");
    CHECK(store_sound(film, shelf.place) == StoredSound{});
    CHECK_FALSE(fs::exists(shelf.place.store / shelf.place.id / "sound"));
}

TEST_CASE("a sound that is too large gives its place away") {
    Shelf shelf;
    shelf.place.max_bytes = 100;
    const std::string film = write_film(shelf.home.path / "a.mov", "identity");
    CHECK(store_sound(film, shelf.place).is_dropped);
    CHECK_FALSE(fs::exists(shelf.place.store / shelf.place.id / "sound"));
    CHECK_FALSE(fs::exists(shelf.place.store / shelf.place.id / "sound.new"));
}

TEST_CASE("where the disk has no room a sound is named all the same") {
    Shelf shelf;
    shelf.place.min_free_bytes = std::numeric_limits<std::uint64_t>::max();
    const std::string film = write_film(shelf.home.path / "a.mp4", "avenc_aac");
    CHECK(store_sound(film, shelf.place) == StoredSound{.file = shelf.place.id + "/sound"});
    CHECK_FALSE(fs::exists(shelf.place.store / shelf.place.id / "sound"));
}
