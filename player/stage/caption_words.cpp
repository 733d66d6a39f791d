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
    if (choice_ == CaptionChoice::none) return;
    follow(frame,
           [&](const std::string& path) { return caption_on_wall(path, hints, files.find(path), choice_); });
    take_pictures(frame.canvas);
    for (auto& [source, caption] : captions_) {
        if (!caption.place) continue;
        if (!caption.since) caption.since = frame.time;
        const double age = std::chrono::duration<double>(frame.time - *caption.since) / fade;
        frame.words.push_back(
            {.picture = caption.picture, .place = *caption.place, .alpha = std::clamp(age, 0.0, 1.0)});
    }
}

/// Keeps the captions of the shots that stay where they are, and begins others once the wall stands.
void CaptionWords::follow(const Frame& frame, const TextOf& text_of) {
    std::map<SourceId, Caption> before = std::exchange(captions_, {});
    std::set<std::string> keys;
    for (const CaptionRoom& room : frame.captions) {
        std::string text = text_of(room.path);
        if (text.empty()) continue;
        for (int lines = 1; lines <= caption_forms; ++lines)
            keys.insert(caption_key(text, lines));
        const auto known = before.find(room.source);
        const bool is_known = known != before.end() && known->second.text == text;
        if (is_known && ((!room.next && known->second.room == room) ||
                         (known->second.place && keeps_place(*known->second.place, room, frame.items))))
            captions_[room.source] = std::move(known->second);
        else if (!room.next)
            captions_[room.source] = {.text = text};
        else
            continue;
        captions_[room.source].room = room;
    }
    const bool is_changing =
        std::ranges::any_of(frame.captions, [](const CaptionRoom& room) { return room.next != nullptr; });
    if (keys == wanted_ || frame.captions.empty() || is_changing) return;  // it keeps the pictures
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
    for (auto& [source, caption] : captions_)
        if (!caption.place && !caption.room.next) find_place(caption, canvas);
}

/// Looks for a place when further forms have been read.
void CaptionWords::find_place(Caption& caption, Vec2 canvas) const {
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
    const auto place = caption_place(caption.room, sizes, canvas);
    if (!place) return;
    caption.place = place->box;
    caption.picture = pictures[place->form];
}

}  // namespace vitrine::player
