"""Small media of every format that docs/operator.md names, and what happens to files on their way.

The seeds are drawn with ffmpeg and vips; a format that these cannot write on a machine is left out. A mutation
depends on nothing but its number, so that a finding can be made again.
"""
import random
import subprocess
from pathlib import Path

PICTURE = "testsrc2=size=96x64:rate=1:duration=1"
FILM = ("color=gray:size=96x64:rate=10:duration=0.5,drawbox=x='mod(t*60\\,80)':y=20:w=16:h=20:c=white:t=fill[a];"
        "color=navy:size=96x64:rate=10:duration=0.5[b];[a][b]concat=n=2,format=yuv420p")

PHOTOS = {
    "jpg": ["-pix_fmt", "yuvj420p"], "png": [], "bmp": [], "tiff": ["-pix_fmt", "rgb24"], "gif": [],
    "webp": ["-c:v", "libwebp"], "avif": ["-c:v", "libaom-av1", "-still-picture", "1", "-cpu-used", "8"],
}
FILMS = {
    "h264.mp4": ["-c:v", "libx264", "-preset", "ultrafast"],
    "faststart.mp4": ["-c:v", "libx264", "-preset", "ultrafast", "-movflags", "+faststart"],
    "fragmented.mp4": ["-c:v", "libx264", "-preset", "ultrafast", "-movflags", "+frag_keyframe+empty_moov"],
    "h264.mov": ["-c:v", "libx264", "-preset", "ultrafast"],
    "h265.mp4": ["-c:v", "libx265", "-preset", "ultrafast", "-x265-params", "log-level=none"],
    "av1.mp4": ["-c:v", "libaom-av1", "-cpu-used", "8", "-usage", "realtime"],
    "mpeg4.mp4": ["-c:v", "mpeg4"],
    "h264.mkv": ["-c:v", "libx264", "-preset", "ultrafast"],
    "vp8.webm": ["-c:v", "libvpx", "-deadline", "realtime"],
    "vp9.webm": ["-c:v", "libvpx-vp9", "-deadline", "realtime", "-cpu-used", "8"],
    "mpeg4.avi": ["-c:v", "mpeg4"], "mjpeg.avi": ["-c:v", "mjpeg", "-pix_fmt", "yuvj420p"],
    "h264.ts": ["-c:v", "libx264", "-preset", "ultrafast"], "mpeg2.ts": ["-c:v", "mpeg2video"],
}


def made(command, path):
    done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    if done.returncode == 0 and path.exists() and path.stat().st_size > 0:
        return True
    path.unlink(missing_ok=True)
    return False


def drawn(folder, formats, source, last):
    seeds = {}
    for name, options in formats.items():
        path = Path(folder) / f"seed.{name}"
        if made(["ffmpeg", "-nostdin", "-v", "error", "-y", "-f", "lavfi", "-i", source, *options, *last, str(path)], path):
            seeds[name] = path
    return seeds


def draw_films(folder, formats):
    """@param formats  name -> what ffmpeg is told beside"""
    return drawn(folder, formats, FILM, ["-g", "5"])


def draw_seeds(folder):
    """format -> file, of all that can be drawn here."""
    folder = Path(folder)
    seeds = drawn(folder, PHOTOS, PICTURE, ["-frames:v", "1"]) | draw_films(folder, FILMS)
    heic = folder / "seed.heic"
    if "png" in seeds and made(["vips", "heifsave", str(seeds["png"]), str(heic)], heic):
        seeds["heic"] = heic
    return seeds


def truncated(data, rng, _):
    return data[:rng.randrange(len(data))]


def flipped(data, rng, _):
    out = bytearray(data)
    for _ in range(rng.choice([1, 1, 3, 10, 100])):
        out[rng.randrange(len(out))] ^= 1 << rng.randrange(8)
    return bytes(out)


def noisy(data, rng, _):
    out = bytearray(data)
    begin = rng.randrange(len(out))
    for i in range(begin, min(len(out), begin + rng.choice([4, 64, 1024]))):
        out[i] = rng.randrange(256)
    return bytes(out)


def zeroed(data, rng, _):
    begin = rng.randrange(len(data))
    end = min(len(data), begin + rng.choice([16, 512, 4096, len(data)]))
    return data[:begin] + bytes(end - begin) + data[end:]


def spliced(data, rng, other):
    return data[:rng.randrange(len(data))] + other[rng.randrange(len(other)):]


def header_field(data, rng, _):
    """A number among the first ones, or behind any four letters that may name a box, becomes an extreme one."""
    out = bytearray(data)
    at = rng.randrange(min(len(out), 256))
    names = [i for i in range(len(out) - 12) if out[i:i + 4].isalpha()]
    if names and rng.random() < 0.7:
        at = rng.choice(names) + rng.choice([-4, 4, 8])
    width = rng.choice([1, 2, 4])
    value = rng.choice([0, 1, 0x7f, 0xff, 0x7fff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff]) & ((1 << 8 * width) - 1)
    field = value.to_bytes(width, rng.choice(["big", "little"]))
    at = max(0, min(at, len(out) - width))
    out[at:at + width] = field
    return bytes(out)


def repeated(data, rng, _):
    begin = rng.randrange(len(data))
    end = min(len(data), begin + rng.choice([8, 256, 4096]))
    return data[:end] + data[begin:end] * rng.choice([1, 3, 50]) + data[end:]


MUTATIONS = [truncated, flipped, noisy, zeroed, spliced, header_field, repeated]


def mutant(number, seeds):
    """-> (format, mutation's name, bytes) of that number, in turn of every format and every mutation."""
    rng = random.Random(number)
    formats = sorted(seeds)
    form = formats[number % len(formats)]
    mutate = MUTATIONS[number // len(formats) % len(MUTATIONS)]
    other = seeds[rng.choice(formats)]
    return form, mutate.__name__, mutate(seeds[form].read_bytes(), rng, other.read_bytes())
