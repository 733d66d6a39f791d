#include "analyzer/origin/film_facts.hpp"

#include "analyzer/origin/time_words.hpp"
#include "base/media/file_bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

namespace {

constexpr int max_boxes = 10'000;           // looked at in one file
constexpr std::uint64_t max_value = 4'096;  // bytes of a text
constexpr std::uint64_t max_keys = 1'000;

/// The content of a box.
struct FileBox {
    std::uint64_t begin = 0;
    std::uint64_t end = 0;
};

/// Finds boxes in a file.
class FileBoxes {
  public:
    explicit FileBoxes(const std::string& path) : file_(path) {}

    FileBox whole() const { return {.begin = 0, .end = file_.size()}; }

    std::uint64_t number(std::uint64_t at, std::size_t count) const {
        const std::string bytes = text({.begin = at, .end = at + count});
        return big_endian(bytes, 0, bytes.size());
    }

    std::string text(const FileBox& box) const {
        std::string bytes(std::min(max_value, box.end - std::min(box.begin, box.end)), '\0');
        bytes.resize(file_.read(box.begin, std::as_writable_bytes(std::span(bytes))));
        return bytes;
    }

    /// Calls use(name, content) for each box in another one, until it returns true.
    void for_each(const FileBox& in,
                  const std::function<bool(std::string_view name, const FileBox& box)>& use) {
        for (std::uint64_t at = in.begin; at + 8 <= in.end && ++seen_ < max_boxes;) {
            std::uint64_t head = 8;
            std::uint64_t size = number(at, 4);
            if (size == 1) {
                size = number(at + 8, 8);
                head = 16;
            }
            if (size == 0) size = in.end - at;
            if (size < head || size > in.end - at) return;
            if (use(text({.begin = at + 4, .end = at + 8}), {.begin = at + head, .end = at + size})) return;
            at += size;
        }
    }

    /// An empty box: there is none of that name.
    FileBox find(const FileBox& in, std::string_view wanted) {
        FileBox found;
        for_each(in, [&](std::string_view name, const FileBox& box) {
            if (name == wanted) found = box;
            return name == wanted;
        });
        return found;
    }

  private:
    FileBytes file_;
    int seen_ = 0;
};

/// The time of the film's header: seconds since 1904, UTC.
std::optional<TimeTaken> header_time(const FileBoxes& boxes, const FileBox& header) {
    using std::chrono::seconds;
    constexpr std::chrono::sys_days epoch = std::chrono::year(1904) / 1 / 1;
    constexpr std::uint64_t max_seconds = std::uint64_t{1} << 34U;
    if (header.end < header.begin + 12) return std::nullopt;
    const bool is_long = boxes.number(header.begin, 1) == 1;
    const std::uint64_t time = boxes.number(header.begin + 4, is_long ? 8 : 4);
    if (time == 0 || time > max_seconds) return std::nullopt;
    const std::chrono::sys_seconds at = epoch + seconds(time);
    return TimeTaken{.at = at, .zone = zone_here(at), .source = TimeSource::camera};
}

/// The names of QuickTime's entries, in the order of their numbers, which begin with 1.
std::vector<std::string> entry_names(const FileBoxes& boxes, const FileBox& keys) {
    std::vector<std::string> names;
    if (keys.end < keys.begin + 8) return names;
    const std::uint64_t count = std::min(max_keys, boxes.number(keys.begin + 4, 4));
    for (std::uint64_t at = keys.begin + 8; names.size() < count && at + 8 <= keys.end;) {
        const std::uint64_t size = boxes.number(at, 4);
        if (size < 8 || size > keys.end - at) break;
        names.push_back(boxes.text({.begin = at + 8, .end = at + size}));
        at += size;
    }
    return names;
}

void take_entry(const std::string& name, const std::string& value, MediaOrigin& origin) {
    if (name == "com.apple.quicktime.content.identifier" && is_content_id(value)) origin.content_id = value;
    if (name != "com.apple.quicktime.creationdate") return;
    const auto civil = civil_time_named(value);
    const auto zone = value.size() > 19 ? zone_named(std::string_view(value).substr(19)) : std::nullopt;
    if (!civil || !zone) return;
    origin.taken = TimeTaken{.at = std::chrono::sys_seconds(civil->time_since_epoch() - *zone),
                             .zone = *zone,
                             .source = TimeSource::camera};
}

/// QuickTime's own entries: names in one box, values in another.
void take_entries(FileBoxes& boxes, FileBox meta, MediaOrigin& origin) {
    if (boxes.find(meta, "keys").end == 0) meta.begin += 4;  // MP4 has a version there
    const std::vector<std::string> names = entry_names(boxes, boxes.find(meta, "keys"));
    boxes.for_each(boxes.find(meta, "ilst"), [&](std::string_view key, const FileBox& entry) {
        const std::uint64_t number = big_endian(key, 0, key.size());
        const FileBox data = boxes.find(entry, "data");
        if (number >= 1 && number <= names.size() && data.end > data.begin + 8)
            take_entry(names[number - 1], boxes.text({.begin = data.begin + 8, .end = data.end}), origin);
        return false;
    });
}

}  // namespace

MediaOrigin film_facts(const std::string& path) {
    FileBoxes boxes(path);
    MediaOrigin origin;
    const FileBox movie = boxes.find(boxes.whole(), "moov");
    if (movie.end == 0) return origin;
    origin.taken = header_time(boxes, boxes.find(movie, "mvhd"));
    if (const FileBox meta = boxes.find(movie, "meta"); meta.end > 0) take_entries(boxes, meta, origin);
    return origin;
}

}  // namespace vitrine::analyzer
