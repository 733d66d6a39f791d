#include "base/hints/caption.hpp"

#include "base/state/path_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace vitrine {

namespace {

// The names of formats that operators may bring; what a file is, its content says.
constexpr std::array<std::string_view, 31> media_endings{
    ".jpg",  ".jpeg", ".png", ".webp", ".heic", ".heif", ".avif", ".gif", ".tif", ".tiff", ".bmp",
    ".mp4",  ".m4v",  ".mov", ".qt",   ".mkv",  ".webm", ".avi",  ".ts",  ".mts", ".m2ts", ".mpg",
    ".mpeg", ".m2v",  ".vob", ".3gp",  ".ogv",  ".apng", ".jfif", ".jpe", ".wmv"};

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// True for a medium's whole name with this ending.
bool is_beside_medium(std::string_view name, std::string_view sidecar_ending) {
    const std::string lower = lower_case(name);
    if (!lower.ends_with(sidecar_ending)) return false;
    const std::string_view medium = std::string_view(lower).substr(0, lower.size() - sidecar_ending.size());
    return std::ranges::any_of(media_endings, [&](std::string_view ending) {
        return medium.size() > ending.size() && medium.ends_with(ending);
    });
}

CaptionText text_within(std::string_view bytes, std::size_t max_bytes) {
    if (bytes.starts_with(byte_order_mark)) bytes.remove_prefix(byte_order_mark.size());
    const auto is_space = [](char c) { return static_cast<unsigned char>(c) <= ' ' || c == '\x7f'; };
    while (!bytes.empty() && is_space(bytes.front()))
        bytes.remove_prefix(1);
    while (!bytes.empty() && is_space(bytes.back()))
        bytes.remove_suffix(1);
    if (bytes.size() > max_bytes)
        return {.text = {}, .fault = fmt::format("it is longer than {} bytes", max_bytes)};
    if (!is_utf8(bytes)) return {.text = {}, .fault = "it is not UTF-8"};
    CaptionText read{.text = std::string(bytes), .fault = {}};
    std::ranges::replace_if(read.text, is_space, ' ');
    return read;
}

}  // namespace

bool is_caption_file(std::string_view name) {
    return is_beside_medium(name, caption_file_ending);
}

bool is_code_file(std::string_view name) {
    return is_beside_medium(name, code_file_ending);
}

CaptionText caption_text(std::string_view bytes) {
    return text_within(bytes, max_caption_bytes);
}

CaptionText code_text(std::string_view bytes) {
    CaptionText read = text_within(bytes, max_code_bytes);
    if (read.text.empty() && read.fault.empty()) read.fault = "it is empty";
    return read;
}

}  // namespace vitrine
