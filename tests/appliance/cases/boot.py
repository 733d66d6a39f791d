"""The machine starts without a panel: the services come up all the same, and the wall when there is a panel."""


def run(box):
    box.pull()
    box.sh("systemctl enable vitrine-analyzer vitrine-player; sync")
    box.reboot()
    box.wait_until_active("vitrine-player")
    pid = box.pid()

    box.panel(640, 480)

    box.wait_for_wall("the wall on the first panel since the start", size=(640, 480))
    assert box.pid() == pid, "it is the same process"
