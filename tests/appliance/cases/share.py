"""Operators overwrite, cut off and unmount what is being played: the wall goes on with what it had."""
from appliance import MEDIA
from image import NotHere

FILM = f"{MEDIA}/magenta.mp4"


def run(box):
    if "unstored" in box.sh("ls /var/lib/vitrine/store 2>/dev/null || echo unstored"):
        raise NotHere("this tree keeps no copies of what it plays")
    pid = box.pid()
    # The folder becomes a mount of its own, as a share is, with the same files.
    box.sh(f"systemctl stop vitrine-analyzer; mkdir /run/kept; mv {MEDIA}/* /run/kept; mount -t tmpfs media {MEDIA}; "
           f"chown vitrine:vitrine {MEDIA}; cp -a /run/kept/. {MEDIA}")

    # Without the analyzer, which would look at the new content and show that: what plays now has to play on.
    box.sh(f"dd if=/dev/urandom of={FILM} bs=1k count=3 conv=notrunc")
    still_plays(box, "while its film is overwritten")
    box.sh(f"truncate -s 100 {FILM}; truncate -s 10 {MEDIA}/red.png")
    still_plays(box, "while its files are cut off")
    box.sh(f"cp -a /run/kept/. {MEDIA}; systemctl start vitrine-analyzer; sleep 5; umount -l {MEDIA}; sleep 20")
    still_plays(box, "after the share has gone")
    assert box.pid() == pid, "it is the same process"


def still_plays(box, when):
    box.sh("sleep 8")  # several loops of the film
    picture = box.look(f"the wall {when}")
    assert not box.lacking(picture), f"{when} the wall lacks {box.lacking(picture)}"
    box.wait_for_motion(f"the film to move {when}")
