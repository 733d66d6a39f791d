// The reader host as the tests start it: the player's own program without the player.

#include "player/playback/reader/host_process.hpp"

#include <unistd.h>

#include <cstdio>
#include <exception>

int main() {
    try {
        vitrine::player::serve_orders();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "reader host: %s\n", error.what());
        ::_exit(1);
    }
    ::_exit(0);
}
