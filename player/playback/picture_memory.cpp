#include "player/playback/picture_memory.hpp"

#include <new>
#include <utility>

namespace vitrine::player {

namespace {

constexpr std::align_val_t alignment{64};

}  // namespace

void PictureMemory::Free::operator()(std::byte* bytes) const {
    ::operator delete(bytes, alignment);
}

std::shared_ptr<std::byte> PictureMemory::block(std::size_t bytes) {
    Block block;
    {
        const std::lock_guard lock(pool_->mutex);
        if (pool_->size != bytes) pool_->spare.clear();
        pool_->size = bytes;
        if (!pool_->spare.empty()) {
            block = std::move(pool_->spare.back());
            pool_->spare.pop_back();
        }
    }
    if (!block) block.reset(static_cast<std::byte*>(::operator new(bytes, alignment)));
    return {block.release(), [pool = pool_, bytes](std::byte* used) { give_back(pool, Block(used), bytes); }};
}

void PictureMemory::give_back(const std::shared_ptr<Pool>& pool, Block block, std::size_t size) {
    const std::lock_guard lock(pool->mutex);
    if (pool->size == size) pool->spare.push_back(std::move(block));
}

}  // namespace vitrine::player
