#!/usr/bin/env python3
"""How many pictures come late while users ask the player over the bus without a pause.

    users.py BUILD_DIRECTORY [USERS [SECONDS]]

Plays a wall of photos off screen, 720p, 30 pictures a second: once alone, once with the users, on a bus of its own.
Prints for each run the pictures left out as too late, their ratio to those that were due, and how long ticks waited
for the thread that draws: timer_delay.cpp says what counts.
"""
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

TESTS = Path(__file__).resolve().parents[2] / "tests"
sys.path[:0] = [str(TESTS), str(TESTS / "pipeline")]
from drawn_media import png  # noqa: E402
from private_bus import start_bus  # noqa: E402

BUILD = Path(sys.argv[1]).resolve()
USERS = int(sys.argv[2]) if len(sys.argv) > 2 else 100
SECONDS = int(sys.argv[3]) if len(sys.argv) > 3 else 20
RATE = 30


def play(folder, settings, users):
    environment = os.environ | {"DBUS_SYSTEM_BUS_ADDRESS": f"unix:path={folder / 'bus'}"}
    timed = environment | {"LD_PRELOAD": str(BUILD / "bench/control/libtimer_delay.so")}
    player = subprocess.Popen([BUILD / "player/vitrine-player", *settings, "--pace", "realtime", "--duration", str(SECONDS + 4),
                               "--output.screen", "offscreen:1280x720", "--output.frame_rate", str(RATE)],
                              env=timed, stderr=subprocess.PIPE, text=True)
    time.sleep(3)
    if users:
        print(subprocess.run([BUILD / "bench/control/bus_users", str(users), str(SECONDS)], env=environment, check=True,
                             capture_output=True, text=True).stdout.strip())
    log = player.communicate()[1]
    shown, late = map(int, re.search(r"(\d+) pictures shown, (\d+) left out", log).groups())
    print(f"{users} users: {shown} pictures shown, {late} left out as too late: {late / max(1, shown + late):.3f}")
    print(re.search(r".* ticks; .*", log).group())


def main():
    with tempfile.TemporaryDirectory(prefix="vitrine-users-") as kept:
        folder = Path(kept)
        media = folder / "media"
        media.mkdir()
        for i in range(12):
            png(media / f"{i}.png", 160, 90, lambda x, y, i=i: (20 * i, x, 2 * y))
        settings = ["--media.root", str(media), "--state.directory", str(folder / "state")]
        subprocess.run([BUILD / "analyzer/vitrine-analyzer", "watch", "--once", "--without-tapestries", *settings, "--analyzer.quiet_milliseconds", "100",
                        "--analyzer.face_model", "", "--tapestry.max_bytes", "0"], check=True, capture_output=True)
        bus = start_bus(folder / "bus")
        try:
            play(folder, settings, 0)
            play(folder, settings, USERS)
        finally:
            bus.terminate()
            bus.wait()


if __name__ == "__main__":
    main()
