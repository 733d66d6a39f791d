#include "player/stage/caption_words.hpp"

#include "base/hints/hint_words.hpp"
#include "base/state/word_picture.hpp"
#include "player/scene/caption_place.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace vitrine::player {

namespace {

constexpr std::chrono::nanoseconds fade = std::chrono::milliseconds(500);

}  // namespace

void CaptionWords::draw(Frame& frame, const ShowHints& hints) {
    if (choice_ == CaptionChoice::none && wall_code_.empty() && frame.captions.empty()) return;
    follow(frame, hints);
    take_pictures(frame.canvas);
    for (auto& [key, caption] : captions_) {
        if (!caption.place) continue;
        if (!caption.since) caption.since = frame.time;
        const double age = std::chrono::duration<double>(frame.time - *caption.since) / fade;
        frame.words.push_back({.picture = caption.picture,
                               .place = *caption.place,
                               .alpha = std::clamp(age, 0.0, 1.0),
                               .is_sharp = key.first != Kind::caption});
    }
    if (frame.idle >= 1 && frame.items.empty()) draw_idle_code(frame);
}

void CaptionWords::draw_idle_code(Frame& frame) const {
    const auto known = pictures_.find(code_key(wall_code_));
    if (known == pictures_.end()) return;
    frame.words.push_back({.picture = known->second,
                           .place = idle_code_place(known->second->width, frame.canvas),
                           .is_sharp = true});
}

std::string CaptionWords::text_of(Kind kind, const std::string& path, const ShowHints& hints) const {
    if (kind == Kind::wall_code) return wall_code_;
    const ShowHints::Entry file = hints.find(path);
    if (kind == Kind::code) return file ? file->hints.code.value_or("") : "";
    if (choice_ == CaptionChoice::none) return "";
    const std::string written = file ? file->hints.caption.value_or("") : "";
    return caption_of(written, path, choice_ == CaptionChoice::names);
}

/// Keeps the captions of the shots that stand as they stood, and begins those of others.
void CaptionWords::follow(const Frame& frame, const ShowHints& hints) {
    Captions before = std::exchange(captions_, {});
    std::set<std::string> keys;
    if (!wall_code_.empty()) keys.insert(code_key(wall_code_));
    for (const CaptionRoom& room : frame.captions)
        for (const Kind kind : {Kind::code, Kind::caption, Kind::wall_code}) {
            std::string text = text_of(kind, room.path, hints);
            if (text.empty()) continue;
            if (kind == Kind::code) keys.insert(code_key(text));
            for (int lines = 1; kind == Kind::caption && lines <= caption_forms; ++lines)
                keys.insert(caption_key(text, lines));
            const auto known = before.find({kind, room.source});
            const bool is_same =
                known != before.end() && known->second.text == text && known->second.room == room;
            captions_[{kind, room.source}] =
                is_same ? std::move(known->second) : Caption{.room = room, .text = text};
        }
    const bool is_changing = frame.captions.empty() && !wanted_.empty();  // such a wall keeps the pictures
    if (keys == wanted_ || is_changing) return;
    std::erase_if(pictures_, [&](const auto& known) { return !keys.contains(known.first); });
    if (!loader_) loader_.emplace(state_);
    wanted_ = keys;
    loader_->want(std::move(keys));
}

void CaptionWords::take_pictures(Vec2 canvas) {
    if (!loader_) return;
    for (LoadedWord& word : loader_->take())
        if (wanted_.contains(word.text) && word.picture && word.picture->height > 0)
            pictures_[word.text] = std::move(word.picture);
    bool has_wall_code = std::ranges::any_of(captions_, [](const auto& known) {
        return known.first.first == Kind::wall_code && known.second.place;
    });
    for (auto& [key, caption] : captions_) {
        const bool is_walls = key.first == Kind::wall_code;
        if (caption.place || (is_walls && has_wall_code)) continue;
        find_place(key.first, caption, canvas);
        has_wall_code |= is_walls && caption.place;
    }
}

/// The place of what the shot has already. The wall's code goes where a shot has nothing else in its way.
Box CaptionWords::taken_beside(Kind kind, const Caption& caption) const {
    Box taken;
    for (const Kind other : {Kind::code, Kind::caption, Kind::wall_code}) {
        const auto known = captions_.find({other, caption.room.source});
        if (other == kind || known == captions_.end() || !known->second.place) continue;
        const Box& place = *known->second.place;
        taken = taken.is_empty()
                    ? place
                    : Box{{std::min(taken.min.x, place.min.x), std::min(taken.min.y, place.min.y)},
                          {std::max(taken.max.x, place.max.x), std::max(taken.max.y, place.max.y)}};
    }
    return taken;
}

/// Looks for a place when further forms have been read.
void CaptionWords::find_place(Kind kind, Caption& caption, Vec2 canvas) const {
    const Box taken = taken_beside(kind, caption);
    if (kind != Kind::caption) return find_code_place(caption, canvas, taken);
    std::vector<std::shared_ptr<const WordPicture>> pictures;
    std::vector<CaptionSize> sizes;
    for (int lines = 1; lines <= caption_forms; ++lines) {
        const auto known = pictures_.find(caption_key(caption.text, lines));
        if (known == pictures_.end()) continue;
        const double height = known->second->height;
        pictures.push_back(known->second);
        sizes.push_back({.aspect = known->second->width / height, .letters = word_letters / height});
    }
    if (sizes.size() == std::exchange(caption.forms, sizes.size())) return;
    const auto place = caption_place(caption.room, sizes, canvas, taken);
    if (!place) return;
    caption.place = place->box;
    caption.picture = pictures[place->form];
}

void CaptionWords::find_code_place(Caption& caption, Vec2 canvas, const Box& taken) const {
    const auto known = pictures_.find(code_key(caption.text));
    if (known == pictures_.end() || std::exchange(caption.forms, 1) == 1) return;
    caption.place = code_place(caption.room, known->second->width, canvas, taken);
    if (caption.place) caption.picture = known->second;
}

}  // namespace vitrine::player
