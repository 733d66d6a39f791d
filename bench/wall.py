#!/usr/bin/env python3
"""Prints what the two programs cost, against limits taken in the same run.

    bench/wall.py BUILD_DIRECTORY [FILM]

Analysis time of a 720p film against decoding alone and against the paper's 300 frames in 90 s; late pictures of a wall of
four 720p films at 15 pictures a second; peak memory of the analysis of a 100-megapixel JPEG. FILM is what the four films
are cut from (default: drawn by ffmpeg). Nothing here passes or fails.
"""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
ANALYZER, PLAYER = BUILD / "analyzer" / "vitrine-analyzer", BUILD / "player" / "vitrine-player"
SECONDS, RATE = 12, 30
PAPER = 90 / 300  # seconds a frame


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def cost(command):
    """Processor seconds, wall seconds and peak resident MiB of a command, and what it said."""
    with tempfile.TemporaryFile("w+") as said:
        start = time.monotonic()
        process = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        wall = time.monotonic() - start
        said.seek(0)
        text = said.read()
    if status != 0:
        sys.exit(f"{command[0]} failed:\n{text}")
    return usage.ru_utime + usage.ru_stime, wall, usage.ru_maxrss / 1024, text


def make_films(folder, source):
    encode = ["-t", SECONDS, "-r", RATE, "-an", "-pix_fmt", "yuv420p", "-c:v", "libx264", "-preset", "veryfast",
              "-b:v", "4000k", "-g", 2 * RATE, "-bf", 2]
    for i in range(4):
        if source:
            ffmpeg("-stream_loop", 9, "-ss", i, "-i", source, "-vf", "scale=1280:720,setsar=1", *encode, folder / f"{i}.mp4")
        else:
            ffmpeg("-f", "lavfi", "-i", f"mandelbrot=size=1280x720:rate={RATE}:start_scale={3 - i * 0.5}", *encode, folder / f"{i}.mp4")


def main():
    with tempfile.TemporaryDirectory(prefix="vitrine-bench-") as name:
        root, state = Path(name) / "media", Path(name) / "state"
        root.mkdir()
        jpeg = Path(name) / "large.jpg"
        ffmpeg("-f", "lavfi", "-i", "mandelbrot=size=2900x2175:rate=1", "-frames:v", 1, "-vf", "scale=11600:8700", "-q:v", 4, jpeg)
        memory = cost([ANALYZER, "analyze", jpeg])[2]
        print(f"peak memory on a 100-megapixel JPEG: {memory:.0f} MiB")

        make_films(root, Path(sys.argv[2]) if len(sys.argv) > 2 else None)
        film, frames = root / "0.mp4", SECONDS * RATE
        decoding = cost(["ffmpeg", "-nostdin", "-v", "error", "-threads", 1, "-i", film, "-f", "null", "-"])[0]
        analysis = cost([ANALYZER, "analyze", film])[0]
        print(f"analysis of {frames} frames at 720p: {analysis:.2f} processor seconds; {analysis / decoding:.2f} times decoding alone, "
              f"{PAPER * frames / analysis:.0f} times as fast as the paper")

        settings = ["--media.root", root, "--state.directory", state]
        cost([ANALYZER, "watch", "--once", "--without-tapestries", *settings])
        cpu, wall, memory, log = cost([PLAYER, *settings, "--screen", "offscreen:1280x720", "--pace", "realtime", "--slots", 4,
                                       "--output.frame_rate", 15, "--duration", "20s"])
        print(f"four 720p films at 15 pictures a second: {cpu / wall:.2f} cores, {memory:.0f} MiB; {log.strip().splitlines()[-1]}")


if __name__ == "__main__":
    main()
