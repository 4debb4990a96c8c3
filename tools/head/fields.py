"""Displacement fields: what one millimetre (or degree, or unit) of a control does to each vertex of the skin cage.

Every field is a function of the rest position (x, y, z; `lateral` = |x|) and of the place in the mouth's loops (`ring`,
`column`; -1 elsewhere). synth/face adds them up, control by control; jaw rotation, lip tuck, contact and lids, which are
not linear, are C++ there and take only their weights from here.
"""
import numpy as np
from numpy import cos, exp, hypot, pi

import skin

CONDYLE = np.array([0, -12.0, 6.0])  # the angle to it bounds what the jaw carries
MOUTH_Y = -76.0  # the line between the lips
LAST_MOUTH_RING = 9


def smooth_step(start, end, x):
    t = np.clip((x - start) / (end - start), 0, 1)
    return t * t * (3 - 2 * t)


def bell(t):
    t = np.clip(t, 0, 1)
    return t * t * (3 - 2 * t)


class SkinFields:
    """Weights (one number per vertex) and fields (one vector per vertex, by name)."""

    def __init__(self, head):
        self.rest = head.skinV
        self.x, self.y, self.z = self.rest.T
        self.lateral = abs(self.x)
        self.side = np.sign(self.x)
        tag = lambda key: np.array([t.get(key, -1) for t in head.tag])
        self.ring, self.column = tag("ring"), tag("k")
        self.row, self.grid_column = tag("r"), tag("c")
        self.eye_ring, self.eye_column = tag("eye"), tag("e")

        self.mouth = self.ring >= 1
        self.lips = (self.ring >= 3) & (self.ring <= LAST_MOUTH_RING)
        self.mouth_ring = np.where(self.mouth, self.ring, 0)
        self.phase = np.where(self.mouth, self.column / 16 * pi, 0)  # 0 upper midline, pi lower
        self.front = smooth_step(5, 45, self.z)
        self.from_lips = np.maximum(0, hypot(self.lateral / 1.28, self.y + 76) - 20.5)
        self.outward = np.stack([self.x / 70**2, 0 * self.x, self.z / 95**2], -1)
        self.outward /= np.linalg.norm(self.outward, axis=1, keepdims=True) + 1e-9
        self.across = np.clip(self.lateral / 25, 0, 1.25)  # 1 at the corner of the mouth, fading over the cheek
        self.across = np.where(self.lateral > 31, 1.24 * exp(-(((self.lateral - 31) / 22) ** 2)), self.across)

        self.jaw = self.jaw_weight(head.skinF)
        self.tuck = self.by_ring([0, 1, 2, 3, 4, 5, 9, 10], [0, 0.10, 0.32, 0.62, 0.85, 1, 1, 0.2]) * np.where(
            self.mouth, bell((self.column - 8) / 6.0), 0
        )
        self.hug = self.by_ring([0, 1, 2, 3, 9, 10], [0, 0.15, 0.45, 0.8, 1, 0.3]) * np.where(
            self.mouth, bell((self.column - 7.5) / 7.0), 0
        )
        self.lid_travel = self.lid_travels()

        cornx, corny, cornz = self.corners()
        width = self.width()
        malar = self.malar()
        self.fields = {
            "width": width + 0.14 * malar + 0.80 * self.nasolabial_fold(),  # spreading lifts the cheek
            "narrow": self.narrow(width),
            "width_thin": self.width_thin(),
            "protrude": self.protrude() + 0.28 * self.chin_fold(),
            "funnel": self.funnel(),
            "upraise": self.upraise(),
            "lowraise": self.lowraise() + 0.30 * self.chin_fold(),
            "cornx": cornx,
            "corny": corny + 0.36 * malar + 0.55 * self.nasolabial_fold(),
            "cornz": cornz,
            "puff": self.puff(),
            "brow": self.brow(),
        }

    def by_ring(self, rings, values):
        """Interpolated over the mouth's rings; the first value outside them."""
        return np.interp(self.mouth_ring, rings, values)

    def vectors(self, x=0.0, y=0.0, z=0.0):
        return np.stack([np.broadcast_to(v, len(self.rest)) for v in (x, y, z)], 1).astype(float)

    def blob(self, x, y, spread, stretch_x=1.0, stretch_y=1.0):
        distance = hypot((self.lateral - x) * stretch_x, (self.y - y) * stretch_y)
        return exp(-((distance / spread) ** 2))

    def jaw_weight(self, faces):
        """Round the mouth by column (0.38 at the corner), elsewhere by the angle seen from the condyle; smoothed."""
        by_column = np.array([0, 0, 0, 0, 0.01, 0.04, 0.10, 0.21, 0.38, 0.56, 0.74, 0.87, 0.95, 0.99, 1, 1, 1.0])
        angle = np.degrees(np.arctan2(-(self.y - CONDYLE[1]), self.z - CONDYLE[2]))
        face = smooth_step(27, 52, angle) * smooth_step(-8, 24, self.z)
        for row, weight in {28: 0.86, 29: 0.52, 30: 0.18, 31: 0.03, 32: 0}.items():  # the neck
            face[self.row == row] *= weight
        jaw = face.copy()
        for i, (ring, column) in enumerate(zip(self.ring, self.column)):
            if 1 <= ring <= 10:
                t = {1: 0.35, 2: 0.7}.get(ring, 1)
                jaw[i] = t * by_column[column] + (1 - t) * face[i]
            elif ring in (11, 12):
                jaw[i] = 0.5 - 0.5 * cos(column / 16 * pi)
            elif ring > 12:
                jaw[i] = 0.5

        neighbours = [set() for _ in jaw]
        for face in faces:
            for a, b in zip(face, face[1:] + face[:1]):
                neighbours[a].add(b)
                neighbours[b].add(a)
        free = np.where(((self.ring == 1) | (self.ring == 2)) | ((self.row >= 17) & (self.row <= 30)))[0]
        for _ in range(3):
            smoothed = {i: 0.5 * jaw[i] + 0.5 * np.mean([jaw[j] for j in neighbours[i]]) for i in free}
            for i, weight in smoothed.items():
                jaw[i] = weight
        return jaw

    def width_reach(self):
        reach = np.where(self.mouth & (self.ring >= 3), 1, exp(-((self.from_lips / 19) ** 2))) * self.front
        under_nose = (self.ring < 0) & (self.lateral < 25)
        reach = np.where(under_nose, reach * (1 - 0.9 * smooth_step(-62, -52, self.y)), reach)
        return reach * np.where(self.ring >= 10, 0.1, 1)

    def width(self):
        """Per mm at the corner: outward in proportion to x, the corner back along the dental arch."""
        reach = self.width_reach()
        return self.vectors(
            self.side * self.across * reach, 0.10 * self.across**2 * reach, -0.62 * self.across**2 * reach
        )

    def narrow(self, width):
        """The same for narrowing, with a flatter profile near the midline."""
        field = width.copy()
        flatter = np.where(self.lateral < 25, 0.62 + 0.38 * np.clip(self.lateral / 25, 0, 1), 1)
        field[:, 0] = self.side * self.across * flatter * self.width_reach()
        return field

    def width_thin(self):
        """Spread lips become thin."""
        thin = np.where((self.ring >= 3) & (self.ring <= 8), 1, 0)
        line = np.interp(
            self.lateral,
            [0, 5, 10, 14, 18, 21, 23, 24.5],
            [-76, -75.6, -75.3, -75.5, -75.9, -76.2, -76.4, -76.4],
        )
        back = -0.10 * thin * (self.ring <= 6) * np.clip(1 - self.lateral / 24, 0, 1)
        return self.vectors(y=-(self.y - line) * thin * 0.022, z=back)

    def from_line(self, ends, spread):
        """A bell across a polyline (points in x and y), on the skin outside the lips."""
        nearest = np.full(len(self.rest), np.inf)
        for (x0, y0), (x1, y1) in zip(ends, ends[1:]):
            nearest = np.minimum(nearest, skin.seg(self.lateral, self.y, x0, y0, x1, y1)[0])
        return exp(-((nearest / spread) ** 2)) * self.front * (self.ring < 3)

    def nasolabial_fold(self):
        """A groove from the wing of the nose past the corner of the mouth, with the cheek bulging beside it."""
        groove = self.from_line([(19, -48), (27, -56), (34, -69)], 4.5)
        bulge = self.from_line([(27, -44), (35, -52), (42, -65)], 6.0)
        return (0.8 * bulge - groove)[:, None] * self.outward

    def chin_fold(self):
        """The furrow under the lower lip, with the chin's pad bulging below it."""
        furrow = self.from_line([(0, -94), (9, -93.5), (15, -91)], 4.0)
        pad = self.from_line([(0, -103), (8, -102)], 7.0)
        return (0.6 * pad - furrow)[:, None] * np.array([0, 0, 1.0])

    def malar(self):
        amount = exp(-((hypot((self.lateral - 40) * 0.8, self.y + 40)) ** 2) / (2 * 10**2))
        amount *= self.front * (self.ring < 0)
        return amount[:, None] * (self.outward + np.array([0, 0.5, 0.3]))

    def protrude(self):
        """Lips forward, fading at the nose's base and over the chin; cheeks in; Cupid's bow flattened."""
        forward = exp(-((self.from_lips / 13) ** 2)) * self.front
        forward = np.where(self.ring > 10, 0, forward)
        forward = np.where(self.ring == 10, 0.25, forward)
        forward = np.where(self.ring == 9, 0.75, forward)
        forward = np.where((self.ring >= 3) & (self.ring <= 8), 1, forward)
        below_nose = smooth_step(-53, -66.5, self.y)
        above = below_nose + (1 - below_nose) * smooth_step(26, 40, self.lateral) * 0.7
        fading = np.where(self.y > MOUTH_Y, above, 1 - smooth_step(-86, -100, self.y))
        forward = np.where(self.ring < 3, forward * fading, forward)
        profile = np.where(self.lateral < 25, 1 - 0.14 * (self.lateral / 25) ** 2, 0.86)

        border = (self.ring == 3) | (self.ring == 4)
        upper_bow = np.interp(self.column, [0, 1, 2, 3, 4, 5, 6, 8], [0.16, -0.10, -0.02, 0.06, 0.10, 0.10, 0.05, 0])
        lower_bow = np.interp(self.column, [8, 10, 11, 12, 13, 14, 16], [0, -0.05, -0.08, -0.07, 0, 0.04, 0.06])
        bow = np.where(border, np.where(self.column <= 8, upper_bow, lower_bow), 0)

        cheek = self.blob(46, -66, 17, 0.9, 0.85) * smooth_step(10, 40, self.z) * (self.ring < 0)
        field = self.vectors(-self.side * 0.10 * self.across * forward, bow, forward * profile)
        return field - 0.42 * cheek[:, None] * self.outward

    def funnel(self):
        """Vermilion turned outward: the border away from the slit, the fullest part forward."""
        away = self.by_ring([0, 2, 3, 4, 5, 6, 7, 8, 9], [0, 0.2, 0.8, 1.2, 1.0, 0.35, 0.1, 0, 0])
        c = cos(self.phase)
        away = np.where(self.mouth, away * np.sign(c) * np.abs(c) ** 0.5 * 2.4, 0)
        forward = self.by_ring([2, 3, 4, 5, 6, 8], [0, 0.3, 1.2, 2.0, 1.4, 0])
        return self.vectors(y=away, z=np.where(self.mouth, forward, 0) * (1 - 0.4 * self.across))

    def upraise(self):
        """Upper lip, 0.72 of it above the lip, the levator's path beside the nose, little on the nose itself."""
        lip = np.where(self.lips, bell(1.25 * (1 - self.column / 8.0)), 0)
        outside = self.ring < 3
        above = exp(-(((self.y + 62) / 13) ** 2)) * exp(-((self.lateral / 30) ** 2)) * self.front
        above *= (self.y > -75) * outside * np.where(self.ring > 0, 1, smooth_step(-20, -45, self.y))
        levator = exp(-(((self.lateral - 22) / 9) ** 2)) * exp(-(((self.y + 46) / 14) ** 2)) * self.front * outside
        nose = (self.ring < 0) & (self.lateral < 16) & (self.y > -56)
        up = (lip + 0.72 * above + 0.28 * levator) * np.where(nose, 0.30, 1)
        return self.vectors(y=up, z=0.12 * lip + 0.12 * levator)

    def lowraise(self):
        lip = np.where(self.lips, bell(1.25 * (self.column - 8) / 8.0), 0)
        below = exp(-(((self.y + 91) / 13) ** 2)) * exp(-((self.lateral / 26) ** 2)) * self.front
        below *= (self.y < -78) * (self.ring < 3)
        return self.vectors(y=lip + 0.66 * below, z=0.10 * lip + 0.12 * below)

    def corners(self):
        """x, y and z of the corners of the mouth."""
        inside = exp(-(((self.column - 8) / 2.6) ** 2))
        inside *= self.by_ring([0, 1, 2, 3, 9, 10, 11], [0, 0.45, 0.72, 1, 1, 0.5, 0])
        weight = np.where(self.mouth, inside, self.blob(27, -76, 13) * self.front * 0.9)
        return self.vectors(x=self.side * weight), self.vectors(y=weight), self.vectors(z=weight)

    def puff(self):
        cheek = self.blob(44, -68, 18, 0.9, 0.8) * self.front * self.by_ring([0, 1, 2, 3], [1, 0.75, 0.4, 0.0])
        lips = exp(-((self.from_lips / 16) ** 2)) * self.front
        lips *= np.where(self.ring >= 0, np.interp(self.ring, [0, 3, 5, 6], [1, 0.7, 0.3, 0]), 1)
        forward = 2.2 * lips * np.where(np.abs(self.y + 76) < 4, 0.4, 1)
        return 7 * self.outward * cheek[:, None] + self.vectors(z=forward)

    def brow(self):
        beside = np.maximum(0, np.abs(self.lateral - 30) - 18)
        up = exp(-(((self.y - 20) / 11) ** 2)) * exp(-((beside / 14) ** 2)) * self.front
        up += 0.35 * exp(-(((self.y - 40) / 15) ** 2)) * exp(-((self.lateral / 50) ** 2)) * self.front
        up *= np.select([self.eye_ring >= 3, self.eye_ring == 2, self.eye_ring == 1], [0, 0.12, 0.55], 1)
        return self.vectors(y=up)

    def lid_travels(self):
        """mm up for full lid closure: negative on the upper lid, positive below, 0 elsewhere and at the canthi."""
        upper_share = {1: 0.05, 2: 0.22, 3: 0.80, 4: 0.90, 5: 0.90, 6: 0.85}
        lower_share = {1: 0.0, 2: 0.04, 3: 0.08, 4: 0.10, 5: 0.10, 6: 0.10}
        travel = np.zeros(len(self.rest))
        for i in np.where(self.eye_ring >= 1)[0]:
            place = (self.eye_column[i] + 2) % 20  # 0 inner canthus, 10 outer, below 10 the upper lid
            if place in (0, 10):
                continue
            upper = place < 10
            t = (place if upper else 20 - place) / 10
            t = 0.35 * (0.5 - 0.5 * cos(pi * t)) + 0.65 * t
            height = skin.lidcurve(t, True)[1] - skin.lidcurve(t, False)[1]
            ring = self.eye_ring[i]
            travel[i] = -height * upper_share[ring] if upper else height * lower_share[ring]
        return travel
