#include "analyzer/status/plain_text.hpp"

#include <fmt/format.h>

#include <cstdint>

namespace vitrine::analyzer {

namespace {

constexpr std::string_view replacement = "\xef\xbf\xbd";

/// The meaning of the first byte of a character.
struct FirstByte {
    std::size_t length = 0;  // bytes of the character; 0: none begins so
    std::uint32_t bits = 0;
    std::uint32_t min_code = 0;  // the first one that needs so many bytes
};

FirstByte first_byte(unsigned char byte) {
    if (byte < 0x80) return {1, byte, 0};
    if ((byte & 0xE0) == 0xC0) return {2, byte & 0x1FU, 0x80};
    if ((byte & 0xF0) == 0xE0) return {3, byte & 0x0FU, 0x800};
    if ((byte & 0xF8) == 0xF0) return {4, byte & 0x07U, 0x10000};
    return {};
}

/// @return the length of the first character; 0 where the bytes begin with none
std::size_t character_length(std::string_view bytes) {
    const FirstByte lead = first_byte(static_cast<unsigned char>(bytes.front()));
    if (lead.length == 0 || lead.length > bytes.size()) return 0;
    std::uint32_t code = lead.bits;
    for (std::size_t i = 1; i < lead.length; ++i) {
        const auto byte = static_cast<unsigned char>(bytes[i]);
        if ((byte & 0xC0) != 0x80) return 0;
        code = code << 6 | (byte & 0x3FU);
    }
    const bool is_surrogate = code >= 0xD800 && code <= 0xDFFF;
    return code < lead.min_code || code > 0x10FFFF || is_surrogate ? 0 : lead.length;
}

bool is_control(std::string_view one) {
    const auto first = static_cast<unsigned char>(one.front());
    if (one.size() == 1) return first < 0x20 || first == 0x7f;
    const auto second = static_cast<unsigned char>(one[1]);
    return one.size() == 2 && first == 0xC2 && second < 0xA0;
}

/// Marks that turn the direction of the text behind them, so that a name could pose as another.
bool is_direction(std::string_view one) {
    if (one.size() != 3 || one[0] != '\xe2') return false;
    const auto second = static_cast<unsigned char>(one[1]);
    const auto third = static_cast<unsigned char>(one[2]);
    return (second == 0x80 && (third >= 0xA8 && third <= 0xAE)) ||
           (second == 0x81 && third >= 0xA6 && third <= 0xA9);
}

}  // namespace

std::string plain_text(std::string_view bytes) {
    std::string text;
    while (!bytes.empty()) {
        const std::size_t length = character_length(bytes);
        const std::string_view one = bytes.substr(0, length == 0 ? 1 : length);
        if (length == 0 || is_direction(one))
            text += replacement;
        else if (is_control(one))
            text += fmt::format("\\x{:02x}", static_cast<unsigned char>(one.back()));
        else
            text += one;
        bytes.remove_prefix(one.size());
    }
    return text;
}

std::string html_text(std::string_view bytes) {
    std::string html;
    for (const char c : plain_text(bytes)) {
        switch (c) {
        case '&':
            html += "&amp;";
            break;
        case '<':
            html += "&lt;";
            break;
        case '>':
            html += "&gt;";
            break;
        case '"':
            html += "&quot;";
            break;
        case '\'':
            html += "&#39;";
            break;
        default:
            html += c;
        }
    }
    return html;
}

}  // namespace vitrine::analyzer
