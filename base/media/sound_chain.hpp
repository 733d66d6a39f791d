#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <memory>
#include <string>

namespace vitrine {

/// A pipeline for the first usable sound stream of one film and nothing else:
///
///     filesrc ! demuxer ! parser ! decoder ! tail
///
/// A file reaches only the elements of the table of decoders, like that of a DecodeChain. The caller may use
/// the pipeline freely. Its errors arrive as messages; a film without sound is one of them.
class SoundChain {
  public:
    enum class Form {
        raw,    // decoded
        coded,  // the film's own coding, not decoded
    };

    /// Builds the pipeline and leaves it in state NULL.
    /// @param path  any bytes
    /// @param tail  an element or bin with one pad "sink" that ends in a sink
    /// @throws MediaError if the file is no film
    SoundChain(const std::string& path, GstPtr<GstElement> tail, Form form);
    ~SoundChain();
    SoundChain(const SoundChain&) = delete;
    SoundChain& operator=(const SoundChain&) = delete;

    GstElement* pipeline() const { return pipeline_.get(); }

    GstBus* bus() const { return bus_.get(); }

    MediaFormat format() const { return format_; }

  private:
    struct Links;

    MediaFormat format_{};
    GstPtr<GstElement> pipeline_;
    GstPtr<GstElement> tail_;
    GstPtr<GstBus> bus_;
    std::unique_ptr<Links> links_;  // used by the demuxer's thread while the pipeline runs
};

/// True if an error means that the film has no sound that can be played here.
bool lacks_sound(GstMessage* error);

/// The text of an error.
std::string text_of(GstMessage* error);

}  // namespace vitrine
