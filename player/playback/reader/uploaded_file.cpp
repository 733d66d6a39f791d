#include "player/playback/reader/uploaded_file.hpp"

#include "base/state/media_error.hpp"
#include "base/system/hold_below.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>

#include <cerrno>
#include <system_error>

namespace vitrine::player {

namespace {

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

}  // namespace

UniqueFd open_upload(const std::string& root, const std::string& path) {
    const UniqueFd held = held_upload(root, path);

    struct stat status {};

    if (::fstat(held.get(), &status) != 0) throw failed_call("the file cannot be read", errno);
    if (!S_ISREG(status.st_mode)) throw MediaError(MediaState::unsupported, "this is not a regular file");
    UniqueFd file(::open(fmt::format("/proc/self/fd/{}", held.get()).c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) throw failed_call("the file cannot be opened", errno);
    return file;
}

}  // namespace vitrine::player
