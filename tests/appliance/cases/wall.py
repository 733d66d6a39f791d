"""The wall is on the panel that was there at the start, it moves, and the player is a service without privileges."""

RATE = 1  # pictures a second, of the rig's settings


def pictures_shown(box):
    """How many, as the service's status tells every 5 s."""
    return int(box.sh("systemctl show -p StatusText --value vitrine-player | grep -o '[0-9]* pictures shown' | cut -d' ' -f1"))


def run(box):
    pid = box.pid()

    box.wait_for_wall("the wall", size=(640, 360))
    box.wait_for_motion("the film to move")

    # Flips of this card are over at once: who waits for them alone draws hundreds of pictures a second.
    begin, first = box.now(), pictures_shown(box)
    box.sh("sleep 15")
    shown, seconds = pictures_shown(box) - first, box.now() - begin + 5
    print(f"{shown} pictures in {seconds:.0f} s")
    assert 0 < shown <= RATE * seconds + 1, "pictures are paced by the player's clock"

    assert box.sh(f"ps -o user= -p {pid}") == "vitrine"
    assert int(box.sh(f"grep CapEff /proc/{pid}/status").split()[1], 16) == 0, "the player has capabilities"
    assert box.sh("systemctl is-active vitrine-player vitrine-analyzer").split() == ["active", "active"]
    assert box.pid() == pid, "it is the same process"
