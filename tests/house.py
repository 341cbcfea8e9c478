"""The house: which room of src/keiko may include which, and which chambers a room has.

ROOMS names for each room, from the bottom up, the rooms that it is built on. It may include these,
what those may include, and itself. CHAMBERS does the same for the folders inside a room: a chamber
may include those that it names and what those may include. Files that lie in a room itself, beside
its chambers, may include every chamber, and no chamber includes them.
EXTERNAL keeps each third-party library inside the room that adapts it.
FRONT_ENDS see the rooms that they name and nothing below these, so that they hold no logic.
"""

ROOMS = {
    "base": set(),
    "math": {"base"},
    "simd": {"math"},
    "geometry": {"math"},
    "intersect": {"geometry"},
    "visibility": {"intersect"},
    "light": {"geometry", "simd"},
    "scene": {"geometry", "light"},
    "film": {"math"},
    "maps": {"scene", "film"},
    "volumes": {"scene", "film"},
    "texels": {"maps", "volumes"},
    "raster": {"intersect", "scene", "film"},
    "radiosity": {"visibility", "light", "raster"},
    "files": {"scene"},
    "import": {"files"},
    "render": {"light", "maps", "texels", "radiosity"},
    "placement": {"intersect", "scene"},
    "inspect": {"intersect", "scene"},
    "drawing": {"visibility", "inspect"},
    "triage": {"inspect"},
    "compare": {"inspect", "film"},
    "report": {"triage", "placement", "compare", "film", "raster"},
    "export": {"drawing", "report"},
    "workflow": {"import", "render", "export"},
    "stream": {"workflow"},
    "batch": {"workflow"},
    "regress": {"batch"},
    "api": {"stream", "regress"},
    "viewer": {"api", "base"},
    "cli": {"api", "base", "viewer"},
    "python": {"api", "base"},
}
FRONT_ENDS = {"cli", "python", "viewer"}
CHAMBERS = {
    "geometry": {
        "bernstein": set(),
        "bezier": {"bernstein"},
        "rays": set(),
        "model": {"bezier"},
        "trim": {"model"},
        "bvh": set(),
        "seam": {"model", "bvh"},
    },
    "intersect": {
        "roots": set(),
        "subpatch": {"roots"},
        "kernels": {"subpatch"},
        "hit": {"kernels"},
        "traversal": {"hit"},
    },
    "visibility": {
        "nets": set(),
        "boundaries": set(),
        "silhouettes": {"nets", "boundaries"},
        "contours": {"silhouettes"},
        "query": {"silhouettes"},
        "epipolar": {"query"},
    },
    "light": {
        "luminance": set(),
        "penumbra": {"luminance"},
        "tubes": {"penumbra"},
        "areas": {"penumbra"},
        "lines": {"luminance"},
        "spotlight": {"luminance"},
        "fog": {"luminance"},
        "glass": {"luminance", "fog"},
        "sky": {"areas", "fog"},
        "rig": {"tubes", "areas", "lines", "spotlight", "fog", "sky"},
    },
    "files": {
        "toml": set(),
        "photometric": set(),
        "model": {"toml", "photometric"},
        "scan": set(),
        "scene": {"toml", "photometric"},
    },
    "import": {
        "cad": set(),
        "subdivision": set(),
        "worker": {"cad", "subdivision"},
    },
    "render": {
        "reflection": set(),
        "caustics": set(),
        "shading": {"reflection", "caustics"},
        "lighting": {"shading"},
        "antialias": {"lighting"},
    },
    "inspect": {
        "basics": set(),
        "seams": {"basics"},
        "openings": {"seams"},
        "overlaps": {"openings", "structure"},
        "lines": {"seams"},
        "combs": {"basics"},
        "flaws": {"seams"},
        "regularity": {"basics"},
        "curvature": {"flaws", "regularity"},
        "structure": {"seams"},
        "joints": {"openings", "flaws"},
    },
    "drawing": {
        "curves": set(),
        "hidden": {"curves"},
        "sheet": {"hidden"},
    },
    "compare": {
        "alignment": set(),
        "shape": {"alignment"},
        "outlines": {"alignment"},
        "scan": {"shape"},
    },
    "report": {
        "markup": set(),
        "content": {"markup"},
        "json": {"content"},
        "mesh": {"content"},
        "html": {"content"},
        "junit": {"content"},
        "sarif": {"content"},
        "svg": {"content"},
        "csv": {"json"},
        "text": {"json"},
    },
}
EXTERNAL = {
    "embree3/": {"intersect"},
    "hwy/": {"intersect", "simd"},
    "opensubdiv/": {"import/subdivision"},
    ".hxx": {"import/cad"},
    "OpenImageIO/": {"film"},
    "toml++/": {"files/toml"},
    "nlohmann/": {"files", "report/markup"},
    "Imath/": {"math"},
    "tbb/": {"base"},
    "pybind11/": {"python"},
    "oneapi/": {"base"},
    "spdlog/": {"base"},
    "fmt/": {"base"},
    "CLI/": {"cli"},
    "httplib.h": {"viewer"},
}


def reachable(graph: dict, start: str) -> set:
    """`start`, all that it names, and what those may include."""
    found, todo = {start}, [start]
    while todo:
        for lower in graph[todo.pop()] - found:
            found.add(lower)
            todo.append(lower)
    return found


def home(parts: tuple) -> str:
    """Room or room/chamber of a file's path below src/keiko."""
    return "/".join(parts[:-1])


def may_include(user: str, used: str) -> bool:
    """Whether a file in `user` may include one in `used`: rooms, or rooms with a chamber."""
    room, _, chamber = user.partition("/")
    other, _, inner = used.partition("/")
    if room != other:
        return other in (ROOMS[room] if room in FRONT_ENDS else reachable(ROOMS, room))
    if not chamber:
        return True
    return bool(inner) and inner in reachable(CHAMBERS[room], chamber)
