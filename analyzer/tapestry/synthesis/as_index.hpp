#pragma once

#include <cstddef>

namespace vitrine::analyzer {

/// Converts a number that is never negative to the type of a container's index.
constexpr std::size_t as_index(int number) {
    return static_cast<std::size_t>(number);
}

}  // namespace vitrine::analyzer
