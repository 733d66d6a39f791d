#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"
#include "base/state/media_error.hpp"

#include <chrono>
#include <map>
#include <memory>
#include <string>

namespace vitrine {

/// Names of decoder elements to be used, by the names of those of the table (decoder_table.hpp).
using DecoderMap = std::map<std::string, std::string>;

struct DecodeOptions {
    int max_threads = 1;  // of the decoder; 1 decodes in the demuxer's own thread
    DecoderMap instead;   // decoders other than the table's
};

/// A pipeline of our own that decodes the first usable video stream of one film and nothing else:
///
///     filesrc ! demuxer ! parser ! decoder ! deinterlace ! tail
///
/// The demuxer follows from the file's content, parser and decoder from a table, so that nothing else in the
/// machine's plugins is ever reached by a file. Sound, subtitles and further video streams are left
/// undecoded. `deinterlace` passes progressive pictures through untouched. The decoder's frames arrive in the
/// tail as they are coded: in any raw format, with their pixel aspect ratio in the caps and their rotation as
/// the tag image-orientation (videoflip video-direction=auto obeys it).
///
/// The pipeline is a plain GstPipeline: seeks (SEGMENT ones too), states and its bus are the caller's to use.
/// A queue belongs at the start of the tail where decoding ahead is wanted; without one it all runs in a
/// single thread.
class DecodeChain {
  public:
    /// Nothing runs yet: the pipeline stands in state NULL.
    /// @param path  any bytes
    /// @param tail  an element or bin with one pad "sink" that ends in a sink; make_bin() makes one
    /// @throws MediaError where the file is no film
    DecodeChain(const std::string& path, GstPtr<GstElement> tail, DecodeOptions options = {});
    ~DecodeChain();
    DecodeChain(const DecodeChain&) = delete;
    DecodeChain& operator=(const DecodeChain&) = delete;

    GstElement* pipeline() const { return pipeline_.get(); }

    GstBus* bus() const { return bus_.get(); }

    /// The tail that was given, lent.
    GstElement* tail() const { return tail_.get(); }

    MediaFormat format() const { return format_; }

    /// Goes to PAUSED and waits until the first frame stands in the sink.
    /// @throws MediaError where the film cannot be played, or stalls
    void preroll();

    /// The next sample of an appsink in the tail; none at the film's end.
    /// @throws MediaError where the film fails on the way, or stalls: for 20 s nothing comes and next to
    /// nothing is computed. How long a slow machine may take is for others to say
    GstPtr<GstSample> pull(GstAppSink* sink);

    /// What the container declares, zero where it does not. Known once prerolled.
    std::chrono::nanoseconds duration() const;

    /// Throws the error that waits on the bus, if any: for use while frames are awaited.
    void throw_pending_error() const;

  private:
    struct Links;

    MediaFormat format_{};
    GstPtr<GstElement> pipeline_;
    GstPtr<GstElement> tail_;
    GstPtr<GstBus> bus_;
    std::unique_ptr<Links> links_;  // used by the demuxer's thread while the pipeline runs
};

/// The state and the plain words for an error message of a pipeline.
MediaError media_error(GstMessage* message);

}  // namespace vitrine
