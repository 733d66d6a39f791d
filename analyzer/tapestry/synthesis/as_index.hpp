#pragma once

#include <cstddef>

namespace vitrine::analyzer {

/// A number that is never negative, as containers count.
constexpr std::size_t as_index(int number) {
    return static_cast<std::size_t>(number);
}

}  // namespace vitrine::analyzer
