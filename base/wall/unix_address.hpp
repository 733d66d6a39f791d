#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <filesystem>

namespace vitrine {

/// The address of a socket in the file system.
struct UnixAddress {
    /// @throws std::invalid_argument if the path is too long for one
    explicit UnixAddress(const std::filesystem::path& path);

    const sockaddr* get() const { return reinterpret_cast<const sockaddr*>(&address); }

    sockaddr_un address{};
};

}  // namespace vitrine
