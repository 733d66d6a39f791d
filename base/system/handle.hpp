#pragma once

#include <memory>

namespace vitrine {

/// Calls the C function that frees what a Handle owns.
template <auto free> struct FreedBy {
    template <typename T> void operator()(T* object) const { free(object); }
};

/// The one owner of an object of a C library: Handle<drmModeConnector, &drmModeFreeConnector>.
template <typename T, auto free> using Handle = std::unique_ptr<T, FreedBy<free>>;

}  // namespace vitrine
