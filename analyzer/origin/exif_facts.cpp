#include "analyzer/origin/exif_facts.hpp"

#include "analyzer/origin/time_words.hpp"
#include "base/media/file_bytes.hpp"
#include "base/system/handle.hpp"

#include <libexif/exif-data.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace vitrine::analyzer {

namespace {

using namespace std::chrono_literals;
using Data = Handle<ExifData, &exif_data_unref>;

constexpr auto gps_date = static_cast<ExifTag>(0x001d);
constexpr auto gps_time = static_cast<ExifTag>(0x0007);

Data parsed(std::span<const std::byte> exif) {
    constexpr std::string_view mark("Exif\0\0", 6);
    std::vector<unsigned char> bytes(mark.begin(), mark.end());
    for (const std::byte byte : exif)
        bytes.push_back(std::to_integer<unsigned char>(byte));
    Data data(exif_data_new());
    if (!data || bytes.size() > std::numeric_limits<unsigned>::max()) return data;
    exif_data_unset_option(data.get(), EXIF_DATA_OPTION_FOLLOW_SPECIFICATION);
    exif_data_load_data(data.get(), bytes.data(), static_cast<unsigned>(bytes.size()));
    return data;
}

/// The bytes of an entry; empty: there is none.
std::string_view entry_bytes(const Data& data, ExifIfd directory, ExifTag tag) {
    const ExifEntry* entry = exif_content_get_entry(data->ifd[directory], tag);
    if (entry == nullptr || entry->data == nullptr) return {};
    return {reinterpret_cast<const char*>(entry->data), entry->size};
}

/// A text up to its first zero.
std::string_view entry_text(const Data& data, ExifIfd directory, ExifTag tag) {
    const std::string_view bytes = entry_bytes(data, directory, tag);
    return bytes.substr(0, bytes.find('\0'));
}

/// The tags of one of the times in a photo.
struct TimeTags {
    ExifIfd directory;
    ExifTag time, fraction, zone;
};

constexpr std::array<TimeTags, 3> time_tags{
    {{EXIF_IFD_EXIF, EXIF_TAG_DATE_TIME_ORIGINAL, EXIF_TAG_SUB_SEC_TIME_ORIGINAL,
      EXIF_TAG_OFFSET_TIME_ORIGINAL},
     {EXIF_IFD_EXIF, EXIF_TAG_DATE_TIME_DIGITIZED, EXIF_TAG_SUB_SEC_TIME_DIGITIZED,
      EXIF_TAG_OFFSET_TIME_DIGITIZED},
     {EXIF_IFD_0, EXIF_TAG_DATE_TIME, EXIF_TAG_SUB_SEC_TIME, EXIF_TAG_OFFSET_TIME}}};

/// The digits behind the decimal point.
std::chrono::milliseconds fraction_named(std::string_view text) {
    int milliseconds = 0;
    int unit = 100;
    for (const char c : text) {
        if (c < '0' || c > '9') break;
        milliseconds += (c - '0') * unit;
        unit /= 10;
    }
    return std::chrono::milliseconds(milliseconds);
}

/// The time of the satellites, which is UTC.
std::optional<std::chrono::local_seconds> satellite_time(const Data& data) {
    const std::string_view date = entry_text(data, EXIF_IFD_GPS, gps_date);
    const std::string_view time = entry_bytes(data, EXIF_IFD_GPS, gps_time);
    constexpr std::size_t rational = 8;
    const auto day = day_named(date);
    if (!day || time.size() < 3 * rational) return std::nullopt;
    std::int64_t seconds = 0;
    std::int64_t unit = 3600;
    for (std::size_t i = 0; i < 3; ++i, unit /= 60) {
        const ExifRational part =
            exif_get_rational(reinterpret_cast<const unsigned char*>(time.data() + i * rational),
                              exif_data_get_byte_order(data.get()));
        if (part.denominator == 0) return std::nullopt;
        seconds += unit * part.numerator / part.denominator;
    }
    return std::chrono::local_seconds(*day) + std::chrono::seconds(seconds);
}

/// The zone in which a civil time is about that of the satellites: whole quarters of an hour.
std::optional<std::chrono::minutes> zone_between(std::chrono::local_seconds civil,
                                                 std::optional<std::chrono::local_seconds> utc) {
    constexpr std::chrono::minutes step{15};
    constexpr std::chrono::minutes max_zone{14 * 60};
    constexpr std::chrono::seconds max_age{120};  // of the satellites' last time
    if (!utc) return std::nullopt;
    const std::chrono::seconds between = civil - *utc;
    const double steps = std::chrono::duration<double>(between) / std::chrono::duration<double>(step);
    const std::chrono::minutes zone = step * std::lround(steps);
    if (std::chrono::abs(zone) > max_zone || std::chrono::abs(between - zone) > max_age) return std::nullopt;
    return zone;
}

std::optional<TimeTaken> time_taken(const Data& data, const TimeTags& tags) {
    const auto civil = civil_time_named(entry_text(data, tags.directory, tags.time));
    if (!civil) return std::nullopt;
    const auto exact = *civil + fraction_named(entry_text(data, EXIF_IFD_EXIF, tags.fraction));
    auto zone = zone_named(entry_text(data, EXIF_IFD_EXIF, tags.zone));
    if (!zone) zone = zone_between(*civil, satellite_time(data));
    if (!zone) return taken_here(exact);
    return TimeTaken{.at = std::chrono::sys_time<std::chrono::milliseconds>(exact.time_since_epoch() - *zone),
                     .zone = *zone,
                     .source = TimeSource::camera};
}

/// The identifier in the notes of Apple's cameras: their entry 17.
std::string content_id(std::string_view note) {
    constexpr std::string_view maker("Apple iOS\0", 10);
    constexpr std::size_t first_entry = 16;
    constexpr std::size_t entry_size = 12;
    constexpr std::uint64_t identifier = 17;
    if (!note.starts_with(maker)) return {};
    const auto number = [&](std::size_t at, std::size_t count) {
        const std::string_view bytes = note.substr(std::min(at, note.size()), count);
        return big_endian(bytes, 0, bytes.size());
    };
    for (std::size_t i = 0, at = first_entry;
         i < number(first_entry - 2, 2) && at + entry_size <= note.size(); ++i, at += entry_size) {
        if (number(at, 2) != identifier) continue;
        const std::size_t length = number(at + 4, 4), place = number(at + 8, 4);
        if (place >= note.size()) return {};
        std::string text(note.substr(place, length));
        text.resize(std::min(text.size(), text.find('\0')));
        return is_content_id(text) ? text : std::string();
    }
    return {};
}

}  // namespace

MediaOrigin exif_facts(std::span<const std::byte> exif) {
    MediaOrigin origin;
    if (exif.empty()) return origin;
    const Data data = parsed(exif);
    if (!data) return origin;
    for (const TimeTags& tags : time_tags)
        if (!origin.taken) origin.taken = time_taken(data, tags);
    origin.content_id = content_id(entry_bytes(data, EXIF_IFD_EXIF, EXIF_TAG_MAKER_NOTE));
    return origin;
}

}  // namespace vitrine::analyzer
