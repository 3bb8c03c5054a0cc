

# Parts as a shop has them, many of them alike, in place of the objects above: see
# tools/bench/many_parts.sh. ASPECT_PARTS says how many; the first of a thousand are the hundred.
def random_part(rng):
    colours = list(COLOURS)
    sizes = [1, 1.5, 2, 3, 4]
    kind = rng.choice(["pegs", "prism", "stack"])
    # Few colours a part, as painted things have.
    paints = rng.sample(colours, rng.randint(2, 5))
    paint = lambda: rng.choice(paints)
    if kind == "pegs":
        w, h, d = (rng.choice(sizes) for _ in range(3))
        prims = box(-w/2, w/2, -h/2, h/2, -d/2, d/2, [paint() for _ in range(6)])
        places = [(-.3, -.3), (.3, .3), (.3, -.3), (-.3, .3)]
        for x, z in rng.sample(places, rng.randint(1, 3)):
            radius, length = rng.choice([.12, .18]) * min(w, d), rng.choice([.5, 1, 1.5])
            base, top = (x*w, h/2, z*d), (x*w, h/2 + length, z*d)
            prims += [("cone", base, radius, top, radius, paint()),
                      ("ring", top, (0, 1, 0), 0, radius, paint())]
        return prims
    if kind == "prism":
        corners, stretch = rng.randint(3, 8), rng.choice([1, 1.5])
        profile = [(2*stretch*math.cos(2*math.pi*k/corners), 2*math.sin(2*math.pi*k/corners))
                   for k in range(corners)]
        depth = rng.choice(sizes) / 2
        return extrude(profile, -depth, depth, [paint() for _ in range(corners)], paint(), paint())
    prims, y, width = [], -2, 4
    for _ in range(rng.randint(2, 3)):
        height, depth = rng.choice([1, 1.5, 2]), width * rng.choice([.5, .75, 1])
        prims += box(-width/2, width/2, y, y + height, -depth/2, depth/2,
                     [paint() for _ in range(6)])
        y, width = y + height, width * rng.choice([.5, .7])
    return prims


# As another one is, but for the colour of one surface.
def sibling(part, rng):
    changed = list(part)
    k = rng.randrange(len(changed))
    changed[k] = (*changed[k][:-1], rng.choice([c for c in COLOURS if c != changed[k][-1]]))
    return changed


def objects():
    import os, random
    rng = random.Random(20261129)
    parts = []
    for _ in range(int(os.environ["ASPECT_PARTS"])):
        parts.append(sibling(rng.choice(parts), rng) if parts and rng.random() < .3
                     else random_part(rng))
    return {"part%05d" % k: part for k, part in enumerate(parts)}


SYMMETRIES = {}
