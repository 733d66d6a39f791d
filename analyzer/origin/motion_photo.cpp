#include "analyzer/origin/motion_photo.hpp"

#include "base/media/file_bytes.hpp"
#include "base/system/log.hpp"

#include <exiv2/exiv2.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <exception>
#include <functional>
#include <map>
#include <span>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr std::uint64_t max_head = 256U << 10U;  // bytes in which XMP is looked for
constexpr std::string_view samsung_end = "SEFT";
constexpr int max_parts = 1000;  // boxes of a film, items of XMP, entries of Samsung's list

std::string text_of(const FileBytes& file, std::uint64_t at, std::uint64_t bytes) {
    std::string text(bytes, '\0');
    text.resize(file.read(at, std::as_writable_bytes(std::span(text))));
    return text;
}

std::string end_of(const FileBytes& file, std::uint64_t bytes) {
    return file.size() < bytes ? std::string() : text_of(file, file.size() - bytes, bytes);
}

/// The film that begins there: whole boxes of an MP4, up to the first thing that is none.
std::optional<FilePart> film_at(const FileBytes& file, std::uint64_t begin) {
    constexpr std::array<std::string_view, 10> boxes{"ftyp", "moov", "mdat", "free", "skip",
                                                     "wide", "uuid", "moof", "mfra", "udta"};
    std::uint64_t at = begin;
    bool has_movie = false;
    for (int i = 0; i < max_parts && at < file.size(); ++i) {
        const std::string head = text_of(file, at, 16);
        if (head.size() < 8) break;
        const std::string_view name = std::string_view(head).substr(4, 4);
        if (std::ranges::find(boxes, name) == boxes.end() || (at == begin) != (name == "ftyp")) break;
        std::uint64_t size = big_endian(head, 0, 4);
        if (size == 1 && head.size() == 16) size = big_endian(head, 8, 8);
        if (size == 0) size = file.size() - at;
        if (size < 8 || size > file.size() - at) break;
        has_movie = has_movie || name == "moov";
        at += size;
    }
    return has_movie ? std::optional(FilePart{.at = begin, .bytes = at - begin}) : std::nullopt;
}

std::optional<FilePart> film_before_end(const FileBytes& file, std::uint64_t distance) {
    return distance == 0 || distance >= file.size() ? std::nullopt : film_at(file, file.size() - distance);
}

/// A property of XMP.
struct XmpEntry {
    std::string key;   // "Xmp.Container.Directory[2]/Container:Item/Item:Length"
    std::string name;  // its last part: "Length"
    std::string value;
};

std::vector<XmpEntry> xmp_entries(const std::string& path) {
    std::vector<XmpEntry> entries;
    try {
        Exiv2::LogMsg::setLevel(Exiv2::LogMsg::mute);
        const auto image = Exiv2::ImageFactory::open(path);
        image->readMetadata();
        for (const Exiv2::Xmpdatum& datum : image->xmpData()) {
            if (entries.size() >= max_parts) break;
            const std::string key = datum.key();
            entries.push_back({key, key.substr(key.find_last_of(".:/") + 1), datum.toString()});
        }
    } catch (const std::exception& error) {  // whoever decodes the file says so
        log::debug("no XMP in a photo: {}", error.what());
    }
    return entries;
}

std::uint64_t number(const std::string& text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr std::uint64_t max_value = std::uint64_t{1} << 40U;
    return error == std::errc() && end == text.data() + text.size() && value < max_value ? value : 0;
}

/// An item of Google's list of what a file holds, in the order in which they lie there.
struct HeldItem {
    bool is_film = false;
    std::uint64_t length = 0;
    std::uint64_t padding = 0;
};

/// The list's items by their number.
std::map<std::uint64_t, HeldItem> held_items(const std::vector<XmpEntry>& entries) {
    constexpr std::string_view list = "Directory[";
    std::map<std::uint64_t, HeldItem> items;
    for (const auto& [key, name, value] : entries) {
        const std::size_t found = key.find(list);
        if (found == std::string::npos) continue;
        const std::size_t begin = found + list.size();
        HeldItem& item = items[number(key.substr(begin, key.find(']', begin) - begin))];
        if (name == "Semantic") item.is_film = value == "MotionPhoto";
        if (name == "Length") item.length = number(value);
        if (name == "Padding") item.padding = number(value);
    }
    return items;
}

/// Bytes from the film's begin to the file's end, as its XMP says.
std::vector<std::uint64_t> distances_in(const std::vector<XmpEntry>& entries, bool& is_promised) {
    std::vector<std::uint64_t> distances;
    for (const XmpEntry& entry : entries) {
        if ((entry.name == "MicroVideo" || entry.name == "MotionPhoto") && entry.value == "1")
            is_promised = true;
        if (entry.name == "MicroVideoOffset") distances.push_back(number(entry.value));
    }
    const std::map<std::uint64_t, HeldItem> items = held_items(entries);
    std::uint64_t behind = 0;
    for (auto item = items.rbegin(); item != items.rend(); ++item) {
        behind += item->second.length + item->second.padding;
        if (item->second.is_film) distances.insert(distances.end(), {item->second.length, behind});
    }
    return distances;
}

/// Samsung's list at the end of a file names parts before it; each part repeats its name.
std::optional<FilePart> samsung_film(const FileBytes& file) {
    constexpr std::string_view name = "MotionPhoto_Data";
    constexpr std::uint64_t entry_bytes = 12;
    const std::string tail = end_of(file, 8);
    if (!tail.ends_with(samsung_end)) return std::nullopt;
    const std::uint64_t bytes = little_endian(tail, 0, 4);
    if (bytes < entry_bytes || bytes > entry_bytes * (max_parts + 1) || bytes + 8 > file.size())
        return std::nullopt;
    const std::uint64_t list_at = file.size() - 8 - bytes;
    const std::string list = text_of(file, list_at, bytes);
    if (!list.starts_with("SEFH")) return std::nullopt;
    for (std::uint64_t at = entry_bytes; at + entry_bytes <= list.size(); at += entry_bytes) {
        const std::uint64_t before = little_endian(list, at + 4, 4);
        if (before > list_at) continue;
        const std::string head = text_of(file, list_at - before, 8 + name.size());
        if (head.size() == 8 + name.size() && head.ends_with(name))
            return film_at(file, list_at - before + head.size());
    }
    return std::nullopt;
}

}  // namespace

bool may_hold_film(const std::string& path) {
    const FileBytes file(path);
    if (end_of(file, samsung_end.size()) == samsung_end) return true;
    const std::string head = text_of(file, 0, std::min(max_head, file.size()));
    const auto has = [&](std::string_view word) {
        return std::search(head.begin(), head.end(),
                           std::boyer_moore_horspool_searcher(word.begin(), word.end())) != head.end();
    };
    return has("MotionPhoto") || has("MicroVideo");
}

InnerFilmPlace inner_film_place(const std::string& path) {
    const FileBytes file(path);
    InnerFilmPlace place;
    for (const std::uint64_t distance : distances_in(xmp_entries(path), place.is_promised))
        if (!place.film) place.film = film_before_end(file, distance);
    if (!place.film) place.film = samsung_film(file);
    place.is_promised = place.is_promised || place.film;
    return place;
}

}  // namespace vitrine::analyzer
