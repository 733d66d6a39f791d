#pragma once

#include "base/settings/choices.hpp"
#include "player/scene/acts/wall_act.hpp"
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
#include <utility>

namespace vitrine::player {

/// The caption of a file on the wall. One that was taken on this day in another year tells its year, if such
/// files come first.
/// @param record  null: nothing is known of the file
std::string caption_on_wall(const std::string& path, const ShowHints& hints, const RecordList::Record& record,
                            CaptionChoice choice);

/// Draws the captions and QR codes of the shots that stand, where nothing matters: asks for their pictures
/// and adds those that are there as words. Looks for a place once for each shot and cell.
class CaptionWords {
  public:
    CaptionWords(std::filesystem::path state, WallWords wall)
        : state_(std::move(state)), wall_(std::move(wall)) {}

    /// Draws these words of the whole wall from now on.
    void set_words(const WallWords& wall) { wall_ = wall; }

    /// @param hints, files  have the captions
    void draw(Frame& frame, const ShowHints& hints, const RecordList& files);

  private:
    enum class Kind {
        code,
        caption,
        wall_code
    };  // codes look for a place first, the wall's after all others

    struct Caption {
        CaptionRoom room;
        std::string text;
        std::shared_ptr<const WordPicture> picture;     // in the form that has room
        std::optional<Box> place;                       // none: no form has room, or none is read yet
        std::size_t forms = 0;                          // those that were tried
        std::optional<std::chrono::nanoseconds> since;  // when it was first drawn
    };

    using Captions = std::map<std::pair<Kind, SourceId>, Caption>;
    using TextOf = std::function<std::string(Kind kind, const std::string& path)>;

    static bool stays(const Caption& caption, const CaptionRoom& room, std::span<const DrawItem> items);
    std::string text_of(Kind kind, const std::string& path, const ShowHints& hints,
                        const RecordList& files) const;
    void draw_idle_words(Frame& frame) const;
    void follow(const Frame& frame, const TextOf& text_of);
    void take_pictures(Vec2 canvas);
    void find_place(Kind kind, Caption& caption, Vec2 canvas) const;
    void find_code_place(Caption& caption, Vec2 canvas, const Box& taken) const;
    Box taken_beside(Kind kind, const Caption& caption) const;

    std::filesystem::path state_;
    WallWords wall_;
    std::optional<WordLoader> loader_;  // made when a caption is first wanted
    std::set<std::string> wanted_;
    std::map<std::string, std::shared_ptr<const WordPicture>> pictures_;  // of wanted keys
    Captions captions_;
};

}  // namespace vitrine::player
