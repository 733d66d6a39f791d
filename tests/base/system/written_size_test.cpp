#include "base/system/unique_fd.hpp"
#include "base/system/written_size.hpp"

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdlib>
#include <string>

using namespace vitrine;

namespace {

constexpr off_t block = 1 << 16;

UniqueFd scratch_file() {
    std::string name = "/tmp/vitrine-test-XXXXXX";
    UniqueFd file(::mkstemp(name.data()));
    REQUIRE(file.is_open());
    ::unlink(name.c_str());
    return file;
}

void write_at(const UniqueFd& file, off_t offset) {
    const std::string data(block, 'x');
    REQUIRE(::pwrite(file.get(), data.data(), data.size(), offset) == block);
}

}  // namespace

TEST_CASE("a preallocated file is written as far as its copy has come") {
    const UniqueFd file = scratch_file();
    REQUIRE(::ftruncate(file.get(), 10 * block) == 0);
    CHECK(written_size(file.get()) == 0);
    write_at(file, 0);
    write_at(file, block);
    CHECK(written_size(file.get()) == 2 * block);
}

TEST_CASE("a hole with data behind it is content") {
    const UniqueFd file = scratch_file();
    write_at(file, 0);
    write_at(file, 9 * block);
    CHECK(written_size(file.get()) == 10 * block);
}

TEST_CASE("an empty file has nothing written") {
    CHECK(written_size(scratch_file().get()) == 0);
}
