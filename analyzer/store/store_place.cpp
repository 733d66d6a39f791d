#include "analyzer/store/store_place.hpp"

#include <system_error>

namespace vitrine::analyzer {

bool has_room(const StorePlace& place) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(place.store, error);
    return !error && space.available > place.least_free;
}

}  // namespace vitrine::analyzer
