"""What a plot shows, by Python's XML parser: one JSON object on standard output.
usage: read_svg.py FILE.svg"""
import json
import sys
import xml.etree.ElementTree as tree

SVG = "{http://www.w3.org/2000/svg}"


def numbers(element, *names):
    return [float(element.get(name)) for name in names]


def main(file):
    root = tree.parse(file).getroot()
    assert root.tag == SVG + "svg", root.tag
    width, height = numbers(root, "width", "height")
    found = {"width": width, "height": height, "count": {}, "texts": [], "circles": [], "bars": [],
             "curves": [], "lines": [], "marks": 0, "outside": []}
    for element in root.iter():
        name = element.tag.removeprefix(SVG)
        found["count"][name] = found["count"].get(name, 0) + 1
        points = []
        if name == "text":
            found["texts"].append(element.text or "")
            points = [numbers(element, "x", "y")]
        elif name == "circle":
            found["circles"].append(numbers(element, "cx", "cy"))
            points = found["circles"][-1:]
        elif name == "rect" and element.get("class") == "bar":
            box = numbers(element, "x", "y", "width", "height")
            found["bars"].append({"box": box, "fill": element.get("fill")})
            points = [box[:2], [box[0] + box[2], box[1] + box[3]]]
        elif name == "polyline":
            points = [[float(c) for c in p.split(",")] for p in element.get("points").split()]
            found["curves"].append({"points": points, "stroke": element.get("stroke"),
                                    "dashes": element.get("stroke-dasharray", "")})
        elif name == "line":
            points = [numbers(element, "x1", "y1"), numbers(element, "x2", "y2")]
            found["lines"].append(points)
        found["marks"] += name == "circle" or element.get("class") == "mark"
        found["outside"] += [[name, p] for p in points
                             if not (0 <= p[0] <= width and 0 <= p[1] <= height)]
    json.dump(found, sys.stdout)


main(sys.argv[1])
