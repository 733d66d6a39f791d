#include "player/scene/files/show_files.hpp"

namespace vitrine::player {

namespace {

template <typename Item> std::vector<std::shared_ptr<const Item>> shared_copies(std::span<const Item> items) {
    std::vector<std::shared_ptr<const Item>> copies;
    copies.reserve(items.size());
    for (const Item& item : items)
        copies.push_back(std::make_shared<const Item>(item));
    return copies;
}

}  // namespace

ShowHints::ShowHints(std::initializer_list<HintedFile> files)
    : SharedList(shared_copies(std::span<const HintedFile>(files.begin(), files.size()))) {}

RecordList::RecordList(std::span<const MediaRecord> records) : SharedList(shared_copies(records)) {}

RecordList RecordList::in_folder(const std::string& folder) const {
    constexpr char after_slash = '/' + 1;
    return folder.empty() ? *this : RecordList(between(folder + '/', folder + after_slash));
}

}  // namespace vitrine::player
