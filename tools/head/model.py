"""Assembly of the head: the mirrored skin cage with its masks, and the separate parts."""
import numpy as np
from scipy.interpolate import LinearNDInterpolator
from scipy.ndimage import map_coordinates

import parts
import skin
import tongue


class Head:
    """skinV, skinF, skinG: vertices, faces and their groups; tag: ring and column of each vertex;
    lip, wet, dark, scalp, headw: masks; parts: name -> (vertices, faces); tooth_height: 0 incisal .. 1 cervical."""


def side_of_head(gi, V):
    """x of the skin's left side at (y, z), near the ear: the surface that subdivision of the skin's grid tends to, a
    bicubic B-spline."""
    rows, columns = np.arange(5, 28), np.arange(9, 16)
    control = np.array([[V[gi[r, c]] for c in columns] for r in rows])
    at = np.meshgrid(np.linspace(1, len(rows) - 2, 120), np.linspace(1, len(columns) - 2, 120), indexing="ij")
    x, y, z = (map_coordinates(control[..., i], at, order=3, prefilter=False).ravel() for i in range(3))
    return LinearNDInterpolator(np.stack([y, z], -1), x)


def make():
    m = Head()
    H, gi, V, f, g, src, mp = skin.build_all()
    m.skinF, m.skinG = f, g
    n = len(V)
    m.tag = tag = [H.tag.get(src[i][0], {}) for i in range(n)]
    dark, lip, wet = np.zeros(n), np.zeros(n), np.zeros(n)
    for i, t in enumerate(tag):
        if "ring" in t:
            lip[i] = {1: 0, 2: 0, 3: 0.05, 4: 0.5, 5: 1, 6: 1.7, 7: 2.6}.get(t["ring"], 3)
            wet[i] = {9: 0.3}.get(t["ring"], 1.0 if t["ring"] > 9 else 0)
        if "nostril" in t:
            dark[i] = t["nostril"]
        if "eye" in t and (t["e"] + 2) % 20 <= 10 and t["eye"] >= 4:  # the upper lid's margin and inside
            dark[i] = {4: 0.25, 5: 0.8, 6: 0.8}[t["eye"]]
    m.lip, m.wet, m.dark = lip, wet, dark

    # Hair: above the nape, behind the ear, below the sideburn, behind the temple; thickened along the normal.
    x, y, z = np.abs(V[:, 0]), V[:, 1], V[:, 2]
    low = np.interp(z, [-95, -62, -40, -22, -10, 2, 10, 18, 26, 34], [-66, -62, -44, -26, -18, -24, -20, 0, 24, 34])
    high = np.interp(x, [0, 14, 28, 40, 50, 58, 66], [68, 69.5, 71, 67, 56, 42, 30])
    m.scalp = np.clip(np.where(z < 30, y - low, y - high) / 22 + 0.40, 0, 1)
    ear = np.hypot((z + 8) / 19, (y + 16) / 30)
    m.scalp = m.scalp * np.where(x > 50, np.clip((ear - 0.75) / 0.5, 0, 1), 1)
    V[:, 0] -= np.sign(V[:, 0]) * np.where(x > 50, 4.5 * np.exp(-((ear / 0.62) ** 2)), 0)
    normal = V * [1 / 74**2, 1 / 100**2, 1 / 95**2]
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    t = np.clip((m.scalp - 0.25) / 0.75, 0, 1)
    V += normal * (t * t * (3 - 2 * t) * (2.5 + 4.5 * np.clip((y + 20) / 90, 0, 1)))[:, None]
    m.skinV = V

    # How far a grid row of the neck follows the head.
    neck = {28: 1, 29: 0.93, 30: 0.72, 31: 0.35, 32: 0}
    m.headw = np.array([neck.get(t.get("r", 0), 1.0) for t in tag])

    m.parts, m.tooth_height = {}, {}
    for upper, name in ((1, "upper_teeth"), (0, "lower_teeth")):
        vertices, faces, tags = parts.teeth(upper)
        m.parts[name] = (vertices, faces)
        m.tooth_height[name] = np.array([t[1] for t in tags])
    m.parts["upper_gum"] = parts.gums(1)
    m.parts["lower_gum"] = parts.gums(0)
    m.parts["tongue"] = tongue.rest()
    vertices, faces = parts.ear(side_of_head(gi, V))
    m.parts["left_ear"] = (vertices, faces)
    m.parts["right_ear"] = (vertices * [-1, 1, 1], [q[::-1] for q in faces])
    for name in ("lower_teeth", "upper_gum", "tongue"):  # made inside out
        vertices, faces = m.parts[name]
        m.parts[name] = (vertices, [q[::-1] for q in faces])
    ball, faces = parts.eyeball()
    m.parts["left_eye"] = (ball * skin.EYER + skin.EYEC, faces)
    m.parts["right_eye"] = (ball * skin.EYER + skin.EYEC * [-1, 1, 1], faces)
    return m
