#!/usr/bin/env python3
"""Prints what captions add to the cost of a wall's frame, off screen.

    bench/playback/captions.py BUILD_DIRECTORY MEDIA_FOLDER STATE_DIRECTORY [PAIRS]

The state directory is one of the analyzer for the folder. The same wall plays with the names of all files as captions
and without, in turn; every frame is drawn. The cost is processor time without that of a start, the least of all pairs:
what else the machine does only adds to it.
"""
import os
import subprocess
import sys
from pathlib import Path

BUILD, MEDIA, STATE = (Path(word).resolve() for word in sys.argv[1:4])
PAIRS = int(sys.argv[4]) if len(sys.argv) > 4 else 4
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
SECONDS, RATE, SLOTS = 12, 25, 4
SETTINGS = ["--media.root", MEDIA, "--state.directory", STATE, "--status.folder", ""]


def processor_seconds(command):
    process = subprocess.Popen(list(map(str, command)), stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{command[0]} failed")
    return usage.ru_utime + usage.ru_stime


def wall(captions, seconds):
    return processor_seconds([PLAYER, *SETTINGS, "--screen", "offscreen:1280x720", "--pace", "exact", "--output.frame_rate", RATE,
                              "--layout.slots", SLOTS, "--show.captions", captions, "--duration", f"{seconds}s"])


def main():
    processor_seconds([ANALYZER, "watch", "--once", "--without-tapestries", *SETTINGS, "--show.captions", "names"])
    frames, costs = (SECONDS - 1) * RATE, {"names": [], "none": []}
    for _ in range(PAIRS):
        for captions, found in costs.items():
            found.append((wall(captions, SECONDS) - wall(captions, 1)) / frames)
    named, plain = min(costs["names"]), min(costs["none"])
    print(f"a frame with captions {1000 * named:.1f} ms, without {1000 * plain:.1f} ms: {named / plain:.3f} times")


if __name__ == "__main__":
    main()
