#!/usr/bin/env python3
"""Writes the head's assets (head.obj, fields.csv, teeth.csv), or checks the committed ones.

    generate.py                 writes synth/assets/head
    generate.py --output DIR    writes elsewhere
    generate.py --check         regenerates in memory and compares with the committed assets
"""
import argparse
import io
import pathlib
import sys

import numpy as np

import fields
import model

ASSETS = pathlib.Path(__file__).resolve().parents[2] / "synth" / "assets" / "head"
ANGULAR = {"jaw", "tuck"}  # weights of rotations with arms of up to 100 mm need more digits
TOLERANCE = 2e-4  # a little more than the last printed digit


def write_object(out, offset, name, vertices, groups):
    """One separately subdivided part: its vertices, then its faces by named group."""
    print("o", name, file=out)
    for p in vertices:
        print("v %.4f %.4f %.4f" % tuple(0.0 + np.round(p, 4)), file=out)
    for group, faces in groups.items():
        print("g", group, file=out)
        for face in faces:
            print("f", *[i + 1 + offset for i in face], file=out)
    return offset + len(vertices)


def head_obj(head):
    out = io.StringIO()
    print("# Control cage of the head, made by tools/head/generate.py.", file=out)
    print(
        "# Millimetres; x = subject's left, y up, z forward; origin between the ear canals at pupil height.", file=out
    )
    groups = {}
    for face, group in zip(head.skinF, head.skinG):
        groups.setdefault({"nostril": "skin"}.get(group, group), []).append(face)
    offset = write_object(out, 0, "skin", head.skinV, groups)
    for name, (vertices, faces) in head.parts.items():
        offset = write_object(out, offset, name, vertices, {name: faces})
    return out.getvalue()


def number(value, digits):
    text = "%.*f" % (digits, value)
    text = text.rstrip("0").rstrip(".")
    return {"-0": "0"}.get(text, text)


def table(columns):
    lines = [",".join(columns)]
    digits = [6 if name in ANGULAR else 4 for name in columns]
    for row in zip(*columns.values()):
        lines.append(",".join(number(v, d) for v, d in zip(row, digits)))
    return "\n".join(lines) + "\n"


def fields_csv(head):
    f = fields.SkinFields(head)
    columns = {
        "row": f.row,
        "column": f.grid_column,
        "mouth_ring": f.ring,
        "mouth_column": f.column,
        "eye_ring": f.eye_ring,
        "eye_column": f.eye_column,
        "lip": head.lip,
        "wet": head.wet,
        "scalp": head.scalp,
        "dark": head.dark,
        "jaw": f.jaw,
        "tuck": f.tuck,
        "hug": f.hug,
        "neck": head.headw,
        "lid_travel": f.lid_travel,
    }
    for name, field in f.fields.items():
        for axis, letter in enumerate("xyz"):
            columns[f"{name}_{letter}"] = field[:, axis]
    return table(columns)


def teeth_csv(head):
    return table(dict(height=np.concatenate([head.tooth_height["upper_teeth"], head.tooth_height["lower_teeth"]])))


def difference(made, kept):
    """The first place where two asset texts differ by more than rounding, or None."""
    made, kept = made.splitlines(), kept.splitlines()
    if len(made) != len(kept):
        return f"{len(kept)} lines instead of {len(made)}"
    for line, (a, b) in enumerate(zip(made, kept), 1):
        if a == b:
            continue
        x, y = (t.replace(",", " ").split() for t in (a, b))
        try:
            same = len(x) == len(y) and all(p == q or abs(float(p) - float(q)) <= TOLERANCE for p, q in zip(x, y))
        except ValueError:
            same = False
        if not same:
            return f"line {line}: made '{a[:60]}', committed '{b[:60]}'"
    return None


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--output", type=pathlib.Path, default=ASSETS)
    arguments.add_argument("--check", action="store_true")
    arguments = arguments.parse_args()

    head = model.make()
    files = {"head.obj": head_obj(head), "fields.csv": fields_csv(head), "teeth.csv": teeth_csv(head)}
    failures = 0
    for name, text in files.items():
        path = arguments.output / name
        if arguments.check:
            found = difference(text, path.read_text()) if path.exists() else "missing"
            print(f"{path}: {found or 'as made'}")
            failures += found is not None
        else:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
            print(f"{path}: {len(text)} bytes")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
