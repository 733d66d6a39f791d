#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vitrine::analyzer {

inline std::string big_bytes(std::uint64_t value, int count) {
    std::string bytes;
    for (int i = count - 1; i >= 0; --i)
        bytes += static_cast<char>(value >> (8 * i));
    return bytes;
}

/// A box of MP4.
inline std::string box(const std::string& name, const std::string& content) {
    return big_bytes(content.size() + 8, 4) + name + content;
}

/// A film's header. @param seconds  since 1904
inline std::string movie_header(std::uint64_t seconds) {
    return box("mvhd", big_bytes(0, 4) + big_bytes(seconds, 4) + std::string(92, '\0'));
}

/// QuickTime's own entries, by their names.
inline std::string entries(const std::vector<std::pair<std::string, std::string>>& values) {
    std::string keys = big_bytes(0, 4) + big_bytes(values.size(), 4);
    std::string list;
    for (std::size_t i = 0; i < values.size(); ++i) {
        keys += box("mdta", values[i].first);
        list += box(big_bytes(i + 1, 4), box("data", big_bytes(1, 4) + big_bytes(0, 4) + values[i].second));
    }
    return box("meta", box("hdlr", std::string(24, '\0')) + box("keys", keys) + box("ilst", list));
}

/// A film without pictures.
inline std::string movie(const std::string& content) {
    return box("ftyp", "qt  " + std::string(4, '\0') + "qt  ") + box("mdat", "12345678") +
           box("moov", content);
}

}  // namespace vitrine::analyzer
