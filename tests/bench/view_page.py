#!/usr/bin/env python3
"""Times of a frame in the page of `keiko view`, in Chromium without a graphics card.

usage: tests/bench/view_page.py KEIKO [SCENE...] [--size WxH]

For each scene: a row of lamps dragged in its plane and along its normal, and the eye turned (the last surfaces drawn
from the new eye, and drafts as they come). Least and median of the page's own times by performance.now(), in ms, and the processor
time of the page's main thread a frame, which other work on the machine changes less.
"""
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import browser
import view_arguments
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

COLLECT = """window.frames_taken = [];
new MutationObserver(() => frames_taken.push(Number(document.getElementById('picture').dataset.frame)))
  .observe(document.getElementById('picture'), {attributeFilter: ['data-frame']});"""


def renderers(process: int) -> list:
    """Numbers of the page processes below a process."""
    found = []
    for children in Path(f"/proc/{process}/task").glob("*/children"):
        for child in map(int, children.read_text().split()):
            found += renderers(child)
            if b"--type=renderer" in Path(f"/proc/{child}/cmdline").read_bytes():
                found.append(child)
    return found


class Page:
    def __init__(self, driver, address: str):
        self.driver = driver
        driver.get(address)
        self.picture = driver.find_element(By.ID, "picture")
        self.wait()
        driver.execute_script(COLLECT)

    def wait(self):
        """Waits for the exact picture: nothing is drawn after it."""
        end = time.monotonic() + 120
        while "exact" not in (state := self.driver.find_element(By.ID, "state").text):
            if time.monotonic() > end:
                raise RuntimeError(f"the page says: {state}")
            time.sleep(0.1)

    def busy(self) -> float:
        """Processor time of the main threads of the page's processes, ms."""
        return sum(int(Path(f"/proc/{p}/task/{p}/schedstat").read_text().split()[0])
                   for p in renderers(self.driver.service.process.pid)) / 1e6

    def report(self, name: str, act):
        self.driver.execute_script("frames_taken.length = 0")
        before = self.busy()
        act()
        after = self.busy()
        taken = self.driver.execute_script("return frames_taken")
        if taken:
            print(f"  {name:16} least {min(taken):6.1f}, median {statistics.median(taken):6.1f} ms of {len(taken)} frames; "
                  f"{(after - before) / len(taken):.0f} ms of processor a frame")

    def drag(self, element, key=None, steps: int = 40):
        actions = ActionChains(self.driver, duration=30).move_to_element(element)
        if key:
            actions.key_down(key)
        actions.click_and_hold()
        for step in range(steps):
            actions.move_by_offset(3 if step < steps / 2 else -3, 1 if step % 2 else -1)
        actions.perform()

    def release(self, key=None):
        actions = ActionChains(self.driver).release()
        if key:
            actions.key_up(key)
        actions.perform()
        self.wait()


def bench(keiko: str, scene: Path, size: str):
    with tempfile.TemporaryDirectory(prefix="keiko-bench-", ignore_cleanup_errors=True) as profile:
        process = subprocess.Popen([keiko, "view", scene, "--no-browser", "--size", size], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        driver = browser.browser(profile, profile)
        try:
            page = Page(driver, process.stdout.readline().strip())
            print(f"{scene.name}, {size}:")
            page.report("row in its plane", lambda: page.drag(page.picture, Keys.CONTROL))
            page.release(Keys.CONTROL)
            for handle in driver.find_elements(By.CSS_SELECTOR, "#gizmo circle[data-move=normal]"):
                page.report("row along normal", lambda: page.drag(handle))
                page.release()
            page.report("eye", lambda: page.drag(page.picture))
            page.release()
        finally:
            driver.quit()
            process.terminate()
            process.wait()


def main():
    arguments = view_arguments.parser().parse_args()
    for scene in arguments.scenes:
        bench(arguments.keiko, scene, arguments.size)


if __name__ == "__main__":
    main()
