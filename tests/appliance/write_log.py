"""What a machine wrote to a disk, in order, and the disk as any power cut would have left it.

QEMU's blklogwrites keeps the log, in the format of the kernel's dm-log-writes: a sector with the header, then for each entry
a sector that describes it and its data.
"""
import struct
from dataclasses import dataclass

MAGIC = 0x6A736677736872
FLUSH, FUA, DISCARD = 1, 2, 4


@dataclass
class Entry:
    end: int  # where its data ends in the log, bytes
    flags: int
    at: int  # on the disk, bytes
    data: int  # in the log, bytes
    size: int  # bytes

    @property
    def writes(self):
        return self.size > 0 and not self.flags & DISCARD


def entries(log):
    """Of a log that may have been cut off in the midst of one. log: a file opened for reading."""
    log.seek(0)
    magic, _, _, sector = struct.unpack("<QQQI", log.read(28))
    if magic != MAGIC:
        raise ValueError(f"{log.name} is no log of writes")
    length = log.seek(0, 2)
    found, place = [], sector
    while place + sector <= length:
        log.seek(place)
        at, sectors, flags, _ = struct.unpack("<QQQQ", log.read(32))
        size = sectors * sector
        end = place + sector + (0 if flags & DISCARD else size)
        if end > length or (sectors == 0 and flags == 0):
            break
        found.append(Entry(end, flags, at * sector, place + sector, size))
        place = end
    return found


class Replay:
    """The disk, from its begin on."""

    def __init__(self, log, disk):
        """log, disk: files opened for reading, for reading and writing"""
        self.log, self.disk, self.entries, self.done = log, disk, entries(log), 0

    def write(self, disk, entry):
        if entry.writes:
            self.log.seek(entry.data)
            disk.seek(entry.at)
            disk.write(self.log.read(entry.size))

    def last_flush(self, number):
        """How many of the first `number` entries are sure to be on the disk."""
        return next((i for i in range(number, 0, -1) if self.entries[i - 1].flags & FLUSH), 0)

    def go_to(self, number, chance):
        """The power goes after so many entries: all is there that was flushed; of the rest, that which the disk happened to
        have written by then."""
        flushed = self.last_flush(number)
        for entry in self.entries[self.done:flushed]:
            self.write(self.disk, entry)
        self.disk.flush()
        self.done = max(self.done, flushed)
        most = chance.random()  # how much of its cache a disk has written differs
        return [entry for entry in self.entries[flushed:number] if entry.flags & FUA or chance.random() < most]
