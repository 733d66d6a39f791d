#pragma once

#include "base/settings/choices.hpp"
#include "player/scene/files/show_files.hpp"
#include "player/scene/frame.hpp"
#include "player/words/word_loader.hpp"

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>

namespace vitrine::player {

/// The caption of a file on the wall. One that was taken on this day in another year tells its year, if such
/// files come first.
/// @param record  null: nothing is known of the file
std::string caption_on_wall(const std::string& path, const ShowHints& hints, const RecordList::Record& record,
                            CaptionChoice choice);

/// Draws the captions of the shots that stand, where nothing matters: asks for their pictures and adds those
/// that are there as words. Looks for a place once for each shot and cell.
class CaptionWords {
  public:
    CaptionWords(std::filesystem::path state, CaptionChoice choice)
        : state_(std::move(state)), choice_(choice) {}

    /// @param hints, files  have the captions
    void draw(Frame& frame, const ShowHints& hints, const RecordList& files);

  private:
    struct Caption {
        CaptionRoom room;
        std::string text;
        std::shared_ptr<const WordPicture> picture;     // in the form that has room
        std::optional<Box> place;                       // none: no form has room, or none is read yet
        std::size_t forms = 0;                          // those that were tried
        std::optional<std::chrono::nanoseconds> since;  // when it was first drawn
    };

    using TextOf = std::function<std::string(const std::string& path)>;

    void follow(const Frame& frame, const TextOf& text_of);
    void take_pictures(Vec2 canvas);
    void find_place(Caption& caption, Vec2 canvas) const;

    std::filesystem::path state_;
    CaptionChoice choice_;
    std::optional<WordLoader> loader_;  // made when a caption is first wanted
    std::set<std::string> wanted_;
    std::map<std::string, std::shared_ptr<const WordPicture>> pictures_;  // of wanted keys
    std::map<SourceId, Caption> captions_;
};

}  // namespace vitrine::player
