#include "base/wall/unix_address.hpp"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>
#include <string>

namespace vitrine {

UnixAddress::UnixAddress(const std::filesystem::path& path) {
    const std::string& name = path.native();
    if (name.empty() || name.size() >= sizeof address.sun_path)
        throw std::invalid_argument(fmt::format("'{}' is no path of a socket: it has 1 to {} bytes", name,
                                                sizeof address.sun_path - 1));
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path, name.data(), name.size());
}

}  // namespace vitrine
