#include "base/settings/settings_snapshot.hpp"

#include "base/settings/settings_text.hpp"
#include "base/system/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

namespace vitrine {

SettingsSnapshot::SettingsSnapshot(const Settings& settings)
    : file_(::memfd_create("settings", MFD_CLOEXEC)) {
    if (!file_.is_open()) throw_errno("make a file of settings in memory");
    replace(settings);
}

void SettingsSnapshot::replace(const Settings& settings) {
    const std::string toml = to_toml(settings);
    UniqueFd next(::memfd_create("settings", MFD_CLOEXEC));
    if (!next.is_open()) throw_errno("make a file of settings in memory");
    if (::write(next.get(), toml.data(), toml.size()) != static_cast<ssize_t>(toml.size()))
        throw_errno("write settings to memory");
    if (::dup3(next.get(), file_.get(), O_CLOEXEC) < 0) throw_errno("replace settings in memory");
}

std::string SettingsSnapshot::path() const {
    return fmt::format("/proc/{}/fd/{}", ::getpid(), file_.get());
}

}  // namespace vitrine
