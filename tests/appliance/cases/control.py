"""vitrinectl on the system bus with polkit: anyone may ask, only the group may change; what hangs is restarted."""
import json
import subprocess

from machine import wait_for

NOT_ALLOWED = 3


def ctl(box, words, user=None):
    """(exit status, words) of vitrinectl, as root or as somebody else."""
    command = f"vitrinectl {words}"
    if user:
        command = f"runuser -u {user} -- {command}"
    said = box.sh(f"{command} 2>&1; echo $?")
    *lines, status = said.splitlines()
    return int(status), "\n".join(lines)


def status(box):
    return json.loads(ctl(box, "status --json")[1])


def files(box):
    """Those on the wall; none while the player is not there."""
    code, words = ctl(box, "status --json")
    return sorted(cell["file"] for cell in json.loads(words)["cells"]) if code == 0 else []


def run(box):
    box.sh("useradd -m guest; useradd -m -G vitrine-admin keeper")
    box.set_watchdog(30)
    box.restart(layout__slots=3, show__dwell_seconds=3600, show__order="name", output__frame_rate=1)  # which leaves time for others
    first = wait_for("three files on the wall", lambda: len(files(box)) == 3 and files(box))

    said = status(box)
    assert said["state"] == "showing" and said["outputs"][0]["name"] == "Virtual-1", said
    assert "Virtual-1 640x360" in box.sh("systemctl show -p StatusText --value vitrine-player")
    assert ctl(box, "why red.png", "guest")[0] == 0
    assert ctl(box, "why nothing.png", "guest")[0] == 2

    # What it says is scanned out is what is scanned out. Nothing moves but the film; paused or not it plays on.
    box.sh("rm -f /tmp/shot*; runuser -u guest -- vitrinectl screenshot /tmp/shot.png")
    assert box.sh("od -An -tx1 -N4 /tmp/shot.png").split() == ["89", "50", "4e", "47"]
    box.machine.mount_share()
    box.sh("cp /tmp/shot.png /host/; umount /host")
    compare(box)

    # Who may not is refused; who may changes the wall.
    for change in ("next", "remove red.png"):  # bus_object_test has all
        assert ctl(box, change, "guest")[0] == NOT_ALLOWED, change
    assert files(box) == first
    code, words = ctl(box, "next", "keeper")
    assert code == 0, words
    wait_for("another wall", lambda: len(files(box)) == 3 and files(box) != first)

    # What hangs is restarted by systemd, and comes back by itself.
    pid = box.pid()
    box.sh("systemctl kill -s STOP vitrine-player")
    wait_for("the watchdog", lambda: box.sh("systemctl show -p MainPID --value vitrine-player") not in ("0", str(pid)))
    wait_for("the wall after the watchdog", lambda: status_or_none(box) == "showing")
    assert any("Watchdog timeout" in line for _, line in box.journal()), "it was the watchdog"


def status_or_none(box):
    code, words = ctl(box, "status --json")
    return json.loads(words)["state"] if code == 0 else None


def compare(box):
    """The still parts of vitrinectl's picture are those of the panel's scan-out."""
    shot = box.machine.share / "shot.png"
    raw = subprocess.run(["ffmpeg", "-v", "error", "-i", str(shot), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"], check=True,
                         capture_output=True).stdout
    panel = box.look("the panel beside the screenshot")
    assert len(raw) == len(panel.pixels), "the screenshot has the panel's size"
    same = sum(raw[i:i + 3] == panel.pixels[i:i + 3] for i in range(0, len(raw), 3)) / (len(raw) / 3)
    print(f"{same:.1%} of the screenshot's pixels are the panel's")
    assert same > 0.8, "the screenshot is not what the panel shows"
