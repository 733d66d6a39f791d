#include "base/state/stored_shot.hpp"

#include "base/state/name_hash.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace vitrine {

namespace {

constexpr std::size_t former_id_length = 16;  // of what was stored by 0.1
constexpr std::size_t max_name = 100;

bool is_hex(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
}

bool is_plain(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '-' || c == '.';
}

}  // namespace

std::string store_id(const std::string& path, std::uint64_t bytes, std::int64_t mtime_ns) {
    return name_hash(fmt::format("{} {} {}", bytes, mtime_ns, path));
}

bool is_store_name(std::string_view file) {
    if (file.size() > max_name) return false;
    const std::size_t slash = file.find('/');
    if (slash != name_hash_length && slash != former_id_length) return false;
    const std::string_view id = file.substr(0, slash);
    const std::string_view name = file.substr(slash + 1);
    return std::all_of(id.begin(), id.end(), is_hex) && std::all_of(name.begin(), name.end(), is_plain) &&
           !name.empty() && name.front() != '.' && name.find("..") == std::string_view::npos;
}

}  // namespace vitrine
