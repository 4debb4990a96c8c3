"""The tongue at rest: a tube round a cubic Bezier midline (synth/face/tongue.cpp moves it)."""
import numpy as np
from numpy import exp, hypot

import parts

STATIONS, ROUND = 15, 12


def faces():
    f = parts.grid_faces(STATIONS, ROUND, True)
    tip = STATIONS * ROUND
    return f + [(tip - ROUND + j, tip, tip - ROUND + (j + 1) % ROUND) for j in range(ROUND)]


def rest():
    t = np.linspace(0, 1, STATIONS)
    P = np.array([(32, -104), (36, -80), (58, -75.5), (83.5, -80.5)], float)  # (z, y): root, body, blade, tip
    u = 1 - t
    z, y = (u**3 * P[0, a] + 3 * u * u * t * P[1, a] + 3 * u * t * t * P[2, a] + t**3 * P[3, a] for a in (0, 1))
    tz, ty = np.gradient(z), np.gradient(y)
    length = hypot(tz, ty)
    tz, ty = tz / length, ty / length
    nz, ny = -ty, tz
    half = np.interp(t, [0, 0.3, 0.6, 0.8, 0.92, 1], [19, 20, 17.5, 15.2, 11.6, 7.8])
    thick = np.interp(t, [0, 0.3, 0.6, 0.8, 0.92, 1], [13, 12.5, 8.5, 5.6, 3.9, 2.7])
    phase = np.arange(ROUND) / ROUND * 2 * np.pi
    c, s = np.cos(phase), np.sin(phase)
    V = []
    for i in range(STATIONS):
        x = half[i] * np.sign(c) * np.abs(c) ** 0.8
        h = thick[i] * np.where(s > 0, np.abs(s) ** 0.8 * 0.95, -np.abs(s) ** 0.9)
        h = h - 0.13 * thick[i] * exp(-((x / (half[i] * 0.35)) ** 2)) * (s > 0)  # the groove
        V.append(np.stack([x, y[i] + ny[i] * h, z[i] + nz[i] * h], 1))
    V.append([[0, y[-1] + ty[-1] * 2.0, z[-1] + tz[-1] * 2.0]])
    V = np.concatenate(V)
    # inside the lower arch, below the palate
    inside = np.maximum(0, (parts.ZL - V[:, 2]) / 27.0) ** (1 / 2.7) * 24.5
    inside -= np.interp(V[:, 2], [45, 60, 78, 87], [8.0, 7.5, 6.0, 3.5])
    step = np.clip((V[:, 1] + 76.5) / 3, 0, 1)
    low = 1 - step * step * (3 - 2 * step)
    limit = np.where(V[:, 2] < 85.5, np.maximum(inside, 6), 99)
    V[:, 0] -= np.sign(V[:, 0]) * np.maximum(0, np.abs(V[:, 0]) - limit) * low
    palate = np.interp(V[:, 2], [30, 45, 62, 79, 87, 89], [-70, -61.5, -60, -63.5, -68.5, -76]) - 0.012 * V[:, 0] ** 2
    V[:, 1] = np.where(V[:, 2] < 88, np.minimum(V[:, 1], palate), V[:, 1])
    return V, faces()
