#pragma once

#include "player/scene/frame.hpp"
#include "player/stage/caption_words.hpp"
#include "player/words/word_loader.hpp"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// Draws the names and captions of a frame: asks for their pictures, and adds those that are there as words.
class FolderWords {
  public:
    explicit FolderWords(std::filesystem::path state, WallWords wall = {})
        : state_(std::move(state)), captions_(state_, std::move(wall)) {}

    /// Draws these words of the whole wall from now on.
    void set_words(const WallWords& wall) { captions_.set_words(wall); }

    /// @param hints, files  have the captions
    void draw(Frame& frame, const ShowHints& hints = {}, const RecordList& files = {});

  private:
    void draw_names(Frame& frame);

    std::filesystem::path state_;
    std::optional<WordLoader> loader_;  // made when a name is first seen
    std::set<std::string> wanted_;
    std::map<std::string, std::shared_ptr<const WordPicture>> pictures_;  // of wanted texts
    CaptionWords captions_;
};

/// The place of a picture in the box for its text: as large as it fits, in the middle.
Box word_place(const Box& box, const WordPicture& picture);

}  // namespace vitrine::player
