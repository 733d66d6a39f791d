#include "player/stage/caption_words.hpp"

#include "base/calendar/dates.hpp"
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

std::string caption_on_wall(const std::string& path, const ShowHints& hints, const RecordList::Record& record,
                            CaptionChoice choice) {
    const ShowHints::Entry file = hints.find(path);
    const std::string written = file ? file->hints.caption.value_or("") : "";
    CaptionSources sources{
        .written = written, .own = "", .path = choice == CaptionChoice::names ? std::string_view(path) : ""};
    if (!record) return caption_of(sources);
    sources.own = record->origin.caption;
    const auto day = record->origin.day_of_camera();
    if (day && hints.today && is_anniversary(*day, *hints.today)) sources.day = day;
    return caption_of(sources);
}

void CaptionWords::draw(Frame& frame, const ShowHints& hints, const RecordList& files) {
    const bool has_wall_words = !wall_.code.empty() || !wall_.share.empty();
    if (wall_.captions == CaptionChoice::none && !has_wall_words && frame.captions.empty()) return;
    follow(frame, [&](Kind kind, const std::string& path) { return text_of(kind, path, hints, files); });
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
    if (frame.idle >= 1 && frame.items.empty()) draw_idle_words(frame);
}

void CaptionWords::draw_idle_words(Frame& frame) const {
    const auto add = [&](const std::string& key, bool is_sharp, const auto& place_of) {
        const auto known = pictures_.find(key);
        if (known == pictures_.end()) return;
        frame.words.push_back(
            {.picture = known->second, .place = place_of(*known->second), .is_sharp = is_sharp});
    };
    add(code_key(wall_.code), true,
        [&](const WordPicture& code) { return idle_code_place(code.width, frame.canvas); });
    add(wall_.share, false, [&](const WordPicture& words) {
        return idle_words_place(static_cast<double>(words.width) / words.height, frame.canvas);
    });
}

std::string CaptionWords::text_of(Kind kind, const std::string& path, const ShowHints& hints,
                                  const RecordList& files) const {
    if (kind == Kind::wall_code) return wall_.code;
    if (kind == Kind::caption)
        return wall_.captions == CaptionChoice::none
                   ? ""
                   : caption_on_wall(path, hints, files.find(path), wall_.captions);
    const ShowHints::Entry file = hints.find(path);
    return file ? file->hints.code.value_or("") : "";
}

/// True if the shot and its words stay where they are, also while the wall changes.
bool CaptionWords::stays(const Caption& caption, const CaptionRoom& room, std::span<const DrawItem> items) {
    if (!room.next && caption.room == room) return true;
    return caption.place && keeps_place(*caption.place, room, items);
}

/// Keeps the words of the shots that stay where they are, and begins others once the wall stands.
void CaptionWords::follow(const Frame& frame, const TextOf& text_of) {
    Captions before = std::exchange(captions_, {});
    std::set<std::string> keys;
    if (!wall_.code.empty()) keys.insert(code_key(wall_.code));
    if (!wall_.share.empty()) keys.insert(wall_.share);
    for (const CaptionRoom& room : frame.captions)
        for (const Kind kind : {Kind::code, Kind::caption, Kind::wall_code}) {
            std::string text = text_of(kind, room.path);
            if (text.empty()) continue;
            if (kind == Kind::code) keys.insert(code_key(text));
            for (int lines = 1; kind == Kind::caption && lines <= caption_forms; ++lines)
                keys.insert(caption_key(text, lines));
            const auto known = before.find({kind, room.source});
            const bool is_known = known != before.end() && known->second.text == text;
            if (is_known && stays(known->second, room, frame.items))
                captions_[{kind, room.source}] = std::move(known->second);
            else if (!room.next)
                captions_[{kind, room.source}] = {.text = std::move(text)};
            else
                continue;
            captions_[{kind, room.source}].room = room;
        }
    const bool is_changing =
        std::ranges::any_of(frame.captions, [](const CaptionRoom& room) { return room.next != nullptr; });
    if (keys == wanted_ || (frame.captions.empty() && !wanted_.empty()) || is_changing)
        return;  // it keeps the pictures
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
        if (caption.place || caption.room.next || (is_walls && has_wall_code)) continue;
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
