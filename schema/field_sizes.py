#!/usr/bin/env python3
"""Prints how many bytes each field of a class index takes: field_sizes.py FILE.aspect

Reads the file with FlatBuffers' own compiler (flatc), and the sizes of structs from the schema."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCHEMA = pathlib.Path(__file__).with_name("class_index.fbs")
SCALARS = {"bool": 1, "ubyte": 1, "byte": 1, "short": 2, "ushort": 2, "int": 4, "uint": 4,
           "float": 4, "long": 8, "ulong": 8, "double": 8}


def struct_sizes(text):
    """Size and alignment of scalars, enumerations and structs, as FlatBuffers lays them out."""
    sizes = {name: (size, size) for name, size in SCALARS.items()}
    for name, base in re.findall(r"enum (\w+) : (\w+)", text):
        sizes[name] = sizes[base]
    for name, body in re.findall(r"struct (\w+) \{(.*?)\n\}", text, re.S):
        offset = alignment = 1
        offset = 0
        for field in re.findall(r"^\s*\w+: (\w+);", body, re.M):
            size, align = sizes[field]
            offset = (offset + align - 1) // align * align + size
            alignment = max(alignment, align)
        sizes[name] = ((offset + alignment - 1) // alignment * alignment, alignment)
    return sizes


def main(file):
    text = SCHEMA.read_text()
    sizes = struct_sizes(text)
    tables = {name: re.findall(r"^\s*(\w+): (\[?\w+\]?)", body, re.M)
              for name, body in re.findall(r"table (\w+) \{(.*?)\n\}", text, re.S)}
    with tempfile.TemporaryDirectory() as folder:
        copy = pathlib.Path(folder, "index.bin")
        copy.write_bytes(pathlib.Path(file).read_bytes())
        subprocess.run(["flatc", "--json", "--strict-json", "--raw-binary", "-o", folder,
                        str(SCHEMA), "--", str(copy)], check=True, stdout=subprocess.DEVNULL)
        index = json.loads(pathlib.Path(folder, "index.json").read_text())

    rows = []

    def add(table, values, prefix=""):
        for name, kind in tables[table]:
            value = values.get(name)
            if value is None:
                continue
            if kind.startswith("["):
                size = sizes[kind[1:-1]][0]
                rows.append((prefix + name, len(value), size, len(value) * size))
            elif kind in tables:
                add(kind, value, prefix + name + ".")

    add("ClassIndex", index)
    total = pathlib.Path(file).stat().st_size
    print("| field | number | bytes each | bytes |\n| --- | ---: | ---: | ---: |")
    for name, count, size, size_in_all in sorted(rows, key=lambda row: -row[3]):
        if count:
            print(f"| `{name}` | {count:,} | {size} | {size_in_all:,} |")
    print(f"| scalars, strings, tables | | | {total - sum(row[3] for row in rows):,} |")
    print(f"| all | | | {total:,} |")


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__.splitlines()[0])
    main(sys.argv[1])
