"""Pictures that the tests draw."""
import random
import zlib


def png(path, width, height, pixel):
    """Writes pixel(x, y) -> (r, g, b) as a PNG."""
    rows = b"".join(b"\0" + bytes(v for x in range(width) for v in pixel(x, y)) for y in range(height))

    def chunk(name, data):
        body = name + data
        return len(data).to_bytes(4, "big") + body + zlib.crc32(body).to_bytes(4, "big")

    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + b"\x08\x02\0\0\0"
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))


def pattern(number):
    """-> pixel(x, y) of bright fields of 8 x 8 px, others for each number: pictures that are alike would be one on the wall."""
    chance = random.Random(number)
    fields = {}

    def pixel(x, y):
        at = x // 8, y // 8
        if at not in fields:
            fields[at] = tuple(chance.randrange(60, 250) for _ in range(3))
        return fields[at]

    return pixel
