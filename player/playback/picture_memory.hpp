#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace vitrine::player {

/// Thread-safe. Memory for the pictures of one film, used again as soon as the last who holds a picture lets
/// go: a new megabyte for each would cost more than converting into it.
class PictureMemory {
  public:
    /// At least `bytes`, aligned for the processor's widest words. Outlives the pool where need be.
    std::shared_ptr<std::byte> block(std::size_t bytes);

  private:
    struct Free {
        void operator()(std::byte* bytes) const;
    };

    using Block = std::unique_ptr<std::byte, Free>;

    struct Pool {
        std::mutex mutex;
        std::size_t size = 0;      // guarded by mutex: bytes of each block
        std::vector<Block> spare;  // guarded by mutex
    };

    static void give_back(const std::shared_ptr<Pool>& pool, Block block, std::size_t size);

    std::shared_ptr<Pool> pool_ = std::make_shared<Pool>();  // shared: with the blocks that are out
};

}  // namespace vitrine::player
