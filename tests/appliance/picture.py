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
        return [(step * x, step * y) for y, row in enumerate(self.rows_of(colour, tolerance, step)) for x, found in enumerate(row) if found]

    def middle_of(self, colour):
        """The middle of what is about of a colour. None: nothing is."""
        places = self.places_of(colour)
        return tuple(sum(axis) / len(places) for axis in zip(*places)) if places else None

    def share_of(self, colour, tolerance=50, step=4):
        """The share of the picture that is about of a colour."""
        found = [row.count(1) for row in self.rows_of(colour, tolerance, step)]
        return sum(found) / (len(found) * len(range(0, self.width, step)))

    def rows_of(self, colour, tolerance, step):
        """Each 4th pixel both ways: 1 where it is about of a colour, else 0. In few steps of Python: much is waited for this way,
        beside a machine that needs the processor."""
        tables = [bytes(abs(value - wanted) < tolerance for value in range(256)) for wanted in colour]
        for y in range(0, self.height, step):
            row = self.pixels[y * self.width * 3:(y + 1) * self.width * 3]
            near = [int.from_bytes(row[channel::3 * step].translate(table), "big") for channel, table in enumerate(tables)]
            yield (near[0] & near[1] & near[2]).to_bytes(len(range(0, self.width, step)), "big")

    def save(self, path):
        """As PNG."""
        stride = self.width * 3
        rows = b"".join(b"\0" + self.pixels[y * stride:(y + 1) * stride] for y in range(self.height))

        def chunk(name, data):
            return len(data).to_bytes(4, "big") + name + data + zlib.crc32(name + data).to_bytes(4, "big")

        header = self.width.to_bytes(4, "big") + self.height.to_bytes(4, "big") + b"\x08\x02\0\0\0"
        Path(path).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 1)) + chunk(b"IEND", b""))
