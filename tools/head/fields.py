"""Displacement fields: what one millimetre (or degree, or unit) of a control does to each vertex of the skin cage."""
import numpy as np
from numpy import exp, hypot, cos, pi

SS = lambda a, c, x: (lambda t: t * t * (3 - 2 * t))(np.clip((x - a) / (c - a), 0, 1))
CONDYLE = np.array([0, -12.0, 6.0])


class Fields:
    def __init__(R, m):
        R.m = m
        V = m.skinV
        n = len(V)
        T = m.tag
        R.V = V
        x, y, z = V.T
        ax = abs(x)
        sg = np.sign(x)
        g = lambda key, d=-1: np.array([t.get(key, d) for t in T])
        R.ring, R.k, R.r, R.c, R.e, R.eyer = g("ring"), g("k"), g("r"), g("c"), g("e"), g("eye")
        ring, k = R.ring, R.k
        mouth = ring >= 1
        lips = (ring >= 3) & (ring <= 9)
        fr = SS(5, 45, z)
        # falloff outside the lips
        dl = np.maximum(0, hypot(ax / 1.28, y + 76) - 20.5)
        R.near = np.where(mouth & (ring >= 3), 1, exp(-((dl / 15) ** 2))) * fr
        # --- jaw weight
        kk = np.array([0, 0, 0, 0, 0.01, 0.04, 0.10, 0.21, 0.38, 0.56, 0.74, 0.87, 0.95, 0.99, 1, 1, 1.0])
        phi = np.degrees(np.arctan2(-(y - CONDYLE[1]), z - CONDYLE[2]))
        wg = SS(27, 52, phi) * SS(-8, 24, z)
        wg = np.where(z < -8, 0, wg)
        neck = {28: 0.86, 29: 0.52, 30: 0.18, 31: 0.03, 32: 0}
        for r, w in neck.items():
            wg[R.r == r] *= w
        wj = wg.copy()
        for i in range(n):
            if 1 <= ring[i] <= 10:
                t = {1: 0.35, 2: 0.7}.get(ring[i], 1)
                wj[i] = t * kk[k[i]] + (1 - t) * wg[i]
            elif ring[i] > 10:
                wj[i] = 0.5 - 0.5 * cos(k[i] / 16 * pi) if ring[i] < 13 else 0.5
        R0 = [
            i
            for i in range(n)
            if (R.r[i], R.c[i])
            in {(r, 5) for r in range(18, 25)} | {(24, c) for c in range(6)} | {(18, c) for c in range(6)}
        ]
        # smooth the jaw weight over the cage (not inside the lips)
        nb = [set() for _ in range(n)]
        for q in m.skinF:
            for a, c_ in zip(q, q[1:] + q[:1]):
                nb[a].add(c_)
                nb[c_].add(a)
        R.nb = nb
        free = [i for i in range(n) if (ring[i] in (1, 2)) or (R.r[i] >= 17 and R.r[i] <= 30)]
        for _ in range(3):
            new = {i: 0.5 * wj[i] + 0.5 * np.mean([wj[j] for j in nb[i]]) for i in free}
            for i, v in new.items():
                wj[i] = v
        R.wj = wj
        ph = np.where(mouth, k / 16 * pi, 0)
        uplow = np.where(mouth, cos(ph), np.clip((y + 76) / 14, -1, 1))  # +1 upper, -1 lower
        R.up = np.clip(uplow, 0, 1) ** 0.8
        R.lo = np.clip(-uplow, 0, 1) ** 0.8
        # --- width : dx proportional to x, corner retracts along the dental arch
        px = np.clip(ax / 25, 0, 1.25)
        px = np.where(ax > 31, 1.24 * exp(-(((ax - 31) / 22) ** 2)), px)
        deep = np.where(ring >= 10, 0.3, 1)
        F = {}
        near2 = np.where(mouth & (ring >= 3), 1, exp(-((dl / 19) ** 2))) * fr
        near2 = np.where((ring < 0) & (ax < 25), near2 * (1 - 0.9 * SS(-62, -52, y)), near2)
        F["width"] = np.stack(
            [sg * px * near2 * deep, 0.10 * px**2 * near2 * deep, -0.62 * px**2 * near2 * deep], 1
        )
        F["narrow"] = F["width"].copy()
        F["narrow"][:, 0] = (
            sg
            * np.where(px > 0, np.clip(px, 0, 2) ** 1.0, 0)
            * np.where(ax < 25, 0.62 + 0.38 * np.clip(ax / 25, 0, 1), 1)
            * near2
            * deep
        )
        F["width_thin"] = np.zeros((n, 3))
        thin = np.where((ring >= 3) & (ring <= 8), 1, 0)
        yc = np.interp(ax, [0, 5, 10, 14, 18, 21, 23, 24.5], [-76, -75.6, -75.3, -75.5, -75.9, -76.2, -76.4, -76.4])
        F["width_thin"][:, 1] = -(y - yc) * thin * 0.022
        F["width_thin"][:, 2] = -0.10 * thin * (ring <= 6) * np.clip(1 - ax / 24, 0, 1)
        # --- protrusion (+ cheeks in)
        lipz = np.where(
            (ring >= 3) & (ring <= 8),
            1,
            np.where(ring == 9, 0.75, np.where(ring == 10, 0.25, np.where(ring > 10, 0, exp(-((dl / 13) ** 2)) * fr))),
        )
        lipz = np.where(
            (ring < 0) | (ring == 1) | (ring == 2),
            lipz
            * np.where(
                y > -76, SS(-53, -66.5, y) + (1 - SS(-53, -66.5, y)) * SS(26, 40, ax) * 0.7, 1 - SS(-86, -100, y)
            ),
            lipz,
        )
        prof = np.where(ax < 25, 1 - 0.14 * (ax / 25) ** 2, 0.86)
        F["protrude"] = np.zeros((n, 3))
        F["protrude"][:, 2] = lipz * prof
        F["protrude"][:, 0] = -sg * 0.10 * px * lipz
        cheek = exp(-(((hypot((ax - 46) * 0.9, (y + 66) * 0.85)) / 17) ** 2)) * SS(10, 40, z) * (ring < 0)
        nrm = np.stack([x / 70**2, 0 * x, z / 95**2], -1)
        nrm /= np.linalg.norm(nrm, axis=1, keepdims=True) + 1e-9
        F["protrude"] -= 0.42 * cheek[:, None] * nrm
        bow = np.where(
            (ring == 3) | (ring == 4),
            np.interp(k, [0, 1, 2, 3, 4, 5, 6, 8], [0.16, -0.10, -0.02, 0.06, 0.10, 0.10, 0.05, 0]) * (k <= 8),
            0,
        ) + np.where(
            (ring == 3) | (ring == 4),
            np.interp(k, [8, 10, 11, 12, 13, 14, 16], [0, -0.05, -0.08, -0.07, 0, 0.04, 0.06]) * (k > 8),
            0,
        )
        F["protrude"][:, 1] += bow
        # --- funnel: evert (vermilion turns outward)
        F["funnel"] = np.zeros((n, 3))
        ev = np.interp(np.where(mouth, ring, 0), [0, 2, 3, 4, 5, 6, 7, 8, 9], [0, 0.2, 0.8, 1.2, 1.0, 0.35, 0.1, 0, 0])
        F["funnel"][:, 1] = np.where(mouth, ev * np.sign(cos(ph)) * np.abs(cos(ph)) ** 0.5 * 2.4, 0)
        F["funnel"][:, 2] = np.where(mouth, np.interp(ring, [2, 3, 4, 5, 6, 8], [0, 0.3, 1.2, 2.0, 1.4, 0]), 0) * (
            1 - 0.4 * px
        )
        # --- raises
        wk = np.where(mouth, np.clip(1 - np.abs(k - 0) / 8.0, 0, 1), 0)
        bell = lambda q: q * q * (3 - 2 * q)
        wu = np.where(mouth & (ring >= 3) & (ring <= 9), bell(np.clip(1.25 * (1 - k / 8.0), 0, 1)), 0)
        wl = np.where(mouth & (ring >= 3) & (ring <= 9), bell(np.clip(1.25 * (k - 8) / 8.0, 0, 1)), 0)
        above = exp(-(((y + 62) / 13) ** 2)) * exp(-((ax / 30) ** 2)) * fr * (y > -75) * (ring < 3)
        lev = exp(-(((ax - 22) / 9) ** 2)) * exp(-(((y + 46) / 14) ** 2)) * fr * (ring < 3)
        F["upraise"] = np.zeros((n, 3))
        F["upraise"][:, 1] = wu + 0.72 * above * np.where(ring > 0, 1, SS(-20, -45, y)) + 0.28 * lev
        F["upraise"][:, 2] = 0.12 * wu + 0.12 * lev
        F["upraise"][:, 1] *= np.where((ring < 0) & (ax < 16) & (y > -56), 0.30, 1)
        below = exp(-(((y + 91) / 13) ** 2)) * exp(-((ax / 26) ** 2)) * fr * (y < -78) * (ring < 3)
        F["lowraise"] = np.zeros((n, 3))
        F["lowraise"][:, 1] = wl + 0.66 * below
        F["lowraise"][:, 2] = 0.10 * wl + 0.12 * below
        # --- corners
        wc = np.where(mouth, exp(-(((k - 8) / 2.6) ** 2)), 0) * np.interp(
            np.where(mouth, ring, 0), [0, 1, 2, 3, 9, 10, 11], [0, 0.45, 0.72, 1, 1, 0.5, 0]
        )
        wc = np.where(mouth, wc, exp(-((hypot(ax - 27, (y + 76)) / 13) ** 2)) * fr * 0.9)
        for a, nm in enumerate(("cornx", "corny", "cornz")):
            F[nm] = np.zeros((n, 3))
            F[nm][:, a] = wc * (sg if a == 0 else 1)
        mal = (exp(-((hypot((ax - 40) * 0.8, (y + 40))) ** 2) / (2 * 10**2)) * fr * (ring < 0))[:, None] * (
            nrm + np.array([0, 0.5, 0.3])
        )
        F["corny"] = F["corny"] + 0.36 * mal
        F["width"] = F["width"] + 0.14 * mal
        # --- puff
        pf = (
            exp(-(((hypot((ax - 44) * 0.9, (y + 68) * 0.8)) / 18) ** 2))
            * fr
            * np.interp(np.where(mouth, ring, 0), [0, 1, 2, 3], [1, 0.75, 0.4, 0.0])
        )
        pl = exp(-((dl / 16) ** 2)) * fr * np.where(ring >= 0, np.interp(ring, [0, 3, 5, 6], [1, 0.7, 0.3, 0]), 1)
        F["puff"] = 7 * nrm * pf[:, None]
        F["puff"][:, 2] += 2.2 * pl * np.where(np.abs(y + 76) < 4, 0.4, 1)
        # --- brow
        F["brow"] = np.zeros((n, 3))
        F["brow"][:, 1] = (
            exp(-(((y - 20) / 11) ** 2)) * exp(-((np.maximum(0, np.abs(ax - 30) - 18) / 14) ** 2)) * fr
            + 0.35 * exp(-(((y - 40) / 15) ** 2)) * exp(-((ax / 50) ** 2)) * fr
        )
        F["brow"][:, 1] *= np.where(R.eyer >= 3, 0, np.where(R.eyer == 2, 0.12, np.where(R.eyer == 1, 0.55, 1)))
        R.F = F
        # tuck weights
        R.wt = np.where(
            mouth,
            np.interp(np.where(mouth, ring, 0), [0, 1, 2, 3, 4, 5, 9, 10], [0, 0.10, 0.32, 0.62, 0.85, 1, 1, 0.2])
            * bell(np.clip((k - 8) / 6.0, 0, 1)),
            0,
        )
        R.hug = np.where(
            mouth,
            np.interp(np.where(mouth, ring, 0), [0, 1, 2, 3, 9, 10], [0, 0.15, 0.45, 0.8, 1, 0.3])
            * bell(np.clip((k - 7.5) / 7.0, 0, 1)),
            0,
        )


def lid_travel(f):
    """Vertical travel in mm of each eye-block vertex for full lid closure: negative on the upper lid, positive below."""
    import build as b

    travel = np.zeros(len(f.V))
    for i in np.where(f.eyer >= 1)[0]:
        u = (f.e[i] + 2) % 20
        if u in (0, 10):
            continue
        upper = u < 10
        t = (u if upper else 20 - u) / 10
        tt = 0.35 * (0.5 - 0.5 * cos(pi * t)) + 0.65 * t
        height = b.lidcurve(tt, True)[1] - b.lidcurve(tt, False)[1]
        if upper:
            travel[i] = -height * {1: 0.05, 2: 0.22, 3: 0.80, 4: 0.90, 5: 0.90, 6: 0.85}[f.eyer[i]]
        else:
            travel[i] = height * {1: 0.0, 2: 0.04, 3: 0.08, 4: 0.10, 5: 0.10, 6: 0.10}[f.eyer[i]]
    return travel
