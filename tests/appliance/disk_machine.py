"""The machine that boots the appliance's disk itself, as hardware would: its firmware, its loader, its kernel, and a network
over which its share can be reached."""
import socket
from pathlib import Path

from machine import Machine

KERNEL = ("-kernel", "-initrd", "-append")  # what the rig's own machine is given by QEMU


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class DiskMachine(Machine):
    """share_port: of this host, forwarded to the appliance's SMB."""

    def __init__(self, disk, snapshot=None, safe=False, firmware=None):
        """disk: a qcow2; safe: what the guest flushes is flushed to it, so that QEMU may be killed."""
        self.safe, self.firmware, self.share_port = safe, firmware, free_port()
        super().__init__(Path(), disk, snapshot)

    def command(self, image, disk):
        words = super().command(image, disk)
        for option in KERNEL:
            at = words.index(option)
            del words[at:at + 2]
        if self.safe:
            words = [word.replace("cache=unsafe", "cache=writeback") if isinstance(word, str) else word for word in words]
        if self.firmware:
            words += ["-drive", f"if=pflash,format=raw,unit=0,readonly=on,file={self.firmware}"]
        return words + ["-netdev", f"user,id=n0,restrict=on,hostfwd=tcp:127.0.0.1:{self.share_port}-:445",
                        "-device", "virtio-net-pci,netdev=n0,romfile="]
