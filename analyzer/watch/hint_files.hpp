#pragma once

#include "analyzer/watch/media_folder.hpp"
#include "base/hints/folder_hints.hpp"
#include "base/hints/keyframe_choice.hpp"
#include "base/system/event_loop.hpp"

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace vitrine::analyzer {

/// Reads the files that operators put beside the media: `.vitrine.toml`, whose hints it hands to the player
/// in STATE/hints.json with the captions and QR codes of media, and the files that choose the keyframes of
/// tapestries. Logs.
class HintFiles {
  public:
    static constexpr std::size_t max_bytes = 1U << 16;  // in one of them

    /// @param folder     outlives this
    /// @param hand_over  STATE/hints.json
    /// @param due        called from the loop when read_soon() was called: it is time to read()
    HintFiles(EventLoop& loop, const MediaFolder& folder, std::filesystem::path hand_over,
              std::function<void()> due);

    /// One of them is just being written: it is read once it is whole.
    void read_soon();

    /// Reads all of them anew. @param paths  the media, in order; the folders of these are searched
    /// @param sidecars  those that there may be, see is_sidecar()
    void read(const std::vector<std::string>& paths, const std::set<std::string>& sidecars = {});

    /// The keyframes that were chosen, by the paths of films.
    const KeyframeChoices& keyframe_choices() const { return choices_; }

    /// The hints for one file, by all names and folders above it.
    Hints hints_for(const std::string& path) const { return hints_of(path, hints_); }

    /// Mistakes in them: file, line and what is allowed.
    const std::vector<std::string>& faults() const { return faults_; }

  private:
    void read_folder(const std::string& folder);
    void read_keyframes(const std::string& path, const std::string& film, KeyframeChoices& choices);
    void read_words(const std::string& path, const std::vector<std::string>& paths);
    void write_hand_over();

    const MediaFolder& folder_;
    std::filesystem::path hand_over_;
    FolderHints hints_;
    KeyframeChoices choices_;
    std::vector<std::string> faults_;
    std::set<std::string> logged_;  // faults that are in the log
    std::string written_;           // the content of hand_over_
    EventLoop::Source due_;
};

}  // namespace vitrine::analyzer
