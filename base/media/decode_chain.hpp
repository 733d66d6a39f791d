#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"
#include "base/state/media_error.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <string>

namespace vitrine {

/// Decoder elements that replace others: name in decoder_table.hpp -> name of the element to use.
using DecoderMap = std::map<std::string, std::string>;

struct DecodeOptions {
    int max_threads = 1;  // decoder threads; 1: it decodes in the demuxer's own thread
    DecoderMap instead;   // decoders that replace those of the table
};

/// A pipeline that decodes the first usable video stream of one film and nothing else:
///
///     filesrc ! demuxer ! parser ! decoder ! deinterlace ! tail
///
/// The content of the file selects the demuxer; a table selects the parser and the decoder. So no file
/// reaches another plugin of the machine. The pictures of an animation come from libvips (animation_source)
/// instead of the first four elements. A film with a picture beyond the limits of film_size.hpp fails
/// there, before the picture is decoded where its stream or its header tells the size. Sound, subtitles and
/// further video streams are not decoded. `deinterlace` does not change progressive pictures. The decoder's
/// pictures arrive in the tail as they are coded: in any raw format, with the pixel aspect ratio in the caps
/// and the rotation as the tag image-orientation (videoflip video-direction=auto obeys it).
///
/// The pipeline is a plain GstPipeline. The caller may seek (also with SEGMENT), set its state and read its
/// bus. To decode ahead, begin the tail with a queue; without one, all elements run in a single thread.
class DecodeChain {
  public:
    /// Builds the pipeline and leaves it in state NULL.
    /// @param path  any bytes
    /// @param tail  an element or bin with one pad "sink" that ends in a sink; make_bin() makes one
    /// @throws MediaError if the file is no film
    DecodeChain(const std::string& path, GstPtr<GstElement> tail, DecodeOptions options = {});
    ~DecodeChain();
    DecodeChain(const DecodeChain&) = delete;
    DecodeChain& operator=(const DecodeChain&) = delete;

    GstElement* pipeline() const { return pipeline_.get(); }

    GstBus* bus() const { return bus_.get(); }

    /// The tail given to the constructor, lent.
    GstElement* tail() const { return tail_.get(); }

    MediaFormat format() const { return format_; }

    /// Goes to PAUSED and waits until the first picture is in the sink.
    /// @throws MediaError if the film cannot be played, or stalls
    void preroll();

    /// Waits for the next sample of an appsink in the tail. None: the film has ended.
    /// @throws MediaError if the film fails on the way, or stalls: for 20 s no sample comes and almost no
    /// processor time is used. This is no limit for a slow machine; the caller sets one
    GstPtr<GstSample> pull(GstAppSink* sink);

    /// The duration that the container declares, zero if it declares none. Known after preroll().
    std::chrono::nanoseconds duration() const;

    /// Throws the waiting error of the bus, if there is one. For use while the caller waits for pictures.
    void throw_pending_error() const;

  private:
    struct Links;

    void link_animation(const std::string& path);
    MediaError stuck(const char* reason);

    MediaFormat format_{};
    GstPtr<GstElement> pipeline_;
    GstPtr<GstElement> tail_;
    GstPtr<GstBus> bus_;
    std::unique_ptr<Links> links_;  // used by the demuxer's thread while the pipeline runs
    bool is_stuck_ = false;         // a decoder hangs
};

/// The state and the plain words for an error message of a pipeline.
MediaError media_error(GstMessage* message);

}  // namespace vitrine
