#include "base/media/gst_ptr.hpp"

#include "base/system/unique_fd.hpp"
#include "tests/temporary_directory.hpp"

#include <fcntl.h>
#include <unistd.h>

using namespace vitrine;

TEST_CASE("what libraries complain of does not fill the journal") {
    start_gstreamer();
    const TemporaryDirectory directory;
    const auto file = directory.write("said", "");
    const UniqueFd kept(::dup(STDERR_FILENO));
    const UniqueFd said(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    REQUIRE(::dup2(said.get(), STDERR_FILENO) >= 0);
    g_log("GStreamer", G_LOG_LEVEL_CRITICAL, "gst_poll_write_control: assertion 'set != NULL' failed");
    REQUIRE(::dup2(kept.get(), STDERR_FILENO) >= 0);
    CHECK(std::filesystem::file_size(file) == 0);
}
