"""`vitrinectl wall` on one box: its services run as systemd starts them, with Debian's daemons, as leader and as follower.

The machine has no network, so the box leads itself alone, and as a follower it finds no leader.
"""
import re
import subprocess

import image
from machine import wait_for

DAEMONS = ["mosquitto", "chrony", "rsync", "avahi-daemon", "avahi-utils", "libmosquitto1"]
LEADS = "mosquitto chrony vitrine-link vitrine-wall-share vitrine-player vitrine-analyzer"
FOLLOWS = "chrony vitrine-link vitrine-wall-fetch.path vitrine-wall-fetch.timer vitrine-player"
WRITTEN = ["/etc/vitrine/wall", "/etc/mosquitto/conf.d/vitrine-wall.conf", "/etc/chrony/conf.d/vitrine-wall.conf",
           "/etc/avahi/services/vitrine-wall.service", "/etc/systemd/system/vitrine-analyzer.service.d/vitrine-wall.conf"]


def bring_daemons(box):
    """Installs Debian's daemons, and of what they need what the machine lacks."""
    folder = box.machine.share / "daemons"
    folder.mkdir()
    (folder / "status").write_text(box.sh("cat /var/lib/dpkg/status"))
    try:
        lacking = image.run("apt-get", "-o", f"Dir::State::status={folder / 'status'}", "-o", "Debug::NoLocking=1", "--no-install-recommends",
                            "--simulate", "install", *DAEMONS)
        image.run("apt-get", "download", *(line.split()[1] for line in lacking.splitlines() if line.startswith("Inst ")), cwd=folder)
    except subprocess.CalledProcessError as error:
        raise image.NotHere(f"Debian's daemons cannot be had: {error.stderr[-1000:]}") from error
    box.machine.mount_share()
    box.sh("ip link set lo up; DEBIAN_FRONTEND=noninteractive dpkg --force-depends -i /host/daemons/*.deb </dev/null; umount /host")


def wait_until_up(box, units):
    wait_for(f"{units} to be up", lambda: set(box.sh(f"systemctl is-active {units}", fails=True).split()) == {"active"})


def wait_for_status(box, *words):
    """Until `vitrinectl status` tells all of this; what it tells."""
    told = ""

    def tells():
        nonlocal told
        told = box.sh("vitrinectl status", fails=True)
        return all(word in told for word in words)

    try:
        wait_for(f"a status that tells {words}", tells, pause=2)
    finally:
        print(told)
    return told


def lead(box):
    said = box.sh("vitrinectl wall lead lobby --net 127.0.0.0/8")
    assert "this box leads the wall 'lobby'" in said, said
    wait_until_up(box, LEADS)
    wait_for_status(box, "'lobby'", "; connected", "leads")
    assert "active" in box.sh("vitrinectl wall status")
    box.wait_for_wall("the wall of a box that leads")
    # What a follower fetches, by its own secret and without it.
    box.sh("cut -d: -f2 /etc/vitrine/wall/share.secret >/run/secret; chmod 600 /run/secret")
    got = box.sh("rsync --password-file=/run/secret rsync://vitrine@127.0.0.1:8730/catalogue/")
    assert ".json" in got, got
    refused = box.sh("RSYNC_PASSWORD=wrong rsync rsync://vitrine@127.0.0.1:8730/catalogue/ 2>&1", fails=True)
    assert "auth failed" in refused, refused


def leave(box):
    said = box.sh("cp /etc/vitrine/wall.key /run/wall.key; vitrinectl wall leave")
    assert "has left the wall" in said, said
    left = box.sh(f"ls -d {' '.join(WRITTEN)} 2>/dev/null; grep -l 8883 /etc/chrony/chrony.keys 2>/dev/null", fails=True).split()
    assert not left, f"leaving leaves {left}"
    wait_until_up(box, "vitrine-player vitrine-analyzer")
    box.wait_for_wall("the wall of a box that has left")


def follow(box):
    box.sh("echo '127.0.0.1 hall-1' >>/etc/hosts")  # a name is looked up inside the sandbox of the service
    said = box.sh("vitrinectl wall join lobby /run/wall.key hall-1")
    assert "this box follows 'hall-1'" in said, said
    wait_until_up(box, FOLLOWS)
    assert box.sh("systemctl is-active vitrine-analyzer", fails=True) == "inactive", "a follower's own media rest"
    told = wait_for_status(box, "'lobby'", "follows", "no connection to 'hall-1'", "cannot fetch files: rsync")
    assert "Lookup" not in told, "the name of the leader is not found"


def run(box):
    bring_daemons(box)
    try:
        for part in (lead, leave, follow):
            part(box)
    except AssertionError:
        print(box.sh("journalctl -b -q -u vitrine-link -u vitrine-wall-share -u mosquitto -u chrony -n 60 --no-hostname", fails=True))
        raise
    # Only the fetching may have failed: there is no leader, and the timer tries again.
    failed = set(re.findall(r"\S+\.(?:service|path|timer|socket)", box.sh("systemctl --failed --no-legend", fails=True)))
    assert failed <= {"vitrine-wall-fetch.service"}, failed
