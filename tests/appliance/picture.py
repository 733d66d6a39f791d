"""Pictures of the scan-out, and which colours are in them."""
import re
import zlib
from pathlib import Path


class Picture:
    def __init__(self, width, height, pixels):
        """pixels: RGB bytes, row by row."""
        self.width, self.height, self.pixels = width, height, pixels

    @staticmethod
    def read(path):
        """Of a PPM."""
        data = Path(path).read_bytes()
        head = re.match(rb"P6\s+(\d+)\s+(\d+)\s+255\s", data)
        return Picture(int(head[1]), int(head[2]), data[head.end():])

    @property
    def size(self):
        return self.width, self.height

    def part(self, left, top, right, bottom):
        """From a corner to another, which is outside."""
        rows = (self.pixels[(y * self.width + left) * 3:(y * self.width + right) * 3] for y in range(top, bottom))
        return Picture(right - left, bottom - top, b"".join(rows))

    def at(self, x, y):
        begin = (y * self.width + x) * 3
        return tuple(self.pixels[begin:begin + 3])

    def places_of(self, colour, tolerance=50, step=4):
        """Those of each 4th pixel both ways that are about of a colour."""
        return [(x, y) for y in range(0, self.height, step) for x in range(0, self.width, step)
                if all(abs(a - b) < tolerance for a, b in zip(self.at(x, y), colour))]

    def share_of(self, colour, tolerance=50, step=4):
        """The share of the picture that is about of a colour."""
        all_places = len(range(0, self.height, step)) * len(range(0, self.width, step))
        return len(self.places_of(colour, tolerance, step)) / all_places

    def save(self, path):
        """As PNG."""
        stride = self.width * 3
        rows = b"".join(b"\0" + self.pixels[y * stride:(y + 1) * stride] for y in range(self.height))

        def chunk(name, data):
            return len(data).to_bytes(4, "big") + name + data + zlib.crc32(name + data).to_bytes(4, "big")

        header = self.width.to_bytes(4, "big") + self.height.to_bytes(4, "big") + b"\x08\x02\0\0\0"
        Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))
