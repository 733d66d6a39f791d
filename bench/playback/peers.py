#!/usr/bin/env python3
"""Prints what a wall of films costs the processor, as ratios to other programs in the same run.

    bench/playback/peers.py BUILD_DIRECTORY [SECONDS]

A wall of 1280x720 px at 30 pictures a second, of four 720p films and of nine 360p films: processor seconds of this player,
with and without the drawing (which is the graphics card's work where there is one), and of GStreamer's compositor, ffmpeg's
xstack and mpv's. The player plays clips from the analyzer's store, which are made here by the analyzer itself, and the films
themselves only where there is none: both are measured. A peer that is not installed is left out.
"""
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

BUILD = Path(sys.argv[1]).resolve()
BENCH = BUILD / "tests" / "bench" / "playback" / "wall_bench"
SECONDS = int(sys.argv[2]) if len(sys.argv) > 2 else 10
WIDTH, HEIGHT, RATE = 1280, 720, 30


def ffmpeg(*arguments):
    subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-y", *map(str, arguments)], check=True)


def cost(command):
    """Processor seconds of a command and of its children, and what it said."""
    with tempfile.TemporaryFile("w+") as said:
        process = subprocess.Popen(list(map(str, command)), stdin=subprocess.DEVNULL, stdout=said, stderr=said)
        _, status, usage = os.wait4(process.pid, 0)
        said.seek(0)
        text = said.read()
    if status != 0:
        sys.exit(f"{command[0]} failed:\n{text}")
    return usage.ru_utime + usage.ru_stime, text.strip()


ENCODE = ["-pix_fmt", "yuv420p", "-c:v", "libx264", "-preset", "medium"]


def make_films(folder):
    film, small = folder / "720.mp4", folder / "360.mp4"
    ffmpeg("-f", "lavfi", "-i", "testsrc2=size=1280x720:rate=30", "-vf", "noise=alls=8:allf=t,hue=h=t*20", "-t", SECONDS + 2,
           *ENCODE, "-b:v", "4000k", "-g", 60, "-bf", 2, film)
    ffmpeg("-i", film, "-vf", "scale=640:360", *ENCODE, "-crf", 21, "-g", 60, "-bf", 2, small)
    return film, small


def make_clip(folder, film, slots):
    """What the analyzer keeps of a film in its store where so many shots share the wall."""
    media, state = folder / f"media{slots}", folder / f"state{slots}"
    media.mkdir()
    state.mkdir()
    (state / "screen").write_text(f"{WIDTH}\n")  # as the player notes it
    shutil.copy(film, media)
    cost([BUILD / "analyzer" / "vitrine-analyzer", "watch", "--once", "--without-tapestries", "--media.root", media, "--state.directory", state, "--layout.slots", slots])
    clips = sorted(state.glob("store/*/*.mp4"), key=lambda clip: clip.stat().st_size)
    if not clips:
        sys.exit("the store has no clip of the film")
    return clips[-1]


def places(count):
    side = {4: 2, 9: 3, 16: 4}[count]
    across, down = WIDTH // side, HEIGHT // side
    return side, across, down, [(i % side * across, i // side * down) for i in range(count)]


def compositor(film, count):
    _, across, down, at = places(count)
    pads = [f"sink_{i}::{key}={value}" for i, (x, y) in enumerate(at)
            for key, value in (("xpos", x), ("ypos", y), ("width", across), ("height", down))]
    command = ["gst-launch-1.0", "-q", "compositor", "name=c", *pads, "!", f"video/x-raw,width={WIDTH},height={HEIGHT},framerate={RATE}/1",
               "!", "fakesink", "sync=true", f"num-buffers={SECONDS * RATE}"]
    for i in range(count):
        command += ["filesrc", f"location={film}", "!", "qtdemux", "!", "h264parse", "!", "avdec_h264", "max-threads=1", "!", "queue", "!", f"c.sink_{i}"]
    return command


def decoders(film, count):
    chain = ["filesrc", f"location={film}", "!", "qtdemux", "!", "h264parse", "!", "avdec_h264", "max-threads=1", "!", "queue", "!",
             "fakesink", "sync=true", f"num-buffers={SECONDS * RATE}"]
    return ["gst-launch-1.0", "-q", *(chain * count)]


def stack(count, inputs, output):
    _, across, down, at = places(count)
    scaled = ";".join(f"[{inputs(i)}]scale={across}:{down}[v{i}]" for i in range(count))
    names = "".join(f"[v{i}]" for i in range(count))
    return f"{scaled};{names}xstack=inputs={count}:layout={'|'.join(f'{x}_{y}' for x, y in at)}{output}"


def xstack(film, count):
    inputs = [word for _ in range(count) for word in ("-re", "-threads", "1", "-i", film)]
    return ["ffmpeg", "-nostdin", "-v", "error", *inputs, "-filter_complex", stack(count, lambda i: f"{i}:v", ""),
            "-t", SECONDS, "-f", "null", "-"]


def mpv(film, count):
    others = [f"--external-file={film}" for _ in range(count - 1)]
    return ["mpv", "--no-config", "--really-quiet", "--vo=null", "--no-audio", f"--length={SECONDS}", "--vd-lavc-threads=1", film, *others,
            f"--lavfi-complex={stack(count, lambda i: f'vid{i + 1}', '[vo]')}"]


def ours(mode, film, count):
    side = places(count)[0]
    return [BENCH, mode, side, side, SECONDS, film]


def compare(name, film, clip, count):
    programs = {"gst-launch-1.0": compositor, "ffmpeg": xstack, "mpv": mpv}
    peers = {program: cost(command(film, count))[0] for program, command in programs.items() if shutil.which(program)}
    best = min(peers, key=peers.get)
    print(f"{name}: " + ", ".join(f"{program} {seconds:.2f}" for program, seconds in peers.items()) + " processor seconds", flush=True)
    print(f"  decoding alone: {cost(decoders(film, count))[0] / peers[best]:.2f} of {best}'s", flush=True)
    for source, file in (("films", film), ("clips of the store", clip)):
        for mode in ("upload", "draw"):
            seconds, said = cost(ours(mode, file, count))
            print(f"  ours, {source}, {'drawn' if mode == 'draw' else 'not drawn'}: {seconds:.2f}, {seconds / peers[best]:.2f} of {best}'s; {said}",
                  flush=True)


def main():
    with tempfile.TemporaryDirectory(prefix="vitrine-bench-") as name:
        film, small = make_films(Path(name))
        compare("four 720p films", film, make_clip(Path(name), film, 4), 4)
        compare("nine 360p films", small, make_clip(Path(name), small, 9), 9)
        seconds, said = cost(ours("draw", make_clip(Path(name), film, 16), 16))
        print(f"sixteen clips of the store: {seconds:.2f} processor seconds, {seconds / SECONDS:.2f} cores; {said}")


if __name__ == "__main__":
    main()
