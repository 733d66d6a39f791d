#pragma once

#include <fmt/format.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace vitrine {

/// Throws std::system_error for errno. The text names the action and its object: throw_errno("open '{}'",
/// path).
template <typename... Args> [[noreturn]] void throw_errno(fmt::format_string<Args...> what, Args&&... args) {
    const int code = errno;  // before formatting, which may change it
    throw std::system_error(code, std::generic_category(), fmt::format(what, std::forward<Args>(args)...));
}

}  // namespace vitrine
