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


def ear():
    "polar ear: rings from the attachment through helix, scapha, antihelix, concha. returns left ear"
    n = 18
    ph = np.arange(n) / n * 2 * pi  # 0 anterior, 90deg up, 180 back, 270 lobe (down)
    out_r = PC(
        np.radians([-90, -60, -30, 0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330, 360, 390, 420, 450]),
        [27, 19, 13.5, 12, 15, 25, 32, 31, 26, 23, 22.5, 24, 27, 19, 13.5, 12, 15, 25, 32],
    )(ph)
    c_, s_ = cos(ph), sin(ph)
    back = np.clip((1 - c_) / 1.4, 0, 1)  # 1 behind/up, 0 at the front
    helix = np.clip(
        np.interp(
            np.degrees(ph),
            [0, 15, 40, 90, 200, 250, 265, 300, 330, 345, 360],
            [0.3, 0.7, 1, 1, 1, 0.55, 0.3, 0.15, 0.2, 0.35, 0.3],
        ),
        0,
        1,
    )
    lobe = np.exp(-(((np.degrees(ph) - 272) / 32.0) ** 2))
    rings = []

    def ring(scale, h):
        rings.append(np.stack([out_r * scale * c_, out_r * scale * s_, h + 0 * ph], -1))

    flare = (
        -1.5 + 5.5 * back - 3.0 * lobe + 2.2 * np.maximum(0, s_) * np.clip(1.2 - back, 0, 1)
    )  # stands away from the head at the back
    ring(0.80, -11 + 0 * ph)
    ring(0.97, flare * 0.45 - 1)
    ring(1.0, flare + 0.5)
    ring(0.955, flare + 3.2 * helix + 0.4)
    ring(0.86, flare + 2.6 * helix + 0.2)
    ring(0.79, flare - 3.4 * helix - 0.3 * lobe)
    ring(0.66, flare - 1.8 * helix + 1.2 * (1 - lobe) * back)
    ring(0.56, flare - 0.2 + 1.9 * (1 - lobe) * back)
    ring(0.42, flare * 0.8 - 2.6 * (1 - 0.7 * lobe))
    ring(0.24, flare * 0.2 - 1.2 + 0 * ph)
    # tragus
    tr = np.exp(-(((np.degrees((ph + pi) % (2 * pi) - pi) + 6) / 24.0) ** 2))
    rings[7][:, 2] += 3.2 * tr
    rings[8][:, 2] += 3.5 * tr
    rings[7][:, 0] -= 2.2 * tr
    rings[8][:, 0] -= 1.2 * tr
    fr_ = np.exp(-(((np.degrees((ph + pi) % (2 * pi) - pi) + 12) / 34.0) ** 2))
    for j, q in zip(range(1, 7), (5.5, 6.5, 6.5, 5.5, 4.5, 2.5)):
        rings[j][:, 2] -= q * fr_
    V = np.concatenate(rings)
    f = grid_faces(len(rings), n, True)
    c = len(V)
    V = np.vstack([V, [rings[-1].mean(0) + [0, 0, -0.8]]])
    o = (len(rings) - 1) * n
    for j in range(n):
        f.append((o + j, c, o + (j + 1) % n))
    # ear frame -> head: local x=anterior, y=up, z=outward
    th = np.radians(14)
    V = V @ np.array([[cos(th), -sin(th), 0], [sin(th), cos(th), 0], [0, 0, 1]]).T  # lean back: top goes back
    V = V * [1, 1, 1]
    ex, ey, ez = np.array([-0.26, 0, 0.965]), np.array([0, 1, 0]), np.array([0.965, 0, 0.26])
    V[:, 2] -= 0.20 * np.maximum(0, -V[:, 1] - 4) - 0.05 * V[:, 1]
    P = np.array([70.2, -14.5, -7.0]) + V[:, :1] * ex + V[:, 1:2] * ey + V[:, 2:] * ez
    return P, f


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
