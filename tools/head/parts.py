"""The separate parts, both sides: ears, eyeball, teeth, gums. Tongue: tongue.py."""
import numpy as np
from numpy import sin, cos, pi, hypot
from scipy.interpolate import PchipInterpolator as PC


def grid_faces(n, m, closed_u=False, off=0):
    f = []
    for i in range(n - 1):
        for j in range(m if closed_u else m - 1):
            f.append(
                (off + i * m + j, off + (i + 1) * m + j, off + (i + 1) * m + (j + 1) % m, off + i * m + (j + 1) % m)
            )
    return f


# The ear's profiles. Key: degrees round the ear canal before the ear leans back, 0 forward, 90 up, 180 back, 270 down
# to the lobe. From outside in, ten rings: mm from the canal, seen from the side, and mm off the skin. In front the
# first three run out flat on the cheek; behind they are the back of the ear. Then three of the rim (in front the
# tragus), the furrow within it, the inner fold, the wall and the floor of the hollow.
EAR = {
    -50: ([27, 22.5, 19.4, 17, 15, 13, 10.8, 8.6, 6.4, 4.4], [-0.1, 0.05, 0.3, 1.1, 2.6, 3.9, 4, 3.3, 1.6, 1]),
    -25: ([26, 20.5, 16, 12.6, 10, 8.2, 6.5, 5.8, 5.4, 4.2], [-0.1, 0.05, 0.2, 1.1, 3.6, 5.8, 6.2, 3.2, 1, 0.6]),
    -10: ([25.5, 20, 15.4, 11.9, 9.2, 7.4, 6.2, 5.6, 5.2, 4.2], [-0.1, 0.05, 0.2, 1.1, 4, 6.6, 7, 3.8, 1, 0.5]),
    10: ([24, 19, 15.2, 12.3, 10, 8.3, 6.4, 5.6, 5.3, 4.2], [-0.1, 0.05, 0.2, 1, 3, 5, 5.2, 3, 1, 0.6]),
    30: ([21.5, 18.6, 16.3, 14.5, 12.8, 11, 9.3, 7.6, 6, 4.4], [-0.2, 0.1, 0.5, 1.6, 3, 3.6, 3, 2.5, 1.7, 1]),
    55: ([25.2, 24.1, 23.4, 22.6, 21, 18.2, 16, 13, 9.5, 6], [-0.8, 0.1, 1.6, 4, 6.2, 6.6, 3.4, 5, 4.2, 2.2]),
    76: ([24.5, 26.8, 29.2, 31.4, 30.6, 27.4, 24.4, 18, 13, 8], [-2.5, 0, 1, 2, 3.8, 4.6, 1.4, 5.8, 2.8, 1.8]),
    100: ([23.5, 25.8, 28.8, 31.4, 30.4, 27, 24.4, 18.4, 13.4, 8.5], [-2.5, 0.2, 3.8, 7, 9.4, 9.4, 4, 8.4, 3, 1.6]),
    135: ([20, 22, 25.3, 28.8, 27.8, 24.2, 22, 16.8, 13, 8], [-2.5, 1.2, 8, 13.8, 16.6, 16.2, 9.4, 13.4, 4, 1.8]),
    180: ([17, 18.5, 21.3, 24.8, 23.8, 20.6, 18.6, 14.4, 11.6, 7], [-2.5, 2, 10, 16.6, 19.4, 19, 12, 15.2, 4.6, 1.8]),
    225: ([17, 18, 20.5, 23.7, 22.8, 20, 17.9, 13.8, 11, 6.8], [-2.5, 1.8, 7.6, 12.4, 14.8, 14.6, 9.6, 12.8, 4.2, 1.6]),
    260: ([20.5, 22.5, 24.8, 26.6, 25.6, 22.8, 19.1, 13.4, 9.8, 6], [-1.5, 0.2, 2, 4.8, 7.2, 8, 6.8, 9.6, 3.6, 1.3]),
    290: ([28.5, 26.6, 25.2, 23.6, 21.6, 19, 15.6, 11.3, 8.4, 5], [-0.3, 0.05, 0.6, 1.8, 3.8, 5.4, 5.5, 7.2, 3, 1]),
}
EAR_COLUMNS = [-10, 10, 30, 48, 62, 78, 97, 118, 140, 163, 187, 210, 232, 250, 266, 284, 305, 328]
EAR_CANAL = (-14.5, -7.0)  # y, z
EAR_LEAN = 14  # degrees, top back


def ear(skin):
    """The left ear: rings from where it grows out of the head to the hollow's floor, then the canal.
    skin(y, z): x of the head's side."""
    keys = np.array(list(EAR))
    profile = PC(np.concatenate([keys - 360, keys, keys + 360]), np.array(list(EAR.values()) * 3, float))
    away, height = np.moveaxis(profile(EAR_COLUMNS), 0, -1)
    turned = np.radians(np.array(EAR_COLUMNS) + EAR_LEAN)
    y = EAR_CANAL[0] + away * sin(turned)
    z = EAR_CANAL[1] + away * cos(turned)
    vertices = np.stack([skin(y, z) + height, y, z], -1).reshape(-1, 3)
    count, n = away.shape
    faces = grid_faces(count, n, True)
    canal = len(vertices)
    vertices = np.vstack([vertices, vertices[-n:].mean(0) - [1, 0, 0]])
    faces += [(canal - n + j, canal, canal - n + (j + 1) % n) for j in range(n)]
    return vertices, faces


def eyeball():
    nu, nv = 12, 9
    V = []
    f = []
    for i in range(nv + 1):
        th = pi * (i / nv) ** 1.0
        for j in range(nu):
            ph = 2 * pi * j / nu
            V.append((sin(th) * cos(ph), sin(th) * sin(ph), cos(th)))
    return np.array(V), [q for q in grid_faces(nv + 1, nu, True)]


ZU, ZL = 93.0, 90.0  # labial face of the upper and lower incisors (z)
ARCH = lambda x, z0, w, d: z0 - d * (np.abs(x) / w) ** 2.7


def teeth(upper):
    # mesiodistal width, crown height, labiolingual depth
    if upper:
        wd = [8.5, 6.6, 7.7, 6.9, 6.7, 10]
        ht = [10.3, 8.8, 9.9, 8.3, 7.4, 7.2]
        dp = [3.6, 3.2, 4.6, 7.5, 8, 10]
        z0, w, d = ZU, 26.0, 28.0
        inc = [0, 0.9, 0.1, 0.9, 1.3, 1.6]
        y0 = -78.0
        sg = 1
    else:
        wd = [5.3, 5.9, 6.8, 7.0, 7.1, 11]
        ht = [8.8, 9.2, 10.2, 8.6, 8.0, 7.4]
        dp = [3.2, 3.2, 4.4, 6.5, 7.5, 10]
        z0, w, d = ZL, 24.5, 27.0
        inc = [0, 0.0, -0.3, 0.6, 1.0, 1.0]
        y0 = -75.6
        sg = -1
    # walk along the arch by arc length
    xs = np.linspace(0, w * 1.3, 4000)
    zs = ARCH(xs, z0, w, d)
    L = np.concatenate([[0], np.cumsum(hypot(np.diff(xs), np.diff(zs)))])
    V = []
    f = []
    tt = []
    s = 0.02
    for k, (wi, h, de, ic) in enumerate(zip(wd, ht, dp, inc)):
        sc = s + wi / 2
        s += wi + 0.10
        x = np.interp(sc, L, xs)
        z = np.interp(sc, L, zs)
        x2 = np.interp(sc + 0.5, L, xs)
        z2 = np.interp(sc + 0.5, L, zs)
        T = np.array([x2 - x, 0, z2 - z])
        T /= np.linalg.norm(T)
        Nn = np.array([-T[2], 0, T[0]])
        Nn = Nn if Nn[2] > 0 or Nn[0] > 0 else -Nn
        molar = k >= 3
        # box cage 3 (width) x 4 (height) x 2 (depth)
        us = [-0.5, 0, 0.5]
        vs = [0, 0.16, 0.55, 1.0]  # v: 0 incisal .. 1 cervical
        idx = {}
        for vi, v in enumerate(vs):
            wv = np.interp(v, [0, 0.16, 0.55, 1], [0.93, 1.03, 1.0, 0.74])
            dv = np.interp(v, [0, 0.16, 0.55, 1], [0.95 if molar else 0.34, 1.0 if molar else 0.55, 1.0, 0.95])
            for ui, u in enumerate(us):
                for di, dd in enumerate((0.5, -0.5)):
                    bul = (
                        0.0 if dd < 0 else (0.35 * (1 - (2 * u) ** 2)) + 0.5 * np.interp(v, [0, 0.5, 1], [-0.4, 0.4, 0])
                    )
                    edge = 0
                    if vi == 0:
                        edge = (0.30 if abs(u) > 0.4 else 0) + (0.5 * abs(u) * 2 * 0.6 if k == 2 else 0)
                    if k == 2 and vi == 0 and u == 0:
                        edge = -0.35
                    p = (
                        np.array([x, 0, z])
                        + T * (u * wi * wv)
                        + Nn * ((dd - 0.5) * de * dv + bul)
                        + np.array([0, y0 + sg * (ic + edge + v * h), 0])
                    )
                    p = p + Nn * (-0.08 * v * h if not molar else -0.03 * v * h) * (-0.4 if upper else 1.0) * 1.0
                    idx[ui, vi, di] = len(V)
                    V.append(p)
                    tt.append((k, v))

        def Q(*q):
            f.append(tuple(idx[a] for a in q))

        for vi in range(3):
            for ui in range(2):
                Q((ui, vi, 0), (ui + 1, vi, 0), (ui + 1, vi + 1, 0), (ui, vi + 1, 0))
                Q((ui, vi, 1), (ui, vi + 1, 1), (ui + 1, vi + 1, 1), (ui + 1, vi, 1))
            Q((0, vi, 1), (0, vi, 0), (0, vi + 1, 0), (0, vi + 1, 1))
            Q((2, vi, 0), (2, vi, 1), (2, vi + 1, 1), (2, vi + 1, 0))
        for ui in range(2):
            Q((ui, 0, 1), (ui + 1, 0, 1), (ui + 1, 0, 0), (ui, 0, 0))
            Q((ui, 3, 0), (ui + 1, 3, 0), (ui + 1, 3, 1), (ui, 3, 1))
    V = np.array(V)
    n = len(V)
    V2 = V * [-1, 1, 1]
    f2 = [tuple(i + n for i in q[::-1]) for q in f]
    return np.vstack([V, V2]), f + f2, tt + tt


def gums(upper):
    if upper:
        z0, w, d, yg, yr, sg = ZU - 0.6, 26.0, 28, -69.0, -58, 1
    else:
        z0, w, d, yg, yr, sg = ZL - 0.2, 24.5, 27, -84.2, -96, -1
    xs = np.linspace(-1, 1, 17)
    xs = w * 1.02 * np.sign(xs) * np.abs(xs) ** 0.8
    V = []
    for x in xs:
        z = ARCH(x, z0, w, d)
        e = 0.5
        T = np.array([2 * e, 0, ARCH(x + e, z0, w, d) - ARCH(x - e, z0, w, d)])
        T /= np.linalg.norm(T)
        N = np.array([-T[2], 0, T[0]])
        if N[2] < 0:
            N = -N
        th = 6 + 4 * abs(x / w)
        rise = 1.5 * abs(x / w) * sg
        for o, y in [
            (-0.4, yr),
            (1.4, (yr + yg) / 2 + 0),
            (1.1, yg + sg * 1.5),
            (0.0, yg + 0 * sg),
            (-th, yg + sg * 0.5),
            (-th - 1.5, (yr + yg) / 2),
            (-th - 3, yr),
        ]:
            V.append(np.array([x, y - rise * 0, z]) + N * o)
    return np.array(V), grid_faces(17, 7)
