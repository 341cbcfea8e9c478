"""The macro of FreeCAD, run by freecadcmd on a fixture. Exits with 77 without freecadcmd."""
import json
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SOURCE = Path(os.environ["KEIKO_SOURCE_DIR"])
SCRIPT = """
import json, os, runpy, sys, tempfile
import FreeCAD, Part
try:
    macro = runpy.run_path(os.environ["MACRO"], run_name="macro")
    document = FreeCAD.newDocument("Part")
    for name in os.environ["PARTS"].split(":"):
        document.addObject("Part::Feature", "Body").Shape = Part.read(name)
    shapes = list(macro["selected_shapes"](document))
    folder = os.environ["FOLDER"]
    verdict = macro["inspect"](shapes, folder)
    macro["add_lines"](document, folder)
    lines = macro["add_lines"](document, folder)  # in place of the first ones
    said = {"shapes": len(shapes), "verdict": verdict, "labels": [line.Label for line in lines],
            "verdicts": sorted({macro["verdict_of"](line.Label) for line in lines}),
            "edges": sum(len(line.Shape.Edges) for line in lines),
            "length": sum(line.Shape.Length for line in lines), "group": len(document.getObject("Keiko").Group)}
    try:
        os.environ["KEIKO"] = "no-such-program"
        macro["inspect"](shapes, folder)
    except (RuntimeError, OSError) as error:
        said["refused"] = str(error)
except BaseException as error:
    said = {"error": repr(error)}
with open(os.path.join(os.environ["FOLDER"], "said.json"), "w") as file:
    json.dump(said, file)
os._exit(0)
"""


def main() -> int:
    command = next(filter(None, map(shutil.which, ("freecadcmd", "FreeCADCmd", "freecadcmd-python3"))), None)
    if not command:
        print("skipped: there is no freecadcmd")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "run.py"
        script.write_text(SCRIPT, encoding="utf-8")
        part = SOURCE / "surfaces/seam-g1-angle.step"
        environment = {**os.environ, "KEIKO": os.environ["KEIKO_BINARY"], "FOLDER": folder, "PARTS": str(part),
                       "MACRO": str(SOURCE / "docs/examples/keiko.FCMacro")}
        subprocess.run([command, script], env=environment, stdout=subprocess.DEVNULL, timeout=280, check=True)
        said = json.loads((Path(folder) / "said.json").read_text())
    print(said)
    assert "error" not in said, said["error"]
    assert said["shapes"] == 1 and said["verdict"] == "fail", said
    assert said["labels"] and said["group"] == len(said["labels"]), said
    assert all(label.startswith("reflection line ") for label in said["labels"]), said
    assert set(said["verdicts"]) <= {"pass", "undecided", "fail", "not judged"}, said
    assert said["edges"] >= len(said["labels"]) and said["length"] > 100, said
    assert "no-such-program" in said["refused"], said
    return 0


if __name__ == "__main__":
    sys.exit(main())
