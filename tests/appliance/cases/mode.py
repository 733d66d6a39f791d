"""The operator asks for modes that panels do not prefer, of one of them and of all, and for one that a panel does not have."""


def run(box):
    box.panel(640, 480)  # all of one shape, as panels that show the same wall each show all of it
    box.panel(800, 600, head=1)
    box.restart(output__mode="Virtual-1=1024x768")
    box.wait_for_wall("the wall in the mode asked for", size=(1024, 768))
    box.wait_for_wall("the wall in the mode that the other panel prefers", head=1, size=(800, 600))

    box.restart(output__mode="1600x901, Virtual-2=1024x768")
    box.wait_for_wall("the wall in the preferred mode for want of the one asked for", size=(640, 480))
    box.wait_for_wall("the wall in the mode asked of the other panel", head=1, size=(1024, 768))
