#include "base/state/stored_shot.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>

namespace vitrine {

namespace {

constexpr std::size_t id_length = 16;
constexpr std::size_t max_name = 100;

bool is_hex(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

bool is_plain(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '.';
}

}  // namespace

std::string store_id(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns) {
    const std::string content = fmt::format("{} {} {}", bytes, mtime_ns, path);
    return fmt::format("{:016x}", static_cast<std::uint64_t>(XXH3_64bits(content.data(), content.size())));
}

bool is_store_name(std::string_view file) {
    if (file.size() < id_length + 2 || file.size() > max_name || file[id_length] != '/') return false;
    const std::string_view id = file.substr(0, id_length);
    const std::string_view name = file.substr(id_length + 1);
    return std::all_of(id.begin(), id.end(), is_hex) && std::all_of(name.begin(), name.end(), is_plain) &&
           name.front() != '.' && name.find("..") == std::string_view::npos;
}

}  // namespace vitrine
