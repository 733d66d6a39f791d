#!/usr/bin/env python3
"""Prints how long a visitor waits for the first strip of a film that is not woven yet, against one second.

    bench/tapestry/opening.py BUILD_DIRECTORY FILM [TIMES]

The film's analysis has kept its frames. Another film is being woven when a scripted touch opens it. Each time both programs run
as a box does, off screen at their own pace. Nothing here passes or fails.
"""
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BUILD, FILM = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
TIMES = int(sys.argv[3]) if len(sys.argv) > 3 else 3
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
PATIENCE = 120  # seconds
LIMIT = 1000  # ms


def wait_for(file, pattern, since=0):
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        found = re.search(pattern, file.read_text()[since:]) if file.exists() else None
        if found:
            return found
        time.sleep(0.01)
    sys.exit(f"'{pattern}' never came:\n{file.read_text()[-2000:]}")


def opening(home):
    """One opening: the waiting in ms as the player says it."""
    media, state = home / "media", home / "state"
    media.mkdir()
    shutil.copy(FILM, media / f"film{FILM.suffix}")
    settings = ["--media.root", media, "--state.directory", state, "--analyzer.saliency", "plain", "--analyzer.quiet_milliseconds", "100",
                "--log.level", "debug"]
    subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *settings], check=True, capture_output=True)
    shutil.copy(FILM, media / f"other{FILM.suffix}")
    os.utime(media / f"other{FILM.suffix}")  # newer, so it is woven first
    subprocess.run([ANALYZER, "watch", "--once", "--without-tapestries", *settings], check=True, capture_output=True)
    (home / "script").write_text("4 pinch 640 360 2 0.3\n")
    logs = {name: home / f"{name}.log" for name in ("analyzer", "player")}
    running = []
    try:
        with open(logs["analyzer"], "wb") as log:
            running.append(subprocess.Popen([ANALYZER, "watch", *settings], stderr=log))
        wait_for(logs["analyzer"], "weaving 'other")
        with open(logs["player"], "wb") as log:
            running.append(subprocess.Popen([PLAYER, *settings, "--pace", "realtime", "--screen", "offscreen:1280x720", "--output.frame_rate", "30",
                                             "--slots", "1", "--show.order", "name", "--rehearse", home / "script"], stderr=log))
        return int(wait_for(logs["player"], r"first view of the tapestry of '.*' after (\d+) ms").group(1))
    finally:
        for process in running:
            process.terminate()
            process.wait()


for number in range(TIMES):
    with tempfile.TemporaryDirectory(prefix="vitrine-opening-") as folder:
        waited = opening(Path(folder))
    print(f"{FILM.name}: first strip after {waited} ms, {waited / LIMIT:.2f} of a second", flush=True)
