"""The bundle of keiko view's page is what its sources make, where the tools of ./dev web are installed."""
import filecmp
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WEB, TOOLS = ROOT / "src/keiko/viewer/web", ROOT / "build/web/node_modules"
SKIPPED = 77


def main() -> int:
    if not TOOLS.is_dir() or not shutil.which("npm"):
        print("skipped: ./dev web has not installed the page's tools")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="keiko-web-") as name:
        folder = Path(name)
        shutil.copytree(WEB, folder, dirs_exist_ok=True)
        (folder / "bundle/viewer.js").unlink()
        (folder / "node_modules").symlink_to(TOOLS)
        subprocess.run(["npm", "run", "--silent", "build"], cwd=folder, check=True)
        if filecmp.cmp(folder / "bundle/viewer.js", WEB / "bundle/viewer.js", shallow=False):
            return 0
        print("the bundle is not what its sources make: ./dev web")
        return 1


if __name__ == "__main__":
    sys.exit(main())
