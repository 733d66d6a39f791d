#include "base/settings/share_address.hpp"

#include "base/settings/settings.hpp"
#include "base/system/machine.hpp"

#include <string_view>

namespace vitrine {

std::string share_address(const Settings& settings) {
    constexpr std::string_view host = "{host}";
    std::string address = settings.show.share_address;
    for (std::size_t at = address.find(host); at != std::string::npos; at = address.find(host, at)) {
        const std::string name = host_name();
        address.replace(at, host.size(), name);
        at += name.size();
    }
    return address;
}

}  // namespace vitrine
