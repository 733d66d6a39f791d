#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

namespace vitrine::player {

/// Thread-safe. Memory for the pictures of one film. A block is used again as soon as nobody holds its
/// picture: to allocate a new megabyte for each picture would cost more than the conversion into it.
class PictureMemory {
  public:
    /// A block of at least `bytes`, aligned for the processor's widest words. It may outlive this.
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

    std::shared_ptr<Pool> pool_ = std::make_shared<Pool>();  // shared with the blocks in use
};

}  // namespace vitrine::player
