#include "base/state/media_error.hpp"

#include <fmt/format.h>

#include <system_error>

namespace vitrine {

MediaError failed_call(const std::string& what, int error) {
    return {fault_owner(error), fmt::format("{}: {}", what, std::generic_category().message(error))};
}

}  // namespace vitrine
