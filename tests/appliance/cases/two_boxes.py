"""Two boxes with a network between them become one wall, as docs/wall.md tells it: systemd and Debian's daemons in both.

The machines are emulated: states are asserted here and no times.
"""
import re
import shutil
import subprocess
from pathlib import Path

import image
from appliance import COLOURS, EDITABLE, MEDIA, Appliance
from cases.boxes import FOLLOWS, LEADS, bring_daemons, wait_for_status, wait_until_up
from cases.touch import Panel, at
from machine import Machine, wait_for
from rig import SNAPSHOT

MODULES = ("net/core/failover.ko", "drivers/net/net_failover.ko", "drivers/net/virtio_net.ko")
ADDRESSES = {"hall-1": "10.78.0.1", "hall-2": "10.78.0.2"}
SEEN = ("red", "blue", "magenta")  # the files of the leader's wall: one less than a box has by itself


def network_modules(box):
    """A folder with the modules of the guest's kernel that drive its network; the guest is made without them."""
    folder = box.machine.share / "modules"
    folder.mkdir()
    release = box.sh("uname -r")
    try:
        image.run("apt-get", "download", f"linux-image-{release}", cwd=folder)
        package = next(folder.glob("*.deb"))
        members = [f"./lib/modules/{release}/kernel/{name}" for name in MODULES]
        tar = subprocess.run(["dpkg-deb", "--fsys-tarfile", package], check=True, capture_output=True).stdout
        subprocess.run(["tar", "-x", "-C", folder, "--strip-components=4", *members], input=tar, check=True, capture_output=True)
        package.unlink()
    except subprocess.CalledProcessError as error:
        raise image.NotHere(f"the guest's kernel {release} cannot be had: {error.stderr[-1000:]}") from error
    return folder


def plug_in(box, cable, listens):
    """Plugs in a network card with a cable between the two machines."""
    where = {"type": "unix", "path": str(cable)}
    box.machine.qmp.ask("netdev_add", type="stream", id="cable", server=listens, addr=where)
    box.machine.qmp.ask("device_add", driver="virtio-net-pci", id="card", netdev="cable", bus="port0",
                        mac=f"52:54:00:78:00:0{1 if listens else 2}")


def name_and_connect(box, name, modules):
    """Gives a box its name and its address."""
    if not (box.machine.share / "modules").exists():
        shutil.copytree(modules, box.machine.share / "modules")
    box.machine.mount_share()
    for module in MODULES:
        box.sh(f"insmod /host/modules/kernel/{module} || lsmod | grep -q {Path(module).stem}")
    box.machine.unmount_share()
    card = wait_for("a network card", lambda: box.sh("ls /sys/class/net | grep -v '^lo$'", fails=True))
    box.sh(f"hostname {name}; echo {name} >/etc/hostname; echo '127.0.0.1 {name}' >>/etc/hosts; systemctl try-restart avahi-daemon")
    box.sh(f"ip link set lo up; ip address add {ADDRESSES[name]}/24 dev {card}; ip link set {card} up")
    return card


def lead(box):
    said = box.sh(f"rm {MEDIA}/green.png; vitrinectl wall lead lobby")
    assert "this box leads the wall 'lobby'" in said, said
    wait_until_up(box, LEADS)
    box.wait_for_wall("the leader's wall", files=SEEN)
    return box.sh("cat /etc/vitrine/wall.key")


def follow(box, key):
    """Finds the leader in the network and shows its wall, with no file of its own."""
    box.sh(f"rm -f {MEDIA}/*; echo {key} >/run/wall.key")
    wait_for("an empty wall", lambda: not box.files_in(box.machine.picture()))
    said = wait_for("an answer of the leader", lambda: box.sh("vitrinectl wall join lobby /run/wall.key", fails=True))
    assert f"this box follows '{ADDRESSES['hall-1']}'" in said, said
    wait_until_up(box, FOLLOWS)
    box.wait_for_wall("the follower's wall", files=SEEN)


def agree(boxes):
    """Both tell that the follower is in step, and the follower has its time from the leader."""
    for box in boxes:
        wait_for_status(box, "'lobby'", "hall-1   leads", "hall-2   follows, in step")
    tracking = boxes[1].sh("chronyc -n tracking; chronyc -n sources")
    assert f"({ADDRESSES['hall-1']})" in tracking and "Leap status     : Normal" in tracking, tracking
    assert re.search(rf"\^\* {re.escape(ADDRESSES['hall-1'])}", tracking), tracking


def wait_for_both(boxes, what, is_right):
    """Until the panel of each box has shown a picture that is right; they are looked at in turn."""
    missing = list(boxes)

    def have_shown():
        missing[:] = [box for box in missing if not is_right(box, box.machine.picture())]
        return not missing

    wait_for(what, have_shown)
    for box in boxes:
        box.look(what)


def touch_the_follower(boxes):
    """A visitor touches the follower: a photo is large on both boxes, then a film's tapestry is open on both."""
    leader, follower = boxes
    panel = Panel(follower)
    tapped = ["rest 0.1", "0 up"]

    def place_of(name):
        return at(0, follower.wait_for_wall("the wall before a touch", files=SEEN).middle_of(COLOURS[name]))

    photo = place_of("red")
    panel.touch(photo, *tapped)
    wait_for_both(boxes, "a photo that was tapped on the follower", lambda _, picture: picture.share_of(COLOURS["red"]) > 0.6)
    panel.touch(photo, *tapped)
    wait_for_both(boxes, "the wall after the second tap", lambda box, picture: not box.lacking(picture, SEEN))

    leader.sh(f"sed -i '/^.tapestry/,$ s/^max_bytes = 0/max_bytes = 1000000000/' {EDITABLE}; systemctl restart vitrine-analyzer")
    for box in boxes:
        wait_for("a tapestry in each box", lambda box=box: box.sh("ls /var/lib/vitrine/tapestry/*/index.json", fails=True))
    film = place_of("magenta")
    panel.touch(film, *tapped, film, *tapped)

    def is_tapestry(box, picture):
        """The film above its strip, before the idle picture; a film that was tapped once fills the panel."""
        return box.files_in(picture) == {"magenta"} and picture.share_of(COLOURS["magenta"]) < 0.6

    wait_for_both(boxes, "a tapestry that was opened on the follower", is_tapestry)
    follower.sh("systemctl stop rig-panel")
    wait_for_both(boxes, "the wall once nobody touches the tapestry", lambda box, picture: not box.lacking(picture, SEEN))


def lose_and_find_the_time(boxes):
    """The follower's chrony loses the time: all tell it, and the wall goes on by a clock of its own. Then it is found again."""
    follower = boxes[1]
    follower.sh("chronyc offline && chronyc reset sources")
    for box in boxes:
        wait_for_status(box, "by its own clock: nobody keeps the system's right")
    tracking = follower.sh("chronyc -n tracking")
    assert "Leap status     : Not synchronised" in tracking, tracking
    assert not follower.lacking(follower.look("by its own clock"), SEEN)
    follower.wait_for_motion("a film by its own clock")
    follower.sh("chronyc online")
    agree(boxes)


def cut_and_heal(boxes, card):
    leader, follower = boxes
    follower.sh(f"ip link set {card} down")
    wait_for_status(follower, "no connection")
    assert not follower.lacking(follower.look("without a network"), SEEN)
    follower.wait_for_motion("a film without a network")
    leader.sh(f"rm {MEDIA}/blue.png")
    leader.wait_for_wall("the leader's wall while the other is gone", files=("red", "magenta"))
    follower.sh(f"ip link set {card} up; ip address replace {ADDRESSES['hall-2']}/24 dev {card}")
    wait_for("the leader's change", lambda: follower.files_in(follower.machine.picture()) == {"red", "magenta"})
    follower.look("with a network again")


def lead_without_a_panel(boxes):
    """The leader's panel is pulled out: a change of its folder is seen on the other box, and on the panel when it is back."""
    leader, follower = boxes
    leader.pull()
    leader.sh(f"rm {MEDIA}/magenta.mp4")
    wait_for("the change of a leader without a panel", lambda: follower.files_in(follower.machine.picture()) == {"red"})
    leader.panel()
    leader.wait_for_wall("the leader's wall on its panel again", files=("red",))


def run(box):
    disk = box.pictures.parent / "two_boxes_other.qcow2"
    shutil.copy(box.pictures.parent / "prepared.qcow2", disk)
    machine = Machine(box.machine.image, disk, SNAPSHOT)
    other = Appliance(machine, box.pictures / "hall-2")
    other.pictures.mkdir()
    boxes = (box, other)
    try:
        cable = box.machine.folder / "cable"
        modules = network_modules(box)
        for one, name in zip(boxes, ADDRESSES):
            bring_daemons(one)
            plug_in(one, cable, name == "hall-1")
            card = name_and_connect(one, name, modules)
        key = lead(box)
        follow(other, key)
        agree(boxes)
        touch_the_follower(boxes)
        lose_and_find_the_time(boxes)
        cut_and_heal(boxes, card)
        agree(boxes)
        lead_without_a_panel(boxes)
        agree(boxes)
    except AssertionError:
        for one in boxes:
            print(one.sh("journalctl -b -q -u vitrine-link -u vitrine-wall-fetch -u vitrine-wall-share -u mosquitto -u chrony -n 60 --no-hostname", fails=True))
        raise
    finally:
        machine.stop()
        disk.unlink()
