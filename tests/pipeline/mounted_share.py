"""A share that answers as a test tells it: tests/share/hostile_share.py, mounted."""
import json
import os
import subprocess
import time
from pathlib import Path

SHARE = Path(__file__).resolve().parents[1] / "share" / "hostile_share.py"
PATIENCE = 30  # seconds until a mount that must come is given up


def can_mount():
    found = subprocess.run(["/usr/bin/python3", "-c", "import fusepy"], check=False, stderr=subprocess.DEVNULL)
    return found.returncode == 0 and os.access("/dev/fuse", os.W_OK) and os.geteuid() == 0


class MountedShare:
    def __init__(self, backing, mountpoint, faults, *callers):
        self.faults, self.mountpoint = Path(faults), mountpoint
        self.command = ["/usr/bin/python3", SHARE, backing, mountpoint, faults, *callers]
        self.process = None
        self.fail_with()
        self.mount()

    def mount(self):
        self.process = subprocess.Popen(self.command, stderr=subprocess.DEVNULL)
        end = time.monotonic() + PATIENCE
        while not os.path.ismount(self.mountpoint):
            if self.process.poll() is not None or time.monotonic() > end:
                raise RuntimeError("the share cannot be mounted")
            time.sleep(0.05)

    def fail_with(self, *faults):
        """The calls that fail from now on, as hostile_share.py describes them."""
        beside = self.faults.with_suffix(".new")
        beside.write_text(json.dumps(faults))
        beside.rename(self.faults)

    def kill(self):
        """From now on each call is answered with "Transport endpoint is not connected"."""
        self.process.kill()
        self.process.wait()

    def unmount(self):
        self.fail_with()
        self.kill()
        subprocess.run(["umount", "-l", self.mountpoint], stderr=subprocess.DEVNULL, check=False)
