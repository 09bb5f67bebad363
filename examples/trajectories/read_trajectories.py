"""Reads a store of trajectories, `trajectories.bin`, without other packages; docs/trajectories.md describes its bytes.

    store = Store("out/trajectories.bin")
    runouts = [math.dist(rock["release"][0][:2], rock["end"][0][:2])
               for rock in (store.read(place) for place in range(len(store.rocks)))]
    print(sum(runouts) / len(runouts))   # mean distance on plan between release and end [m]
"""

import math
import struct

STATES = ["projectile", "impact", "sliding", "rolling", "barrier", "ended"]


class Bytes:
    def __init__(self, data, at=0):
        self.data, self.at = data, at

    def get(self, code):
        (value,) = struct.unpack_from("<" + code, self.data, self.at)
        self.at += struct.calcsize("<" + code)
        return value

    def varint(self):
        value = shift = 0
        while True:
            byte = self.get("B")
            value |= (byte & 127) << shift
            if byte < 128:
                return value
            shift += 7

    def signed(self):
        value = self.varint()
        return -(value + 1) // 2 if value & 1 else value // 2

    def text(self):
        size = self.get("Q")
        self.at += size
        return self.data[self.at - size:self.at].decode()

    def array(self, code, count):
        values = struct.unpack_from(f"<{count}{code}", self.data, self.at)
        self.at += struct.calcsize(f"<{count}{code}")
        return list(values)

    def vector(self, code, planar):
        return [self.get(code), 0.0 if planar else self.get(code), self.get(code)]

    def spin(self, code, planar):
        return [0.0, self.get(code), 0.0] if planar else self.vector(code, False)

    def steps(self, step, planar):
        return [step * self.signed(), 0.0 if planar else step * self.signed(), step * self.signed()]

    def spin_steps(self, step, planar):
        return [0.0, step * self.signed(), 0.0] if planar else self.steps(step, False)


def add(a, b):
    return [x + y for x, y in zip(a, b)]


class Store:
    def __init__(self, name):
        with open(name, "rb") as file:
            data = file.read()
        if data[:16] != b"talus trajectory":
            raise ValueError("not a store of trajectories")
        version, _, size = struct.unpack_from("<IIQ", data, 16)
        if version not in (1, 2):
            raise ValueError("another format")
        head = Bytes(data, 32)
        self.version = head.text()
        self.is_section, self.is_sphere = head.get("B") == 1, head.get("B") != 0
        self.origin, self.gravity = head.array("d", 3), head.array("d", 3)
        self.datum = head.get("d")
        self.seed, self.planned, self.ensembles = head.array("Q", 3)
        self.seeders, self.sources, self.materials = (
            [head.text() for _ in range(head.get("Q"))] for _ in range(3))
        self.corner, self.cell = head.array("d", 2), head.get("d")
        self.columns, self.rows = head.array("I", 2)
        self.done, self.row_count = head.array("Q", 2)
        self.largest_radius = head.get("d")
        self.rocks = head.array("Q", head.get("Q"))
        self.ends = head.array("Q", len(self.rocks))
        head.array("I", len(self.rocks))  # checksums
        head.get("Q")
        self.cells = head.at
        self.paths = 32 + size
        self.data = data

    def rocks_in(self, x, y=0.0):
        """The places in `rocks` of those that were in the cell of a place, in the project's coordinates."""
        column = min(max(int((x - self.origin[0] - self.corner[0]) // self.cell), 0), self.columns - 1)
        row = min(max(int((y - self.origin[1] - self.corner[1]) // self.cell), 0), self.rows - 1)
        wanted = row * self.columns + column
        data = Bytes(self.data, self.cells)
        places = []
        for place in range(len(self.rocks)):
            begin = 0
            for _ in range(data.varint()):
                begin += data.varint()
                end = begin + data.varint()
                if begin <= wanted < end:
                    places.append(place)
                begin = end
        return places

    def read(self, place):
        """The rock at a place in `rocks`: its facts, its rows [state, motion] and its pieces."""
        begin = self.ends[place - 1] if place > 0 else 0
        data = Bytes(self.data[self.paths + begin:self.paths + self.ends[place]])
        flags = data.varint()
        planar = bool(flags & 1)
        rock = {"rock": self.rocks[place], "was_lifted": bool(flags & 2)}
        rock["seeder"], rock["source"] = self.seeders[data.varint()], self.sources[data.varint()]
        rock["reason"], rock["contacts"] = data.varint(), data.varint()
        rock["ground"] = self.materials[data.varint()] if flags & 4 else None
        rock["mass"], rock["radius"] = mass, radius = data.array("d", 2)
        spin_step = 2**-20 / (radius if radius > 0 else 1.0)
        rock["inertia"] = data.get("d") if flags & 8 else 0.4 * mass * radius * radius
        rock["max_energy"], rock["max_bounce"] = data.array("d", 2)
        zero = [0.0, 0.0, 0.0]
        p = data.vector("d", planar)
        v = zero if flags & 16 else data.vector("d", planar)
        w = zero if flags & 32 else data.spin("d", planar)
        t = 0.0
        rock["release"] = (p, v, w, t)
        end = [None, None, None, None]
        if flags & 64:
            end[0] = data.vector("d", planar)
        if flags & 128:
            end[3] = data.get("d")
        if flags & (256 | 512):
            end[1] = data.vector("d", planar) if flags & 256 else zero
        if flags & (1024 | 2048):
            end[2] = data.spin("d", planar) if flags & 1024 else zero
        if flags & 4096:
            rock["axes"], rock["moments"] = data.array("d", 3), data.array("d", 3)
            rock["short_axis_share"] = data.get("d")
            rock["attitudes"] = [(data.get("d"), data.array("d", 4), data.array("d", 3))
                                 for _ in range(data.varint())]
        rows, pieces, waiting, last_rate = [], [], [], 0.0
        while data.at < len(data.data):
            tag = data.get("B")
            if tag < 128:
                where = tag // 16
                motion = (p, v, w, t)
                if where == 2:
                    time = data.get("d")
                    motion = (data.vector("d", planar), data.vector("d", planar), data.spin("d", planar), time)
                rows.append([STATES[tag % 8], motion])
                if where == 1:
                    waiting.append(rows[-1])
                if where == 3:
                    rows[-1][1] = end
                continue
            on_ground = bool(tag & 64)
            if tag & 1:
                p = data.vector("d", planar)
            if tag & 2:
                t = data.get("d")
            if tag & 4:
                v = add(v, data.steps(2**-20, planar)) if on_ground else data.vector("d", planar)
            if tag & 8:
                w = add(w, data.spin_steps(spin_step, planar)) if on_ground else data.spin("d", planar)
            for row in waiting:
                row[1] = (p, v, w, t)
            waiting = []
            start = (p, v, w, t)
            if not on_ground:
                last_rate = data.get("d") if tag & 32 else last_rate
                rate, a = (last_rate, [0.0, 0.0, data.get("d")]) if tag & 16 else (0.0, self.gravity)
                s = data.get("d")
                pieces.append({"on_ground": False, "start": start, "duration": s, "a": a, "rate": rate})
                g = self.gravity
                v0 = v
                p = [x + s * y + (0.5 * s * s) * z for x, y, z in zip(p, v, a)]
                if rate == 0:
                    v, t = [y + s * z for y, z in zip(v0, a)], t + s
                else:
                    v = [(1 - rate * s) * y + s * z for y, z in zip(v0, g)]
                    t = t - math.log1p(-rate * s) / rate
            else:
                duration = 0.0
                if not tag & 16:
                    duration = 2**-20 * data.varint()
                    way, u = data.steps(2**-20, planar), v
                    expected = [2 / duration * x - y for x, y in zip(way, u)] if duration > 0 else u
                    v = add(expected, data.steps(2**-20, planar))
                    if tag & 32:
                        speed = math.hypot(*u)
                        growth = math.hypot(*v) / speed if speed > 0 else 1.0
                        w = add([growth * x for x in w], data.spin_steps(spin_step, planar))
                    p, t = add(p, way), t + duration
                pieces.append({"on_ground": True, "start": start, "duration": duration, "end": (p, v, w, t)})
        for k, value in enumerate((p, v, w, t)):
            if end[k] is None:
                end[k] = value
        rock["end"], rock["rows"], rock["pieces"] = end, rows, pieces
        return rock
