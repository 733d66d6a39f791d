#pragma once

#include <memory>

namespace vitrine {

/// Calls the C function that frees the object of a Handle.
template <auto free> struct FreedBy {
    template <typename T> void operator()(T* object) const { free(object); }
};

/// The only owner of an object of a C library: Handle<drmModeConnector, &drmModeFreeConnector>.
template <typename T, auto free> using Handle = std::unique_ptr<T, FreedBy<free>>;

}  // namespace vitrine
