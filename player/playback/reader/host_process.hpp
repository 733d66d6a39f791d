#pragma once

namespace vitrine::player {

/// Runs the reader host in this process: takes the player's orders on the standard input and forks a reader
/// for each. Returns when the player has closed its end. Libraries and plugins are loaded once, before the
/// first order, so that a reader starts within milliseconds and needs no file but the one that it reads.
///
/// Call it in a process that has nothing else: no threads, and no descriptors that a reader must not have.
/// Closes all descriptors but the three standard ones.
void serve_orders();

}  // namespace vitrine::player
