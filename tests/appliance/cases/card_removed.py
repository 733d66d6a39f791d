"""The graphics card itself goes and comes back, as with a driver that is restarted or a dock that is pulled."""

CARD = "readlink -f /sys/class/drm/card0/device"


def run(box):
    pid = box.pid()
    device = box.sh(f"d=$({CARD}); while [ ! -e $d/vendor ] || [ ! -e $d/remove ]; do d=${{d%/*}}; done; echo $d")

    box.sh(f"echo 1 >{device}/remove; sleep 5; test ! -e /dev/dri/card0")
    assert box.pid() == pid, "the player ended with its card"
    back = box.now()
    box.sh("echo 1 >/sys/bus/pci/rescan")

    box.wait_for_word("first picture on", back)
    shown = next(at for at, line in box.words(back, None) if "first picture on" in line)
    print(f"{shown - back:.1f} s from the card to its first picture")
    box.wait_for_wall("the wall on the card that came back")
    box.wait_for_motion("the film to move there")
    assert box.pid() == pid, "it is the same process"
