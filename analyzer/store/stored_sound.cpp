#include "analyzer/store/stored_sound.hpp"

#include "base/media/sound_chain.hpp"
#include "base/state/media_error.hpp"
#include "base/system/atomic_file.hpp"
#include "base/system/log.hpp"

#include <cstdint>
#include <stdexcept>
#include <system_error>

namespace vitrine::analyzer {

namespace {

namespace fs = std::filesystem;

constexpr std::int64_t index_interval = 1'000'000'000;  // ns between two places that can be searched
constexpr GstClockTime look_interval = GST_SECOND / 4;  // between two checks of its size

enum class End { whole, without_sound, too_large, no_room };

/// One element with a pad "sink" that writes coded sound to a file. A muxer has no such pad of its own: it
/// gives one on request.
GstPtr<GstElement> writer(const fs::path& to) {
    GstPtr<GstElement> bin(gst_bin_new(nullptr));
    gst_object_ref_sink(bin.get());
    const GstPtr<GstElement> muxer = make_element("matroskamux");
    const GstPtr<GstElement> sink = make_element("filesink");
    gst_bin_add(GST_BIN(bin.get()), muxer.get());
    gst_bin_add(GST_BIN(bin.get()), sink.get());
    g_object_set(muxer.get(), "min-index-interval", index_interval, nullptr);
    g_object_set(sink.get(), "location", to.c_str(), nullptr);
    const GstPtr<GstPad> pad(gst_element_request_pad_simple(muxer.get(), "audio_%u"));
    if (!pad || !gst_element_link(muxer.get(), sink.get()))
        throw std::runtime_error("the sound file cannot be written");
    gst_element_add_pad(bin.get(), gst_ghost_pad_new("sink", pad.get()));  // the bin takes the pad
    return bin;
}

bool is_larger(const fs::path& file, std::uint64_t max_bytes) {
    std::error_code missing;
    const std::uintmax_t bytes = fs::file_size(file, missing);
    return !missing && bytes > max_bytes;
}

/// @throws std::runtime_error where the film cannot be read, MediaError where it is no film
End write(const std::string& film, const fs::path& to, const StorePlace& place) {
    start_gstreamer();
    const SoundChain chain(film, writer(to), SoundChain::Form::coded);
    gst_element_set_state(chain.pipeline(), GST_STATE_PLAYING);  // a failure comes as a message
    while (true) {
        const GstPtr<GstMessage> message(gst_bus_timed_pop_filtered(
            chain.bus(), look_interval, static_cast<GstMessageType>(GST_MESSAGE_ERROR | GST_MESSAGE_EOS)));
        if (is_larger(to, place.max_bytes)) return End::too_large;
        if (!has_room(place)) return End::no_room;
        if (!message) continue;
        if (GST_MESSAGE_TYPE(message.get()) == GST_MESSAGE_EOS) return End::whole;
        if (lacks_sound(message.get())) return End::without_sound;
        throw std::runtime_error(text_of(message.get()));
    }
}

}  // namespace

StoredSound store_sound(const std::string& file, const StorePlace& place) {
    StoredSound sound{.file = place.id + "/sound"};
    const fs::path to = place.store / sound.file;
    try {
        fs::create_directories(to.parent_path());
        if (fs::exists(to) || !has_room(place)) return sound;
        const End end = write(file, unfinished(to), place);
        if (end == End::whole) publish_file(unfinished(to), to);
        if (end == End::without_sound) sound.file.clear();
        sound.is_dropped = end == End::too_large;
    } catch (const std::system_error& error) {  // a full disk is no reason not to show it
        log::debug("the sound '{}' is not stored: {}", sound.file, error.what());
    } catch (const std::runtime_error& error) {
        log::debug("no sound for '{}': {}", sound.file, error.what());
        if (has_room(place)) sound.file.clear();
    }
    std::error_code ignored;  // usually it is not there
    fs::remove(unfinished(to), ignored);
    return sound;
}

}  // namespace vitrine::analyzer
