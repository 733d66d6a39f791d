#pragma once

#include <mutex>
#include <optional>
#include <utility>

namespace vitrine {

/// Thread-safe. Holds the newest value that one thread hands to another; an older one is dropped.
template <typename T> class Mailbox {
  public:
    void put(T value) {
        const std::lock_guard lock(mutex_);
        value_ = std::move(value);
    }

    std::optional<T> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(value_, std::nullopt);
    }

  private:
    std::mutex mutex_;
    std::optional<T> value_;  // guarded by mutex_
};

}  // namespace vitrine
