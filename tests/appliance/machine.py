"""One emulated machine with a graphics card of two outputs: QEMU, spoken to through QMP, its guest agent and its display.

Emulated (TCG), so that it runs anywhere; slow, so that nobody may conclude from it how fast anything is.
"""
import base64
import json
import os
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1]))
from picture import Picture  # noqa: E402
from private_bus import start_bus  # noqa: E402

# s for a boot, and for whatever else must come, without the time that the host keeps the machine waiting
PATIENCE = int(os.environ.get("VITRINE_RIG_PATIENCE", 480))
MAX_PATIENCE = max(2400, PATIENCE)  # s with it
WIDTH, HEIGHT = 640, 360  # px of the first panel
JOURNAL_PORT = "vitrine.journal"  # what the guest writes there comes to the file Machine.journal
# A child ends with the process that started it, also where Machine.stop() is not called.
SERVING = ("setpriv", "--pdeathsig", "KILL", "nice", "-n", "5")
CONSOLE = "org.qemu.Display1.Console"


def kept_waiting():
    """Seconds that a processor of the machine could have gone on and this host did not let it, in all."""
    delays = [0]
    for thread in Path(f"/proc/{Machine.running}/task").glob("*/schedstat"):
        try:
            delays.append(int(thread.read_text().split()[1]) / 1e9)
        except OSError:
            pass  # it has ended
    return max(delays)


def wait_for(what, look, patience=PATIENCE, pause=0.3):
    """Until look() gives something; that."""
    begin, kept = time.monotonic(), kept_waiting()
    while not (seen := look()):
        waited, own = time.monotonic() - begin, time.monotonic() - begin - (kept_waiting() - kept)
        if own > patience or waited > MAX_PATIENCE:
            raise AssertionError(f"waited {waited:.0f} s in vain for {what}, {own:.0f} s of them the machine's own")
        time.sleep(pause)
    return seen


class Door:
    """A socket that takes and gives lines of JSON."""

    def __init__(self, path, process):
        self.socket = socket.socket(socket.AF_UNIX)
        wait_for(f"the door '{path}'", lambda: self.connect(path, process), pause=0.05)
        self.words = self.socket.makefile("rw", encoding="latin-1")

    def connect(self, path, process):
        if process.poll() is not None:
            raise ConnectionError(f"QEMU ended with {process.returncode}")
        try:
            self.socket.connect(str(path))
            return True
        except OSError:
            return False

    def say(self, request):
        self.words.write(json.dumps(request) + "\n")
        self.words.flush()

    def hear(self, patience=PATIENCE):
        self.socket.settimeout(patience)
        line = self.words.readline()
        if not line:
            raise ConnectionError("the machine has hung up")
        return json.loads(line.lstrip("\xff"))

    def ask(self, name, **arguments):
        self.say({"execute": name, "arguments": arguments})
        while "return" not in (answer := self.hear()):
            if "error" in answer:
                raise RuntimeError(f"{name} {arguments}: {answer['error'].get('desc')}")
        return answer["return"]

    def close(self):
        self.words.close()
        self.socket.close()


class Machine:
    """Runs from the constructor, where a snapshot is named from there, to stop(); one at a time."""

    running = None  # QEMU's process

    def __init__(self, image, disk, snapshot=None):
        """image: what image.ensure() gave; disk: a qcow2 over its base.raw."""
        self.image = image
        self.folder = Path(tempfile.mkdtemp(prefix="vitrine-rig-"))  # a socket's path must be short
        self.share = self.folder / "share"  # the guest's /host, where mounted
        self.share.mkdir()
        self.journal = self.folder / "journal.log"
        self.bus = f"unix:path={self.folder / 'bus'}"
        self.agent = None
        self.children = [start_bus(self.folder / "bus", SERVING, start_new_session=True, stderr=subprocess.DEVNULL)]
        self.qemu = self.start(*self.command(image, disk), *(["-loadvm", snapshot] if snapshot else []))
        Machine.running = self.qemu.pid
        self.qmp = Door(self.folder / "qmp", self.qemu)
        self.qmp.hear()
        self.qmp.ask("qmp_capabilities")
        self.panel(WIDTH, HEIGHT)  # as it is; QEMU passes over what it was told last, and to begin with that is no panel

    def start(self, *command):
        child = subprocess.Popen([*SERVING, *map(str, command)], start_new_session=True, stdin=subprocess.DEVNULL,
                                 stdout=(self.folder / f"{command[0]}.log").open("w"), stderr=subprocess.STDOUT)
        self.children.append(child)
        return child

    def command(self, image, disk):
        return [
            "qemu-system-x86_64", "-machine", "q35,usb=off", "-accel", "tcg,thread=multi", "-cpu", "Nehalem", "-smp", "2",
            "-m", "2048", "-nodefaults", "-no-user-config", "-vga", "none", "-display", f"dbus,addr={self.bus}",
            "-device", f"virtio-gpu-pci,id=gpu0,max_outputs=2,xres={WIDTH},yres={HEIGHT}",
            "-kernel", image / "vmlinuz", "-initrd", image / "initrd",
            "-append", "root=/dev/vda rw console=ttyS0 quiet mitigations=off",
            "-drive", f"file={disk},if=none,id=d0,format=qcow2,cache=unsafe,discard=unmap", "-device", "virtio-blk-pci,drive=d0",
            "-device", "pcie-root-port,id=port0,chassis=1", "-device", "virtio-rng-pci", "-device", "virtio-serial-pci",
            "-chardev", f"socket,id=agent,path={self.folder / 'agent'},server=on,wait=off",
            "-device", "virtserialport,chardev=agent,name=org.qemu.guest_agent.0",
            "-chardev", f"file,id=journal,path={self.journal}", "-device", f"virtserialport,chardev=journal,name={JOURNAL_PORT}",
            "-virtfs", f"local,path={self.share},mount_tag=host,security_model=none,id=fs0",
            "-serial", f"file:{self.folder / 'serial.log'}", "-qmp", f"unix:{self.folder / 'qmp'},server=on,wait=off"]

    def stop(self):
        for child in reversed(self.children):
            child.terminate()
            child.wait(60)
        shutil.rmtree(self.folder, ignore_errors=True)

    # -- the guest

    def greet(self):
        """Until the guest's agent answers; it is not there before the guest has booted."""
        self.agent = Door(self.folder / "agent", self.qemu)

        def answers():
            token = time.monotonic_ns() % 2**31
            self.agent.say({"execute": "guest-sync", "arguments": {"id": token}})
            try:
                while self.agent.hear(5).get("return") != token:
                    pass
                return True
            except TimeoutError:
                self.agent.close()
                self.agent = Door(self.folder / "agent", self.qemu)
                return False

        wait_for("the guest's agent", answers)

    def sh(self, script, patience=PATIENCE, fails=False):
        """What a shell script in the guest says. Raises AssertionError where it fails, unless it may."""
        if not self.agent:
            self.greet()
        job = self.agent.ask("guest-exec", path="/bin/sh", arg=["-c", script], **{"capture-output": True})["pid"]
        ended = lambda: (state := self.agent.ask("guest-exec-status", pid=job))["exited"] and state
        state = wait_for(f"the guest to do: {script}", ended, patience, 0.1)
        said = [base64.b64decode(state.get(name, "")).decode(errors="replace") for name in ("out-data", "err-data")]
        if state.get("exitcode", 1) != 0 and not fails:
            raise AssertionError(f"in the guest: {script}\n{said[0]}{said[1]}")
        return said[0].strip()

    def mount_share(self):
        self.sh("mount -t 9p -o trans=virtio,version=9p2000.L,msize=262144 host /host")

    def unmount_share(self):
        self.sh("umount /host")

    # -- what stands around it

    def add_logged_disk(self, disk, log):
        """Plugs in a raw disk whose writes are kept (write_log.py); the machine can be cut off from then on."""
        log.write_bytes(b"")
        file = {"driver": "file", "filename": str(disk), "cache": {"no-flush": True}}
        self.qmp.ask("blockdev-add", **{"driver": "blklogwrites", "node-name": "logged", "log-sector-size": 512, "log-super-update-interval": 1,
                                        "file": file, "log": {"driver": "file", "filename": str(log), "cache": {"no-flush": True}}})
        self.qmp.ask("device_add", driver="virtio-blk-pci", bus="port0", drive="logged", id="logged", **{"write-cache": "on"})

    def said(self):
        """What the machine has said on its console."""
        return (self.folder / "serial.log").read_text(errors="replace")

    def cut(self):
        """The power, at once; what the machine had said on its console."""
        self.qemu.kill()
        self.qemu.wait()
        said = self.said()
        self.stop()
        return said

    def save(self, name):
        self.qmp_monitor(f"savevm {name}")

    def reset(self):
        """Boots anew."""
        self.qmp.ask("system_reset")
        self.agent.close()
        self.agent = None

    def qmp_monitor(self, line):
        said = self.qmp.ask("human-monitor-command", **{"command-line": line})
        if said.strip():
            raise RuntimeError(f"{line}: {said.strip()}")

    def panel(self, width, height, head=0):
        """Puts a panel of this size on an output; 0 x 0 takes it off."""
        command = ["gdbus", "call", "--address", self.bus, "--dest", "org.qemu",
                   "--object-path", f"/org/qemu/Display1/Console_{head}", "--method", f"{CONSOLE}.SetUIInfo",
                   *map(str, (width * 254 // 1000, height * 254 // 1000, 0, 0, width, height))]
        complaint = ""

        def is_set():
            nonlocal complaint
            said = subprocess.run(command, capture_output=True, text=True, check=False, timeout=PATIENCE)
            complaint = said.stderr.strip()
            return said.returncode == 0

        try:
            wait_for("QEMU's display on the bus", is_set, 60)  # on a busy machine QEMU answers QMP before it has its name there
        except AssertionError as error:
            raise AssertionError(f"{error}: {complaint}") from error

    def picture(self, head=0):
        """What is scanned out to an output's panel."""
        path = self.folder / f"head{head}.ppm"
        self.qmp.ask("screendump", filename=str(path), device="gpu0", head=head)
        return Picture.read(path)
