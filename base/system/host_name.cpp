#include "base/system/host_name.hpp"

#include <unistd.h>

#include <array>

namespace vitrine {

std::string host_name() {
    std::array<char, 256> name{};  // longer than Linux has them
    return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace vitrine
