#include "base/system/hold_below.hpp"

#include "base/system/atomic_file.hpp"
#include "tests/missing_call.hpp"
#include "tests/temporary_directory.hpp"

#include <doctest/doctest.h>

#include <string>
#include <system_error>

using namespace vitrine;

namespace {

namespace fs = std::filesystem;

std::string content(const UniqueFd& file) {
    return read_file("/proc/self/fd/" + std::to_string(file.get()));
}

std::error_code refusal(const fs::path& root, const fs::path& path) {
    try {
        (void)hold_below(root, path);
    } catch (const std::system_error& error) {
        return error.code();
    }
    return {};
}

}  // namespace

TEST_CASE("a file is held, whatever takes its name later") {
    const TemporaryDirectory home;
    home.write("media/folder/a.jpg", "picture");
    const UniqueFd file = hold_below(home.path / "media", "folder/a.jpg");
    home.write("secret", "secret");
    fs::remove(home.path / "media/folder/a.jpg");
    fs::create_symlink(home.path / "secret", home.path / "media/folder/a.jpg");
    CHECK(content(file) == "picture");
}

TEST_CASE("no link is followed below the folder, in no part of the path") {
    const TemporaryDirectory home;
    home.write("outside/secret", "secret");
    home.write("media/inside/a.jpg", "picture");
    fs::create_symlink(home.path / "outside/secret", home.path / "media/file");
    fs::create_symlink(home.path / "outside", home.path / "media/folder");
    fs::create_symlink("inside", home.path / "media/here");
    CHECK(refusal(home.path / "media", "file") == std::errc::too_many_symbolic_link_levels);
    CHECK(refusal(home.path / "media", "folder/secret") == std::errc::too_many_symbolic_link_levels);
    CHECK(refusal(home.path / "media", "here/a.jpg") == std::errc::too_many_symbolic_link_levels);
}

TEST_CASE("no link is followed where the kernel has no call for it") {
    const TemporaryDirectory home;
    home.write("media/inside/a.jpg", "picture");
    fs::create_symlink("inside/a.jpg", home.path / "media/file");
    fs::create_symlink("inside", home.path / "media/here");
    CHECK(holds_without_call(SYS_openat2, ENOSYS, [&] {
        return content(hold_below(home.path / "media", "inside/a.jpg")) == "picture" &&
               refusal(home.path / "media", "file") == std::errc::too_many_symbolic_link_levels &&
               refusal(home.path / "media", "here/a.jpg") == std::errc::too_many_symbolic_link_levels &&
               refusal(home.path / "media", "gone") == std::errc::no_such_file_or_directory;
    }));
}

TEST_CASE("nothing above the folder is found") {
    const TemporaryDirectory home;
    home.write("secret", "secret");
    fs::create_directories(home.path / "media");
    CHECK(refusal(home.path / "media", "../secret") == std::errc::cross_device_link);
    CHECK(refusal(home.path / "media", "gone") == std::errc::no_such_file_or_directory);
}

TEST_CASE("the folder itself may be a link") {
    const TemporaryDirectory home;
    home.write("media/a.jpg", "picture");
    fs::create_directory_symlink(home.path / "media", home.path / "link");
    CHECK(content(hold_below(home.path / "link", "a.jpg")) == "picture");
}
