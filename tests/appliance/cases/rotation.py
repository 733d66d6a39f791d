"""A panel hung on its side: the wall fills the panel's own mode and is upright for who looks at it."""

UP = {0: (0, -1), 90: (-1, 0), 180: (0, 1), 270: (1, 0)}  # a panel's own edge that is up once it is hung turned clockwise


def middle(places):
    return sum(x for x, _ in places) / len(places), sum(y for _, y in places) / len(places)


def check_up(box, picture, degrees):
    (ux, uy), (lx, ly) = (middle(picture.places_of(colour)) for colour in (box.UPPER, box.LOWER))
    right, down = ux - lx, uy - ly
    print(f"{degrees} degrees: the upper half is {right:.0f} px to the right of the lower one and {down:.0f} px down")
    x, y = UP[degrees]
    assert x * right + y * down > 5 * abs(y * right + x * down), "what is up in the picture"


def run(box):
    check_up(box, box.wait_for_wall("the wall as it is", size=(640, 360)), 0)
    for degrees in (90, 180, 270):
        box.restart(output__rotation=degrees)
        check_up(box, box.wait_for_wall(f"the wall turned by {degrees} degrees", size=(640, 360)), degrees)
