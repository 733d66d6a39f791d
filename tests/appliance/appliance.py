"""The appliance in the machine: both programs as their services, a media folder of known colours, and what is asked of it."""
import os
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

from image import key, run
from machine import HEIGHT, JOURNAL_PORT, WIDTH, Machine, wait_for

MEDIA = "/srv/vitrine/media"
STILLS = {"red": (220, 30, 30), "green": (30, 170, 50), "blue": (40, 60, 220)}
FILM = {"magenta": (200, 40, 200)}
COLOURS = STILLS | FILM
MIN_SHARE = 0.01  # of the screen that each file's colour covers; a fair part would be 0.2
MAX_BLACK = 0.05  # of the screen; the wall leaves none
# An emulated machine is twenty times slower: little is analysed, and few pictures a second are drawn.
SETTINGS = {
    "log.level": "debug", "layout.slots": len(COLOURS), "output.frame_rate": 1, "show.motion_milliseconds": 0,
    "analyzer.children": 2, "analyzer.deadline_seconds": 600, "analyzer.frame_size": 96, "analyzer.samples_per_second": 2,
    "analyzer.face_model": "", "analyzer.saliency": "plain", "analyzer.face_cascade": "", "tapestry.max_bytes": 0}
EDITABLE = "/etc/vitrine/vitrine.toml"


UPPER, LOWER = (0, 220, 220), (240, 220, 0)  # the halves of the red photo's box


def draw_media(folder):
    """A box on one saturated colour each: the box is what matters, the colour tells the file.

    The rig draws a picture a second. A film of a whole number of seconds would show the same moment in each.
    """
    for name, rgb in COLOURS.items():
        colour = f"color=0x{bytes(rgb).hex()}:size=320x180:rate=10"
        if name in STILLS:
            upper, lower = (UPPER, LOWER) if name == "red" else ((255, 255, 255),) * 2
            boxes = [f"drawbox=120:{y}:80:40:0x{bytes(half).hex()}:fill" for y, half in ((50, upper), (90, lower))]
            run("ffmpeg", "-v", "error", "-y", "-f", "lavfi", "-i", ",".join([colour, *boxes]),
                "-frames:v", 1, folder / f"{name}.png")
        else:
            run("ffmpeg", "-v", "error", "-y", "-f", "lavfi", "-i", colour, "-f", "lavfi", "-i", "color=white:size=60x60:rate=10",
                "-filter_complex", "overlay=x=20+160*t:y=60", "-t", 1.3, "-pix_fmt", "yuv420p", "-c:v", "libx264",
                folder / f"{name}.mp4")


def toml(settings):
    """{"a.b": 1} as the file of settings that an operator writes."""
    sections = {}
    for name, value in settings.items():
        section, name = name.split(".")
        word = {True: "true", False: "false"}.get(value) if isinstance(value, bool) else None
        sections.setdefault(section, []).append(f"{name} = {word or (value if isinstance(value, (int, float)) else chr(34) + value + chr(34))}")
    return "\n".join(f"[{section}]\n" + "\n".join(lines) for section, lines in sections.items()) + "\n"


def booted(image):
    """A disk over the image with the snapshot `booted`; kept beside the image, for the QEMU and machine of today."""
    version = run("qemu-system-x86_64", "--version").splitlines()[0]
    disk = image / f"booted-{key(version, Machine.command.__code__.co_consts)}.qcow2"
    if disk.exists():
        return disk
    handle, making = tempfile.mkstemp(dir=image, prefix="making-")
    os.close(handle)
    try:
        run("qemu-img", "create", "-q", "-f", "qcow2", "-F", "raw", "-b", image / "base.raw", making)
        machine = Machine(image, making)
        try:
            print("booted:", machine.sh("systemctl is-system-running --wait; systemctl --failed --no-legend; uname -r", fails=True))
            machine.save("booted")
        finally:
            machine.stop()
        Path(making).rename(disk)
    finally:
        Path(making).unlink(missing_ok=True)
    return disk


class Appliance:
    """What cases speak to: the machine, and the player's service in it."""

    UPPER, LOWER = UPPER, LOWER

    def __init__(self, machine, pictures):
        self.machine, self.sh, self.pictures, self.kept = machine, machine.sh, Path(pictures), 0

    # -- making it

    def install(self, build):
        """Puts what `cmake --install` of a build gives, settings and media in place and starts both services."""
        stage = self.machine.share / "stage"
        run("cmake", "--install", build, "--strip", env=os.environ | {"DESTDIR": str(stage)})
        media = self.machine.share / "media"
        media.mkdir()
        draw_media(media)
        self.machine.mount_share()
        self.sh("cp -a --no-preserve=ownership /host/stage/. / && systemd-sysusers && systemd-tmpfiles --create vitrine.conf && systemctl reload dbus")
        self.sh(f"install -o vitrine -g vitrine -m 664 /host/media/* {MEDIA}; umount /host")
        for unit in ("vitrine-analyzer", "vitrine-player"):  # on a busy host minutes pass in the machine
            folder = f"/run/systemd/system/{unit}.service.d"
            self.sh(f"mkdir -p {folder}; printf '[Service]\\nTimeoutStartSec=infinity\\nTimeoutStopSec=600\\nWatchdogSec=600\\n' >{folder}/rig.conf")
        self.sh("systemctl daemon-reload")
        # What the player says comes to this host as it is said: asking for it costs seconds of the emulated machine.
        self.sh(f"systemd-run -q --unit=rig-journal sh -c 'exec journalctl -f -q -n 0 -t vitrine-player -o short-monotonic --no-hostname "
                f">/dev/virtio-ports/{JOURNAL_PORT}'")
        self.set()
        self.sh("systemctl start vitrine-analyzer")
        self.wait_until_analysed()
        self.sh("systemctl start vitrine-player")
        self.wait_for_wall("the wall after the first start")

    def wait_until_analysed(self):
        records = "ls /var/lib/vitrine/catalogue/*.json 2>/dev/null | wc -l"
        wait_for("a record of each file", lambda: int(self.sh(records)) >= len(COLOURS), 900, 1)

    def run_test(self, name, words):
        """Runs a test program of the build in the machine, as the player's user; what it says."""
        shutil.copy(self.pictures.parent / "build/tests/appliance" / name, self.machine.share)
        self.machine.mount_share()
        self.sh(f"install -m 755 /host/{name} /tmp; umount /host")
        return self.sh(f"setpriv --reuid vitrine --regid vitrine --groups video,render /tmp/{name} {words}")

    # -- the player

    def set(self, **changes):
        """The settings: the rig's own and these, written output__mode="640x480"."""
        changes = {name.replace("__", "."): value for name, value in changes.items()}
        text = toml(SETTINGS | changes)
        self.sh(f"mkdir -p /etc/vitrine; cat >{EDITABLE} <<'END'\n{text}END")

    def set_watchdog(self, seconds):
        """How long the player may be without a picture; holds from its next start on."""
        folder = "/etc/systemd/system/vitrine-player.service.d"
        self.sh(f"mkdir -p {folder}; printf '[Service]\\nWatchdogSec={seconds}\\n' >{folder}/rig.conf; systemctl daemon-reload")

    def restart(self, **changes):
        """With a panel; until the new process has a picture, for until then there is the old one's."""
        self.set(**changes)
        pid = int(self.sh("systemctl restart vitrine-player; systemctl show -p MainPID --value vitrine-player"))
        self.wait_for_word("first picture on", pid=pid)

    def pid(self):
        pid = int(self.sh("systemctl show -p MainPID --value vitrine-player"))
        assert pid > 0, "the player is not running"
        return pid

    def journal(self, unit="vitrine-player", since=0.0, pid=None):
        """What a unit, or one process of it, last said, from a moment of the guest's monotonic clock on: [(seconds, words)]."""
        whose = f"-u {unit}" + (f" _PID={pid}" if pid else "")
        lines = self.sh(f"journalctl -b -q {whose} -o short-monotonic --no-hostname -n 200").splitlines()
        found = [re.match(r"\[\s*([\d.]+)\] [^:]+: (.*)", line) for line in lines]
        return [(float(line[1]), line[2]) for line in found if line and float(line[1]) >= since]

    def now(self):
        """The guest's monotonic clock, in seconds."""
        return float(self.sh("cut -d' ' -f1 /proc/uptime"))

    def words(self, since, pid):
        """What the player has said, as journal() gives it; without a question to the guest, where its lines come by themselves."""
        told = self.machine.journal.read_text(errors="replace") if self.machine.journal.exists() else ""
        if not told:
            return self.journal(since=since, pid=pid)
        found = re.finditer(r"^\[\s*([\d.]+)\] [^\[]+\[(\d+)\]: (.*)\n", told, re.MULTILINE)
        return [(float(at), line) for at, teller, line in (one.groups() for one in found)
                if float(at) >= since and pid in (None, int(teller))]

    def wait_for_word(self, pattern, since=0.0, pid=None):
        """Until the player's journal, from a moment on or of one process, has a line with a pattern; the match."""
        def said():
            return next((found for _, line in self.words(since, pid) if (found := re.search(pattern, line))), None)

        return wait_for(f"the player to say '{pattern}'", said)

    def wait_until_active(self, unit):
        wait_for(f"{unit} to be up", lambda: self.sh(f"systemctl is-active {unit}", fails=True) == "active")

    def reboot(self):
        """With power to spare: the guest's disk is in order, as after `reboot`."""
        self.sh("sync; echo u >/proc/sysrq-trigger")
        self.machine.reset()

    # -- the panel

    def panel(self, width=WIDTH, height=HEIGHT, head=0):
        self.machine.panel(width, height, head)

    def unplug(self, head=0):
        self.machine.panel(0, 0, head)

    def pull(self):
        """Takes the only panel off, until the player knows.

        It hears of another panel first: the kernel tells of a change when it has the new description of what is plugged
        in, of nothing in this case, and only then learns that nothing is plugged in.
        """
        begin = self.now()
        self.unplug()
        self.wait_for_word("screen: no panel", begin)

    def look(self, name, head=0):
        """The scan-out; kept as a PNG for whoever wants to see it."""
        picture = self.machine.picture(head)
        self.kept += 1
        picture.save(self.pictures / f"{self.kept:02}-{name.replace(' ', '-')}.png")
        return picture

    def files_in(self, picture):
        return {name for name, colour in COLOURS.items() if picture.share_of(colour) >= MIN_SHARE}

    def lacking(self, picture, files=COLOURS):
        """Those files that a picture is without; and where it does not fill the panel, "a full panel"."""
        return sorted(set(files) - self.files_in(picture)) + ["a full panel"] * (picture.share_of((0, 0, 0), 8) > MAX_BLACK)

    def wait_for_wall(self, what, head=0, size=None, part=None, keeps=True, files=COLOURS):
        """Until the wall with these files fills a panel, of this size where one is given, or a part of it; the picture.

        part: left, top, right and bottom, in px
        """
        def shown():
            self.last = self.machine.picture(head)
            if size is not None and self.last.size != size:
                return False
            return not self.lacking(self.last.part(*part) if part else self.last, files)

        try:
            wait_for(what, shown)
        finally:
            if keeps:
                self.look(what, head)
        return self.last

    def wait_for_motion(self, what, head=0):
        """Until the film's white box is seen at another place."""
        first = self.machine.picture(head).pixels
        wait_for(what, lambda: self.machine.picture(head).pixels != first)
