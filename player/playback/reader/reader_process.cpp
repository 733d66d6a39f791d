#include "player/playback/reader/reader_process.hpp"

#include "base/state/media_error.hpp"
#include "base/system/hold_below.hpp"
#include "base/system/sandbox.hpp"
#include "base/system/unique_fd.hpp"
#include "player/playback/photo_load.hpp"
#include "player/playback/reader/film_reader.hpp"
#include "player/playback/reader/picture_slots.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

namespace vitrine::player {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool is_memory_limited = false;  // sanitizers reserve terabytes
#else
constexpr bool is_memory_limited = true;
#endif

constexpr rlim_t film_memory = rlim_t{1} << 30U;   // bytes: 8K needs about 800 MB
constexpr rlim_t photo_memory = rlim_t{2} << 30U;  // bytes, as for the analyzer's readers
constexpr int niceness = 2;                        // the player's own threads go first
constexpr std::string_view killed_first = "500";   // of 1000: if memory runs out, a reader ends and no other

void set_limit(__rlimit_resource resource, rlim_t value) {
    const rlimit both{value, value};
    ::setrlimit(resource, &both);  // a stricter limit of ours stays
}

/// Limits this process. A limit that the kernel refuses is left out.
void limit_process(MediaKind kind) {
    ::prctl(PR_SET_NAME, "vitrine-reader", 0, 0, 0);
    set_limit(RLIMIT_CORE, 0);
    if (is_memory_limited) set_limit(RLIMIT_DATA, kind == MediaKind::photo ? photo_memory : film_memory);
    if (::setpriority(PRIO_PROCESS, 0, niceness) < 0) errno = 0;
    const UniqueFd score(::open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC));
    if (score.is_open() && ::write(score.get(), killed_first.data(), killed_first.size()) < 0) errno = 0;
}

UniqueFd held_upload(const std::string& root, const std::string& path) {
    try {
        return hold_below(root, path);
    } catch (const std::system_error& error) {
        const int code = error.code().value();
        if (code == ELOOP || code == EXDEV)
            throw MediaError(MediaState::unsupported, "this is a link; links are not followed");
        throw failed_call("the file cannot be opened", code);
    }
}

/// Opens a file of the media folder to read it. Follows no link below the folder. May take long on a share.
/// @param path  below the folder
/// @throws MediaError if it cannot be opened, or is not a regular file
UniqueFd open_upload(const std::string& root, const std::string& path) {
    const UniqueFd held = held_upload(root, path);

    struct stat status {};

    if (::fstat(held.get(), &status) != 0) throw failed_call("the file cannot be read", errno);
    if (!S_ISREG(status.st_mode)) throw MediaError(MediaState::unsupported, "this is not a regular file");
    UniqueFd file(::open(fmt::format("/proc/self/fd/{}", held.get()).c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) throw failed_call("the file cannot be opened", errno);
    return file;
}

/// Reads the photo that the order names, and hands its picture to the player.
/// @param file    a name by which the open file can be read
/// @param memory  for the order's slots, of which the first is used
/// @throws MediaError as load_still() does
void read_photo(const ReaderOrder& order, const std::string& file, const MessageSocket& player,
                const UniqueFd& memory) {
    const PictureSlots slots(memory, order.slots, PictureSlots::Use::writing);
    const Sample picture = load_photo(
        {.file = file, .width = order.width, .height = order.height, .background = order.background});
    if (!copy_picture(picture, slots.writable_slot(0)))
        throw MediaError(FaultOwner::program, "the picture is larger than its place");
    player.send(to_message(PictureNote{.width = picture.width,
                                       .height = picture.height,
                                       .layout = static_cast<std::uint32_t>(picture.layout)}));
}

void read_upload(const ReaderOrder& order, const ReaderHandles& handles) {
    const UniqueFd file = open_upload(order.root, order.path);
    enter_sandbox({.readable = {file.get()}, .writable = {}});
    const std::string name = fmt::format("/proc/self/fd/{}", file.get());
    if (order.kind == MediaKind::photo)
        read_photo(order, name, handles.player, handles.memory);
    else
        read_film(order, name, handles.player, handles.memory);
}

}  // namespace

void become_reader(const ReaderOrder& order, const ReaderHandles& handles) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != handles.host) ::_exit(1);  // it died before that line
    FailureNote failure;
    try {
        limit_process(order.kind);
        read_upload(order, handles);
        ::_exit(0);
    } catch (const MediaError& error) {
        failure = {.owner = error.owner(), .text = error.what()};
    } catch (const std::bad_alloc&) {
        failure = {.owner = FaultOwner::file, .text = "it needs too much memory"};
    } catch (const std::exception& error) {
        failure = {.owner = FaultOwner::program, .text = error.what()};
    }
    handles.player.send(to_message(failure));
    ::_exit(0);
}

}  // namespace vitrine::player
