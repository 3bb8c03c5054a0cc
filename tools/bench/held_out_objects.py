

# Objects that nothing was tuned on, in place of the ones above: see tools/bench/held_out.sh.
def objects():
    return dict(
        wedge=extrude([(-2.5, -1.5), (2.5, -1.5), (-2.5, 2.0)], -1.2, 1.2,
                      ["teal", "orange", "pink"], "violet", "lime"),
        t_shape=extrude([(-.8, -2.5), (.8, -2.5), (.8, .7), (2.4, .7), (2.4, 2.3), (-2.4, 2.3),
                         (-2.4, .7), (-.8, .7)], -.9, .9,
                        ["red", "green", "blue", "yellow", "cyan", "magenta", "orange", "brown"],
                        "lime", "violet"),
        stairs=extrude([(-2, -2), (2, -2), (2, -.7), (.7, -.7), (.7, .6), (-.6, .6), (-.6, 2),
                        (-2, 2)], -1.5, 1.5,
                       ["green", "red", "yellow", "red", "cyan", "red", "magenta", "blue"],
                       "orange", "teal"),
        house=extrude([(-1.6, -1.8), (1.6, -1.8), (1.6, .6), (0, 2.1), (-1.6, .6)], -2.2, 2.2,
                      ["brown", "cyan", "red", "orange", "lime"], "yellow", "magenta"),
        knob=block_with_peg(3, 1.2, 3, 1.1, 1.4,
                            ["violet", "pink", "lime", "teal", "orange", "cyan"], "red", "green"))


SYMMETRIES = {}
