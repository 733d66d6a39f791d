"""A television set hides the edges: there is nothing to see there, and the whole wall within."""

LEFT, TOP, RIGHT, BOTTOM = 48, 27, 16, 9  # px; what stays has the panel's shape


def run(box):
    box.restart(output__margins=f"{LEFT},{TOP},{RIGHT},{BOTTOM}")

    part = LEFT, TOP, 640 - RIGHT, 360 - BOTTOM
    picture = box.wait_for_wall("the wall within its margins", size=(640, 360), part=part)

    edges = {"left": (0, 0, LEFT, 360), "top": (0, 0, 640, TOP), "right": (640 - RIGHT, 0, 640, 360),
             "bottom": (0, 360 - BOTTOM, 640, 360)}
    for name, edge in edges.items():
        assert max(picture.part(*edge).pixels) == 0, f"something is to be seen at the {name}"
