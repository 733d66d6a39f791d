#include "link/wall_key.hpp"

#include "base/system/atomic_file.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

namespace vitrine::link {

namespace {

constexpr std::size_t key_digits = 64;       // 256 bits
constexpr std::size_t max_file_bytes = 256;  // a key with some blanks
constexpr std::string_view digits = "0123456789abcdefABCDEF";

}  // namespace

std::string read_wall_key(const std::filesystem::path& file) {
    std::string text;
    try {
        text = read_file(file, max_file_bytes);
    } catch (const std::exception& error) {
        throw std::runtime_error(fmt::format("the key of the wall cannot be read: {}", error.what()));
    }
    text.erase(text.find_last_not_of(" \r\n\t") + 1);
    if (text.size() != key_digits || text.find_first_not_of(digits) != std::string::npos)
        throw std::runtime_error(
            fmt::format("'{}' is no key of a wall: a key is one line of {} hexadecimal digits", file.native(),
                        key_digits));
    return text;
}

}  // namespace vitrine::link
