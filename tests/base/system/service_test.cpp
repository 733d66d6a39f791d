#include "base/system/service.hpp"

#include "base/system/unique_fd.hpp"
#include "tests/temporary_directory.hpp"

#include <sys/socket.h>
#include <sys/un.h>

#include <array>
#include <cstring>

using namespace vitrine;

namespace {

UniqueFd socket_at(const std::string& path) {
    UniqueFd fd(::socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    REQUIRE(path.size() < sizeof address.sun_path);
    std::memcpy(address.sun_path, path.c_str(), path.size() + 1);
    REQUIRE(::bind(fd.get(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
    return fd;
}

std::string received(const UniqueFd& fd) {
    std::array<char, 512> buffer;
    const ssize_t n = ::recv(fd.get(), buffer.data(), buffer.size(), MSG_DONTWAIT);
    return n < 0 ? "" : std::string(buffer.data(), static_cast<std::size_t>(n));
}

}  // namespace

TEST_CASE("systemd is told what the service does, in one line, and where there is none nothing happens") {
    const TemporaryDirectory directory;
    const std::string path = (directory.path / "notify").string();
    const UniqueFd systemd = socket_at(path);
    ::unsetenv("NOTIFY_SOCKET");
    service::ready("nobody hears this");
    CHECK(received(systemd).empty());

    ::setenv("NOTIFY_SOCKET", path.c_str(), 1);
    service::ready("3 files\nFDSTORE=1");
    CHECK(received(systemd) == "READY=1\nSTATUS=3 files FDSTORE=1");
    service::alive();
    CHECK(received(systemd) == "WATCHDOG=1");
    service::stopping();
    CHECK(received(systemd) == "STOPPING=1");
    ::unsetenv("NOTIFY_SOCKET");
}

TEST_CASE("the watchdog's interval is what systemd set, or nothing") {
    ::unsetenv("WATCHDOG_USEC");
    CHECK_FALSE(service::watchdog_interval().has_value());
    ::setenv("WATCHDOG_USEC", "20000000", 1);
    CHECK(service::watchdog_interval() == std::chrono::seconds(20));
    ::unsetenv("WATCHDOG_USEC");
}
