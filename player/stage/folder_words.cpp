#include "player/stage/folder_words.hpp"

#include <algorithm>

namespace vitrine::player {

Box word_place(const Box& box, const WordPicture& picture) {
    const Vec2 size{static_cast<double>(picture.width), static_cast<double>(picture.height)};
    const Vec2 half = size * (std::min(box.width() / size.x, box.height() / size.y) / 2);
    return {box.centre() - half, box.centre() + half};
}

void FolderWords::draw(Frame& frame, const ShowHints& hints, const RecordList& files) {
    draw_names(frame);
    captions_.draw(frame, hints, files);
}

void FolderWords::draw_names(Frame& frame) {
    if (frame.names.empty()) return;
    std::set<std::string> texts;
    for (const FrameName& name : frame.names)
        texts.insert(name.text);
    if (!loader_) loader_.emplace(state_);
    if (texts != wanted_) {
        std::erase_if(pictures_, [&](const auto& known) { return !texts.contains(known.first); });
        wanted_ = texts;
        loader_->want(std::move(texts));
    }
    for (LoadedWord& word : loader_->take())
        if (wanted_.contains(word.text)) pictures_[word.text] = std::move(word.picture);
    for (const FrameName& name : frame.names) {
        const auto known = pictures_.find(name.text);
        if (known == pictures_.end() || !known->second || known->second->height <= 0) continue;
        frame.words.push_back(
            {.picture = known->second, .place = word_place(name.box, *known->second), .alpha = name.alpha});
    }
}

}  // namespace vitrine::player
