#!/usr/bin/env python3
"""Makes the film of the readme and the pictures of docs/viewer.md from the page of `keiko view`.

usage: docs/make_film.py KEIKO [FILM.webp | --pictures]

A row of lamps is dragged over the concept car, then the car is turned. Needs chromium, chromium-driver,
python3-selenium and python3-pil.
"""
import base64
import io
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests"))
import browser
from PIL import Image
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

IMAGES = ROOT / "docs/images"
SIZE = "800x450"
SHOWN = (640, 360)   # pixels of the film
FRAME = 70           # ms
LOOKS = ("lamps", "zebra", "isophotes", "highlight lines", "curvature", "radius", "draft", "faces")


class Page:
    def __init__(self, keiko: str, scene: str, size: str):
        self.folder = tempfile.TemporaryDirectory(prefix="keiko-film-", ignore_cleanup_errors=True)
        self.process = subprocess.Popen([keiko, "view", ROOT / "surfaces" / scene, "--no-browser", "--size", size],
                                        text=True, stdout=subprocess.PIPE)
        self.driver = browser.browser(self.folder.name, self.folder.name, "1400,800")
        self.driver.get(self.process.stdout.readline().strip())
        self.picture = self.driver.find_element(By.ID, "picture")
        self.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.driver.quit()
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def wait(self):
        """Until the exact picture is there."""
        end = time.monotonic() + 120
        while self.driver.execute_script("return document.getElementById('still').hidden"):
            if time.monotonic() > end:
                raise RuntimeError(self.driver.find_element(By.ID, "state").text)
            time.sleep(0.1)

    def canvas(self, name: str = "picture") -> Image.Image:
        """A canvas as it is drawn."""
        address = self.driver.execute_script(
            "return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => "
            f"done(document.getElementById('{name}').toDataURL()))))")
        return Image.open(io.BytesIO(base64.b64decode(address.partition(",")[2]))).convert("RGB")

    def overlay(self, name: str, key: str):
        """Draws lines over the picture by a key, and waits for them."""
        self.picture.send_keys(key)
        end = time.monotonic() + 120
        while (self.driver.execute_script(f"return document.getElementById('{name}').width") == 0
               or "judging" in self.driver.find_element(By.ID, "state").text):
            if time.monotonic() > end:
                raise RuntimeError(self.driver.find_element(By.ID, "state").text)
            time.sleep(0.1)
        time.sleep(1)

    def look(self, name: str):
        self.driver.find_element(By.XPATH, f"//button[text()='{name}']").click()
        time.sleep(2)


def dragged(page: Page, x: int, y: int, steps: int, key: str | None) -> list[Image.Image]:
    """Frames of a drag there and back, with a key held."""
    actions = ActionChains(page.driver, duration=20).move_to_element(page.picture)
    (actions.key_down(key) if key else actions).click_and_hold().perform()
    frames = []
    for step in range(2 * steps):
        way = 1 if step < steps else -1
        ActionChains(page.driver, duration=20).move_by_offset(way * x, way * y).perform()
        frames.append(page.canvas().resize(SHOWN, Image.LANCZOS))
    actions = ActionChains(page.driver).release()
    (actions.key_up(key) if key else actions).perform()
    return frames


def film(keiko: str, file: Path):
    with Page(keiko, "concept-car-scene.toml", SIZE) as page:
        frames = dragged(page, 8, 0, 18, Keys.CONTROL)
        page.wait()
        frames += dragged(page, -5, 0, 12, None)
    frames[0].save(file, save_all=True, append_images=frames[1:], duration=FRAME, loop=0, quality=60, method=6)
    print(f"{file}: {len(frames)} frames, {file.stat().st_size / 1e6:.2f} MB")


def pictures(keiko: str):
    with Page(keiko, "concept-car-scene.toml", "960x540") as page:
        page.overlay("seam-lines", "s")
        page.driver.save_screenshot(str(IMAGES / "viewer.png"))
        page.picture.send_keys("s")
        page.overlay("lamp-lines", "r")
        page.driver.execute_script("document.getElementById('lines').parentElement.scrollIntoView()")
        page.driver.save_screenshot(str(IMAGES / "viewer-lines.png"))
    with Page(keiko, "hood-scene.toml", "480x270") as page:
        sheet = Image.new("RGB", (4 * 480, 2 * 270))
        for number, name in enumerate(LOOKS):
            page.look(name)
            sheet.paste(page.canvas(), (number % 4 * 480, number // 4 * 270))
    sheet.save(IMAGES / "viewer-looks.png", optimize=True)
    with Page(keiko, "hood-scene.toml", "960x540") as page:
        analysis_picture(page)


def analysis_picture(page: Page):
    """A section that was turned by hand, a note, a kept view, and the part of the panel that has them."""
    page.picture.click()
    page.driver.find_element(By.CSS_SELECTOR, "#note input").send_keys("sinks towards the lamp" + Keys.ENTER)
    page.driver.find_element(By.XPATH, "//button[text()='keep this view']").click()
    ActionChains(page.driver).move_to_element(page.picture).key_down(Keys.CONTROL).key_down(Keys.SHIFT).click_and_hold() \
        .move_by_offset(-80, 20).release().key_up(Keys.SHIFT).key_up(Keys.CONTROL).perform()
    time.sleep(3)
    page.driver.execute_script("document.getElementById('section').parentElement.scrollIntoView()")
    page.driver.save_screenshot(str(IMAGES / "viewer-analysis.png"))


def main():
    keiko, file = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else str(IMAGES / "viewer.webp")
    if file != "--pictures":
        film(keiko, Path(file))
    pictures(keiko)


if __name__ == "__main__":
    main()
