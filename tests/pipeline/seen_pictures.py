"""Pictures that the programs have made, as bytes, and what is seen on them."""
import subprocess


def pictures_of(path, width, height):
    """The frames of a film or picture as rgb24 bytes, width x height px."""
    raw = subprocess.run(["ffmpeg", "-nostdin", "-v", "error", "-i", str(path), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                         capture_output=True, check=True).stdout
    size = width * height * 3
    assert len(raw) % size == 0, f"{path} is not {width}x{height}"
    return [raw[i:i + size] for i in range(0, len(raw), size)]


def pixels_near(picture, colour, tolerance):
    """A byte for each px of a picture: 1 where all channels are nearer to the colour's than `tolerance`.

    All px are compared at once: a loop over them would take most of the time of a test.
    """
    near = -1
    for channel, level in enumerate(colour):
        table = bytes(abs(value - level) < tolerance for value in range(256))
        near &= int.from_bytes(picture[channel::3].translate(table), "big")
    return near.to_bytes(len(picture) // 3, "big")


def share_near(picture, colour, tolerance=60):
    """Share of the picture's px that are about this colour."""
    near = pixels_near(picture, colour, tolerance)
    return near.count(1) / len(near)


def middle_of(picture, width, colour, tolerance):
    """The mean place of the px about this colour and how many there are, every second one of every second row looked at."""
    near = pixels_near(picture, colour, tolerance)
    rows = [near[at:at + width:2] for at in range(0, len(near), 2 * width)]
    counts = [row.count(1) for row in rows]
    count = sum(counts)
    if not count:
        return 0, 0, 0
    some = b"".join(rows)
    across = len(rows[0])
    xs = sum(2 * x * some[x::across].count(1) for x in range(across))
    ys = sum(2 * y * counted for y, counted in enumerate(counts))
    return xs / count, ys / count, count
