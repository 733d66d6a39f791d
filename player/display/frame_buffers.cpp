#include "player/display/frame_buffers.hpp"

#include "base/system/handle.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <utility>

namespace vitrine::player {

namespace {

using ResourcesHandle = Handle<drmModeRes, &drmModeFreeResources>;

std::uint32_t announced(int fd, const BufferForm& form) {
    std::uint32_t number = 0;
    const int result =
        form.is_modifier_named
            ? drmModeAddFB2WithModifiers(fd, form.width, form.height, form.format, form.handles.data(),
                                         form.pitches.data(), form.offsets.data(), form.modifiers.data(),
                                         &number, DRM_MODE_FB_MODIFIERS)
            : drmModeAddFB2(fd, form.width, form.height, form.format, form.handles.data(),
                            form.pitches.data(), form.offsets.data(), &number, 0);
    return result == 0 ? number : 0;
}

/// A buffer's handle in another opening of the same card. 0: it cannot be passed.
std::uint32_t passed_on(int from, std::uint32_t handle, int to) {
    int shared = -1;
    if (drmPrimeHandleToFD(from, handle, DRM_CLOEXEC, &shared) != 0) return 0;
    const UniqueFd buffer(shared);
    std::uint32_t passed = 0;
    return drmPrimeFDToHandle(to, buffer.get(), &passed) == 0 ? passed : 0;
}

std::vector<std::uint32_t> numbers_of(int fd) {
    const ResourcesHandle resources(drmModeGetResources(fd));
    if (!resources || resources->count_fbs <= 0) return {};
    return {resources->fbs, resources->fbs + resources->count_fbs};
}

}  // namespace

FrameBuffers::FrameBuffers(int card, UniqueFd keeper) : card_(card), keeper_(std::move(keeper)) {
    if (keeper_.is_open()) old_ = numbers_of(keeper_.get());
}

std::uint32_t FrameBuffers::add(const BufferForm& form) {
    if (keeper_.is_open() && !is_keeper_refused_) {
        const std::uint32_t number = add_to_keeper(form);
        if (number != 0) return number;
        is_keeper_refused_ = true;
    }
    const std::uint32_t number = announced(card_, form);
    if (number != 0 && keeper_.is_open()) own_.push_back(number);
    return number;
}

/// The frame buffer's number keeps the buffer alive: the handles are not needed any more.
std::uint32_t FrameBuffers::add_to_keeper(const BufferForm& form) {
    BufferForm passed = form;
    std::vector<std::uint32_t> taken;
    for (std::size_t i = 0; i < form.handles.size() && form.handles[i] != 0; ++i) {
        passed.handles[i] = passed_on(card_, form.handles[i], keeper_.get());
        if (passed.handles[i] == 0) break;
        if (std::ranges::find(taken, passed.handles[i]) == taken.end()) taken.push_back(passed.handles[i]);
    }
    const bool is_whole =
        std::ranges::equal(form.handles, passed.handles, [](auto a, auto b) { return (a == 0) == (b == 0); });
    const std::uint32_t number = is_whole ? announced(keeper_.get(), passed) : 0;
    for (const std::uint32_t handle : taken)
        drmCloseBufferHandle(keeper_.get(), handle);
    return number;
}

void FrameBuffers::remove(std::uint32_t number) {
    const bool is_own = !keeper_.is_open() || std::erase(own_, number) > 0;
    if (is_own)
        drmModeRmFB(card_, number);
    else if (!keeps_)
        drmModeRmFB(keeper_.get(), number);
}

bool FrameBuffers::keep() {
    keeps_ = keeper_.is_open() && !is_keeper_refused_;
    return keeps_;
}

void FrameBuffers::let_go(std::span<const std::uint32_t> shown) {
    for (const std::uint32_t number : without(old_, shown)) {
        drmModeRmFB(keeper_.get(), number);
        std::erase(old_, number);
    }
}

std::vector<std::uint32_t> without(std::span<const std::uint32_t> numbers,
                                   std::span<const std::uint32_t> others) {
    std::vector<std::uint32_t> left;
    std::ranges::copy_if(numbers, std::back_inserter(left), [&](std::uint32_t number) {
        return std::ranges::find(others, number) == others.end();
    });
    return left;
}

UniqueFd keeper_of(int card, UniqueFd left) {
    struct stat ours {};

    struct stat its {};

    if (::fstat(card, &ours) < 0) return {};
    if (left.is_open() && ::fstat(left.get(), &its) == 0 && S_ISCHR(its.st_mode) &&
        its.st_rdev == ours.st_rdev)
        return left;
    UniqueFd keeper(::open(fmt::format("/proc/self/fd/{}", card).c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK));
    if (keeper.is_open() && drmIsMaster(keeper.get()) != 0) (void)drmDropMaster(keeper.get());
    return keeper;
}

}  // namespace vitrine::player
