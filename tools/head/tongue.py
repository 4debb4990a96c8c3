"""The tongue at rest: a tube round a cubic Bezier midline (synth/face/tongue.cpp moves it;
synth/face/tongue_contact.cpp keeps it out of teeth and palate)."""
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
    return V, faces()
