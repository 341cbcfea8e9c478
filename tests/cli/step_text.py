"""A STEP file as text, changed in one place at a time: what a revision of a part may differ by."""
import math
import re
from pathlib import Path

NUMBER = r"[-+]?\d+\.\d*(?:[eE][-+]?\d+)?"


def real(x: float) -> str:
    """As [ISO10303-21] has it: a point, and a large E before an exponent."""
    mantissa, e, exponent = repr(float(x)).partition("e")
    return mantissa + ("" if "." in mantissa else ".") + ("E" + exponent if e else "")


class StepText:
    """Entities by number; everything else stays as it is."""

    def __init__(self, path):
        text = Path(path).read_text()
        self.head, rest = text.split("DATA;", 1)
        data, self.tail = rest.split("ENDSEC;", 1)
        self.entities = {int(number): " ".join(body.split())
                         for number, body in re.findall(r"#(\d+)\s*=\s*(.*?);\s*(?=#\d+\s*=|\s*$)", data, re.S)}

    def write(self, path):
        lines = [f"#{number}={body};" for number, body in self.entities.items()]
        Path(path).write_text(self.head + "DATA;\n" + "\n".join(lines) + "\nENDSEC;" + self.tail)

    def of_type(self, name: str) -> list:
        return [number for number, body in self.entities.items() if re.search(rf"\b{name}\b\s*\(", body)]

    def references(self, number: int) -> list:
        return [int(n) for n in re.findall(r"#(\d+)", self.entities[number])]

    def point(self, number: int) -> list:
        coordinates = self.entities[number].split("(", 1)[1].split("(", 1)[1]
        return [float(n) for n in re.findall(NUMBER, coordinates)]

    def move(self, number: int, *offset: float):
        place = [a + b for a, b in zip(self.point(number), offset)]
        self.entities[number] = "CARTESIAN_POINT('',(" + ",".join(real(x) for x in place) + "))"

    def add(self, body: str) -> int:
        number = max(self.entities) + 1
        self.entities[number] = body
        return number

    def place(self, *levels: list):
        """Shows the body at places alone, given as (axes x, y and z, scale, origin) of each operator. Each
        level places all of the one before."""
        shown, = self.of_type("SHAPE_DEFINITION_REPRESENTATION")
        body = self.references(shown)[-1]
        origin, *_, context = self.references(body)
        for placements in levels:
            mapping = self.add(f"REPRESENTATION_MAP(#{origin},#{self.add(self.entities[body])})")
            items = [self.add(f"MAPPED_ITEM('',#{mapping},#{self.operator(*placement)})") for placement in placements]
            listed = ",".join(f"#{n}" for n in [origin] + items)
            self.entities[body] = f"SHAPE_REPRESENTATION('',({listed}),#{context})"

    def operator(self, axes, scale: float, origin) -> int:
        x, y, z = (self.add("DIRECTION('',(" + ",".join(real(c) for c in axis) + "))") for axis in axes)
        place = self.add("CARTESIAN_POINT('',(" + ",".join(real(c) for c in origin) + "))")
        return self.add(f"CARTESIAN_TRANSFORMATION_OPERATOR_3D('','',$,#{x},#{y},#{place},{real(scale)},#{z})")

    def faces(self) -> list:
        return self.of_type("ADVANCED_FACE")

    def surface_of(self, face: int) -> int:
        return self.references(face)[-1]

    def net(self, surface: int) -> list:
        """Rows of control points."""
        rows = re.search(r"\(\s*(\(#[^()]*\)(?:\s*,\s*\(#[^()]*\))*)\s*\)", self.entities[surface])[1]
        return [[int(n) for n in re.findall(r"#(\d+)", row)] for row in re.findall(r"\(([^()]*)\)", rows)]

    def move_inner_point(self, face: int, millimetres: float):
        net = self.net(self.surface_of(face))
        self.move(net[len(net) // 2][len(net[0]) // 2], 0, 0, millimetres)

    def tilt_at_end(self, face: int, degrees: float):
        """Turns the tangents across the border where the first parameter ends."""
        net = self.net(self.surface_of(face))
        for edge, inner in zip(net[-1], net[-2]):
            reach = math.dist(self.point(edge), self.point(inner))
            self.move(inner, 0, 0, reach * math.tan(math.radians(degrees)))

    def kink_at_side(self, face: int, degrees: float, at_end: bool):
        """Turns the tangents across the middle of the border at which the second parameter begins or ends.
        The two points that move change curvatures at the borders beside it, and no border."""
        net = self.net(self.surface_of(face))
        rows = [row[::-1] for row in net] if at_end else net
        middle = len(rows) // 2
        for before, row, after in zip(rows, rows[1:], rows[2:]):
            if row not in (rows[middle - 1], rows[middle]):
                continue
            edge, inner = self.point(row[0]), self.point(row[1])
            across = [b - a for a, b in zip(edge, inner)]
            along = [b - a for a, b in zip(self.point(before[0]), self.point(after[0]))]
            normal = [across[1] * along[2] - across[2] * along[1], across[2] * along[0] - across[0] * along[2],
                      across[0] * along[1] - across[1] * along[0]]
            reach = math.hypot(*across) * math.tan(math.radians(degrees)) / math.hypot(*normal)
            self.move(row[1], *(reach * n for n in normal))

    def change_weight(self, face: int, factor: float):
        """Of the middle control point."""
        surface = self.surface_of(face)
        head, weights = self.entities[surface].split("RATIONAL_B_SPLINE_SURFACE", 1)
        numbers = list(re.finditer(NUMBER, weights))
        middle = numbers[len(numbers) // 2]
        changed = real(float(middle[0]) * factor)
        self.entities[surface] = (head + "RATIONAL_B_SPLINE_SURFACE" + weights[:middle.start()] + changed
                                  + weights[middle.end():])

    def change_knot(self, face: int, share: float):
        """Moves an inner knot of the second parameter by a share of the next span."""
        surface = self.surface_of(face)
        lists = list(re.finditer(rf"\((?:{NUMBER}\s*,\s*)+{NUMBER}\)", self.entities[surface]))[-1]
        knots = [float(n) for n in re.findall(NUMBER, lists[0])]
        middle = len(knots) // 2
        knots[middle] += share * (knots[middle + 1] - knots[middle])
        changed = "(" + ",".join(real(k) for k in knots) + ")"
        body = self.entities[surface]
        self.entities[surface] = body[:lists.start()] + changed + body[lists.end():]

    def move_inner_loop(self, face: int, millimetres: float, width: float):
        """Moves a hole along x; `width` is how many mm a unit of the first parameter is."""
        loop = self.references(self.references(face)[1])[0]
        for oriented in self.references(loop):
            edge = self.references(oriented)[-1]
            curve = self.references(edge)[-1]
            space, pcurve = self.references(curve)[:2]
            flat = self.references(self.references(pcurve)[-1])[0]
            for number in self.references(space):
                self.move(number, millimetres, 0, 0)
            for number in self.references(flat):
                self.move(number, millimetres / width, 0)

    def drop_face(self, face: int):
        for shell in self.of_type("OPEN_SHELL") + self.of_type("CLOSED_SHELL"):
            inside = [n for n in self.references(shell) if n != face]
            name = self.entities[shell].split("(", 1)[0]
            self.entities[shell] = f"{name}('',(" + ",".join(f"#{n}" for n in inside) + "))"

    def flip_face(self, face: int):
        body = self.entities[face]
        sense = re.search(r"\.([TF])\.\s*\)$", body)
        self.entities[face] = body[:sense.start(1)] + ("F" if sense[1] == "T" else "T") + body[sense.end(1):]
