#!/usr/bin/python3
"""A FUSE file system that shows a folder and fails as it is told.

    hostile_share.py BACKING MOUNTPOINT FAULTS [CALLERS]

CALLERS is a file that gets a line for each file opened and each read: the process that asked, and the call.
FAULTS is a JSON file that is read again at each call: a list of {"path": GLOB, "call": CALL, ...}. CALL is one of
stat, list, open, read. A fault has one of these:

    "errno": N        the call fails
    "hang": true      the call does not return before the fault is gone
    "half": true      (list) every second entry is missing
    "short": N        (read) at most N bytes are given
"""
import errno
import fnmatch
import json
import os
import stat
import sys
import time

from fusepy import FUSE, FuseOSError, Operations, fuse_get_context


class HostileShare(Operations):
    def __init__(self, backing, faults, callers):
        self.backing, self.faults, self.callers = backing, faults, callers

    def real(self, path):
        return self.backing + path

    def fault(self, path, call):
        """The fault of a call; calls that hang wait here."""
        while True:
            try:
                with open(self.faults, encoding="utf-8") as file:
                    faults = json.load(file)
            except (OSError, ValueError):
                faults = []
            found = next((one for one in faults if one["call"] == call and fnmatch.fnmatchcase(path, one["path"])), {})
            if not found.get("hang"):
                break
            time.sleep(0.05)
        if "errno" in found:
            raise FuseOSError(found["errno"])
        return found

    # FUSE's names and arguments

    def getattr(self, path, fh=None):
        self.fault(path, "stat")
        try:
            status = os.lstat(self.real(path))
        except OSError as error:
            raise FuseOSError(error.errno) from error
        return {key: getattr(status, key) for key in
                ("st_mode", "st_nlink", "st_uid", "st_gid", "st_size", "st_atime", "st_mtime", "st_ctime", "st_ino")}

    def access(self, path, amode):
        if not os.access(self.real(path), amode):
            raise FuseOSError(errno.EACCES)

    def readdir(self, path, fh):
        fault = self.fault(path, "list")
        names = sorted(os.listdir(self.real(path)))
        return [".", "..", *(names[::2] if fault.get("half") else names)]

    def note_caller(self, call):
        if not self.callers:
            return
        thread = fuse_get_context()[2]  # it waits for the answer, so it is still there
        with open(f"/proc/{thread}/status", encoding="utf-8") as status:
            process = next(line.split()[1] for line in status if line.startswith("Tgid:"))
        with open(self.callers, "a", encoding="utf-8") as callers:
            callers.write(f"{process} {call}\n")

    def open(self, path, flags):
        self.note_caller("open")
        self.fault(path, "open")
        if flags & (os.O_WRONLY | os.O_RDWR):
            raise FuseOSError(errno.EROFS)
        try:
            return os.open(self.real(path), os.O_RDONLY)
        except OSError as error:
            raise FuseOSError(error.errno) from error

    def read(self, path, size, offset, fh):
        self.note_caller("read")
        fault = self.fault(path, "read")
        return os.pread(fh, min(size, fault.get("short", size)), offset)

    def release(self, path, fh):
        os.close(fh)

    def statfs(self, path):
        found = os.statvfs(self.backing)
        return {key: getattr(found, key) for key in ("f_bavail", "f_bfree", "f_blocks", "f_bsize", "f_files", "f_frsize")}


def main():
    backing, mountpoint, faults = sys.argv[1:4]
    callers = sys.argv[4] if len(sys.argv) > 4 else None
    assert stat.S_ISDIR(os.stat(backing).st_mode)
    # Nothing is remembered, so that each call of the analyzer comes here.
    FUSE(HostileShare(backing, faults, callers), mountpoint, foreground=True, ro=True, allow_other=True, direct_io=True,
         attr_timeout=0, entry_timeout=0, negative_timeout=0, fsname="hostile")


if __name__ == "__main__":
    main()
