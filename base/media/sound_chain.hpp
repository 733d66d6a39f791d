#pragma once

#include "base/media/gst_ptr.hpp"
#include "base/media/media_type.hpp"

#include <memory>
#include <string>

namespace vitrine {

/// A pipeline of our own for the first usable sound of one film, and nothing else of it:
///
///     filesrc ! demuxer ! parser ! decoder ! tail
///
/// As in a DecodeChain only what the table of decoders names is ever reached by a file. The pipeline is the
/// caller's to use; its errors come as messages, a film without sound is one of them.
class SoundChain {
  public:
    enum class Form {
        raw,    // decoded
        coded,  // as it is in the film, without the decoder
    };

    /// Nothing runs yet: the pipeline stands in state NULL.
    /// @param path  any bytes
    /// @param tail  an element or bin with one pad "sink" that ends in a sink
    /// @throws MediaError where the file is no film
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

/// Whether an error says that the film has no sound that could be heard here.
bool lacks_sound(GstMessage* error);

/// What an error says.
std::string text_of(GstMessage* error);

}  // namespace vitrine
