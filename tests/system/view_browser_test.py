"""The page of keiko view in a real browser. Exits with 77 where there is none, unless CI is set."""
import base64
import json
import math
import os
import re
import sys
import tempfile
import time
import tomllib
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE.parent), str(HERE.parent / "cli")]
import browser
import png_file
from keiko_process import ASLANT, KeikoTest, surface
from view_test import Server

if browser.webdriver:
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys

SKIPPED = 77
# Reflections alone: nothing of the picture is the paint's own light.
SCENE = """format = "keiko-scene/1"
background = 36
ambient = 300
[[model]]
file = "%s"
material = "mirror"
[camera]
eye = [-1700, -1300, 2000]
target = [560, 0, 720]
vertical_fov = 21.5
size = [480, 270]
[[c_plane]]
origin = [-1000, -3000, 2600]
u = [12000, 0, 0]
v = [0, 6000, 0]
lamps = 20
diameter = 120
"""


class Page(KeikoTest):
    def setUp(self):
        super().setUp()
        self.write("scene.toml", SCENE % surface("hood.step"))
        profile = tempfile.TemporaryDirectory(prefix="keiko-browser-", ignore_cleanup_errors=True)
        self.addCleanup(profile.cleanup)
        self.browser = browser.browser(profile.name, str(self.folder / "downloads"))
        self.addCleanup(self.browser.quit)
        self.open("scene.toml")

    def open(self, *arguments: str):
        """Shows what another server has."""
        self.server = Server(self.folder, *arguments)
        self.addCleanup(self.server.close)
        self.browser.get(self.server.address)
        self.wait_for(lambda: "surfaces in" in self.state() or "exact" in self.state())

    def state(self) -> str:
        return self.browser.find_element(By.ID, "state").text

    def wait_for(self, condition, seconds: float = 30):
        end = time.monotonic() + seconds
        while not condition():
            self.assertLess(time.monotonic(), end, f"state: {self.state()}, log: {self.browser.get_log('browser')}")
            time.sleep(0.05)

    def wait_for_still(self):
        self.wait_for(lambda: self.browser.execute_script("return !document.getElementById('still').hidden"))

    def canvas(self, name: str = "picture") -> bytes:
        """The canvas as it is drawn, as a PNG."""
        address = self.browser.execute_script(
            "return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => "
            f"done(document.getElementById('{name}').toDataURL()))))")
        return base64.b64decode(address.partition(",")[2])

    def pixels(self, png: bytes, name: str = "picture.png") -> list:
        (self.folder / name).write_bytes(png)
        return self.file_pixels(name)

    def file_pixels(self, name: str) -> list:
        """Red, green and blue of each pixel of a file."""
        _, _, channels, samples = png_file.read_png(self.folder / name)
        return [samples[i:i + 3] for i in range(0, len(samples), channels)]

    def rested(self) -> list:
        """The canvas after it has been drawn and its bent pixels have been divided."""
        before = None
        while (now := self.pixels(self.canvas())) != before:
            before = now
            time.sleep(0.3)
        return now

    def press(self, name: str):
        self.browser.find_element(By.XPATH, f"//button[text()='{name}']").click()

    def drag(self, x: int, y: int, key=None):
        canvas = self.browser.find_element(By.ID, "picture")
        actions = ActionChains(self.browser).move_to_element(canvas)
        if key:
            actions.key_down(key)
        actions.click_and_hold().move_by_offset(x // 2, y // 2).move_by_offset(x - x // 2, y - y // 2).release()
        if key:
            actions.key_up(key)
        actions.perform()

    def errors(self) -> list:
        return [entry["message"] for entry in self.browser.get_log("browser") if entry["level"] == "SEVERE"]

    def text(self, identity: str) -> str:
        return self.browser.find_element(By.ID, identity).text


def differences(a: list, b: list) -> tuple:
    """Mean over all channels, and the share of the pixels with a channel that differs by more than 3."""
    off = [[abs(x - y) for x, y in zip(p, q)] for p, q in zip(a, b)]
    return sum(map(sum, off)) / (3 * len(off)), sum(max(pixel) > 3 for pixel in off) / len(off)


def numbers_of(driver) -> str:
    """The normal of the section in its line."""
    return driver.find_element(By.CSS_SELECTOR, "#section input[aria-label='normal of the section']").get_attribute("value")


class Pictures(Page):
    def test_the_canvas_shows_what_render_does(self):
        self.succeed("render", "scene.toml", "-o", "render.png", "--edge-samples", "1")
        mean, beyond = differences(self.pixels(self.canvas()), self.file_pixels("render.png"))
        self.assertLess(mean, 0.01)
        self.assertEqual(beyond, 0)
        self.assertEqual(self.errors(), [])

    def test_lamps_that_were_dragged_are_those_of_render(self):
        before = self.pixels(self.canvas())
        self.drag(70, 40, Keys.CONTROL)
        self.wait_for_still()
        moved = self.pixels(self.canvas())
        self.assertGreater(differences(before, moved)[1], 0.1)
        self.press("save")
        rig = self.saved("rig.toml")
        self.succeed("render", "scene.toml", "-o", "render.png", "--edge-samples", "1", "--rig", rig)
        mean, beyond = differences(moved, self.file_pixels("render.png"))
        self.assertLess(mean, 0.01)
        self.assertEqual(beyond, 0)

    def test_a_dragged_stripe_stays_under_the_mouse(self):
        def is_bright(picture: list, x: int, y: int) -> bool:
            return picture[480 * y + x][1] > 128

        def is_amid(picture: list, x: int, y: int) -> bool:
            around = {is_bright(picture, x + dx, y + dy) for dx in range(-3, 4) for dy in range(-3, 4)}
            return len(around) == 1

        canvas = self.browser.find_element(By.ID, "picture")
        scale = canvas.size["width"] / 480
        for bright in (True, False):
            before = self.rested()
            x, y = next((x, y) for y in range(120, 160) for x in range(200, 280)
                        if is_amid(before, x, y) and is_bright(before, x, y) == bright)
            actions = ActionChains(self.browser)
            actions.move_to_element_with_offset(canvas, (x + 0.5 - 240) * scale, (y + 0.5 - 135) * scale)
            actions.key_down(Keys.CONTROL).click_and_hold()
            for _ in range(8):
                actions.move_by_offset(round(2 * scale), round(scale))
            actions.release().key_up(Keys.CONTROL).perform()
            after = self.rested()
            self.assertNotEqual(after, before)
            self.assertEqual(is_bright(after, x + 16, y + 8), bright, (x, y))

    def saved(self, name: str) -> str:
        file = self.folder / "downloads" / name
        self.wait_for(file.exists)
        return str(file)

    def test_the_still_at_rest_is_the_picture_of_render(self):
        self.drag(90, 0)
        self.wait_for_still()
        self.press("save view")
        view = self.saved("view.toml")
        self.succeed("render", "scene.toml", "-o", "render.png", "--view", view)
        self.assertEqual(self.pixels(self.canvas("still")), self.file_pixels("render.png"))

    def test_each_look_fills_the_surface(self):
        lamps = self.pixels(self.canvas())
        for name, key in (("zebra", "z"), ("isophotes", "i"), ("highlight lines", "h"), ("curvature", "c"), ("radius", "m"), ("draft", "d"),
                          ("faces", "f"), ("lamps", "l")):
            self.press(name)
            pressed = self.pixels(self.canvas())
            self.browser.find_element(By.ID, "picture").send_keys("l" if name != "lamps" else "z")
            self.browser.find_element(By.ID, "picture").send_keys(key)
            self.assertEqual(self.rested(), pressed, name)
            if name != "lamps":
                self.assertGreater(differences(lamps, pressed)[1], 0.2, name)
        self.assertEqual(pressed, lamps)
        self.assertEqual(self.errors(), [])

    def test_looks_are_those_of_render(self):
        for name, look in (("zebra", "zebra"), ("isophotes", "isophote"), ("highlight lines", "highlight"),
                           ("draft", "draft")):
            self.press(name)
            self.succeed("render", "scene.toml", "-o", "render.png", "--look", look)
            # Beside caption, legend and outlines, which the canvas does not have. The legend widens the picture.
            width, _, _, _ = png_file.read_png(self.folder / "render.png")
            shown, wide = self.rested(), self.file_pixels("render.png")
            made = [wide[i // 480 * width + i % 480] for i in range(480 * 270)]
            body = [i for i in range(480 * 70, 480 * 200) if 90 < i % 480 < 300 and shown[i] != shown[0]]
            self.assertGreater(len(body), 5000)
            _, beyond = differences([shown[i] for i in body], [made[i] for i in body])
            self.assertLess(beyond, 0.02, (name, shown[body[0]], made[body[0]]))

    def render_command(self) -> str:
        """The command line that the page states for its picture."""
        self.press("picture")
        self.wait_for(lambda: self.browser.find_elements(By.TAG_NAME, "dialog"))
        command = self.browser.find_element(By.TAG_NAME, "dialog").text
        self.press("close")
        return command

    def beyond_render(self, shown: list, *options: str) -> float:
        """The share of the body's pixels that differ from those of the program."""
        self.succeed("render", "scene.toml", "-o", "render.png", *options)
        width, _, _, _ = png_file.read_png(self.folder / "render.png")
        wide = self.file_pixels("render.png")
        body = [i for i in range(480 * 70, 480 * 200) if 90 < i % 480 < 300 and shown[i] != shown[0]]
        self.assertGreater(len(body), 5000)
        return differences([shown[i] for i in body], [wide[i // 480 * width + i % 480] for i in body])[1]

    def test_radii_are_those_of_render(self):
        self.press("radius")
        shown, command = self.rested(), self.render_command()
        scale = re.search(r"--look radius --scale ([0-9.]+):([0-9.]+) ", command)
        self.assertEqual(self.text("legend").split("\n"), [f"{scale[1]} mm", f"{scale[2]} mm"])
        self.assertLess(self.beyond_render(shown, "--look", "radius", "--scale", f"{scale[1]}:{scale[2]}"), 0.02)
        # The scale is that which the program takes by itself, but for what edges of pixels add.
        self.assertLess(self.beyond_render(shown, "--look", "radius"), 0.02)
        self.press("lamps")
        self.assertEqual(self.text("legend"), "")

    def test_curvatures_of_each_kind_are_those_of_render(self):
        self.press("curvature")
        for kind in "mean", "gauss", "k1", "k2", "absolute", "section":
            self.browser.find_element(By.XPATH, f"//select[@aria-label='of']/option[text()='{kind}']").click()
            if kind == "section":
                self.browser.find_element(By.XPATH, "//select[@aria-label='across']/option[text()='x']").click()
                direction = self.browser.find_element(By.CSS_SELECTOR, "#curvature-kind input")
                self.assertEqual(direction.get_attribute("value"), "1,0,0")
                direction.send_keys(Keys.CONTROL, "a")
                direction.send_keys("1,2,0.5" + Keys.ENTER)
            shown = self.rested()
            command = self.render_command()
            look = re.search(r"--look (\S+)", command)[1]
            self.assertTrue(look.startswith(f"curvature:{kind}="), look)
            section = re.findall(r"--section (\S+)", command)
            self.assertEqual(section, ["1,2,0.5"] if kind == "section" else [])
            beyond = self.beyond_render(shown, "--look", look, *(["--section", *section] if section else []))
            self.assertLess(beyond, 0.02, kind)
        self.wait_for(lambda: "across=1%2C2%2C0.5" in self.browser.current_url)
        self.browser.refresh()
        self.wait_for(lambda: "surfaces in" in self.state())
        self.assertEqual(self.rested(), shown)

    def test_a_row_is_moved_by_its_gizmo(self):
        before, address = self.rested(), self.browser.current_url
        for move in "normal", "across", "along", "turn", "tilt":
            handle = self.browser.find_elements(By.CSS_SELECTOR, f"#gizmo [data-move={move}]")[-1]
            ActionChains(self.browser).move_to_element(handle).click_and_hold().move_by_offset(25, -18).release().perform()
            self.wait_for_still()
            after = self.rested()
            # Lamps that are moved along themselves look the same where no end is mirrored.
            if move != "along":
                self.assertGreater(differences(before, after)[1], 0.01, move)
            self.assertNotEqual(self.browser.current_url, address, move)
            before, address = after, self.browser.current_url
        self.press("save")
        self.succeed("render", "scene.toml", "-o", "render.png", "--edge-samples", "1", "--rig", self.saved("rig.toml"))
        mean, beyond = differences(before, self.file_pixels("render.png"))
        self.assertLess(mean, 0.01)
        self.assertEqual(beyond, 0)

    def test_a_drag_takes_the_row_that_is_mirrored_there(self):
        second = """[[c_plane]]
origin = [-1000, -3000, -4000]
u = [12000, 0, 0]
v = [0, 6000, 0]
lamps = 5
diameter = 100
"""
        scene = SCENE % surface("hood.step")
        begin = scene.index("[[c_plane]]")
        self.write("rows.toml", scene[:begin] + second + scene[begin:])
        self.open("rows.toml")
        chosen = "return [...document.querySelectorAll('#rows input[type=radio]')].findIndex(box => box.checked)"
        self.assertEqual(self.browser.execute_script(chosen), 0)
        self.drag(60, -30, Keys.CONTROL)
        self.assertEqual(self.browser.execute_script(chosen), 1)

    def test_a_moved_eye_sees_the_surfaces_in_hand(self):
        canvas = self.browser.find_element(By.ID, "picture")
        actions = ActionChains(self.browser).move_to_element(canvas).click_and_hold().move_by_offset(40, 8)
        actions.perform()
        preview = self.canvas()
        ActionChains(self.browser).release().perform()
        self.wait_for_still()
        (self.folder / "preview.png").write_bytes(preview)
        width, height, _, _ = png_file.read_png(self.folder / "preview.png")
        self.assertEqual((width, height), (240, 135))
        shown, later = self.pixels(preview), self.rested()
        halved = [later[480 * (2 * (i // 240)) + 2 * (i % 240)] for i in range(240 * 135)]
        self.assertLess(differences(shown, halved)[1], 0.2)

    def test_a_row_that_was_dragged_covers_what_a_new_picture_does(self):
        # A drag keeps images of rays, and tests only those whose coverage may have changed; a view is drawn from scratch.
        picture = self.browser.find_element(By.ID, "picture")
        for name, key in (("#picture", Keys.CONTROL), ("#gizmo circle[data-move=normal]", None)):
            element = self.browser.find_element(By.CSS_SELECTOR, name)
            actions = ActionChains(self.browser, duration=10).move_to_element(element)
            if key:
                actions.key_down(key)
            actions.click_and_hold()
            for step in range(24):
                actions.move_by_offset(3 if step < 16 else -2, (-1) ** step)
            actions.release()
            if key:
                actions.key_up(key)
            actions.perform()
            self.wait_for_still()
            dragged = self.rested()
            self.browser.execute_script("document.getElementById('state').textContent = ''")
            picture.send_keys("0")
            self.wait_for(lambda: "exact" in self.state())
            self.assertEqual(differences(self.rested(), dragged), (0, 0))

    def test_lamps_that_move_while_surfaces_come_are_shown_on_all_of_them(self):
        # Surfaces come late, and no exact picture at all.
        self.browser.execute_script("""const now = window.fetch;
            window.fetch = (path, ...more) => path === "/still" ? new Promise(() => {})
              : path === "/deep" ? new Promise((done) => setTimeout(() => done(now(path, ...more)), 1500)) : now(path, ...more);""")
        picture = self.browser.find_element(By.ID, "picture")
        before = self.browser.current_url
        picture.send_keys(Keys.ARROW_RIGHT)
        picture.send_keys("+")
        self.wait_for(lambda: self.browser.current_url != before)
        shown = self.rested()
        self.browser.refresh()
        self.wait_for_still()
        # The address rounds the eye to nine digits.
        mean, beyond = differences(self.rested(), shown)
        self.assertLess(mean, 0.01)
        self.assertEqual(beyond, 0)

    def test_a_link_restores_the_view(self):
        self.drag(60, 30, Keys.CONTROL)
        self.wait_for_still()
        self.drag(70, 0)
        self.wait_for_still()
        shown = self.rested()
        link = self.browser.current_url
        self.assertNotIn("token", link)
        self.browser.get("about:blank")
        self.browser.get(link + "&token=" + self.server.token)
        self.wait_for_still()
        self.assertEqual(differences(shown, self.rested())[1], 0)
        self.assertNotIn("token", self.browser.current_url)


class Revisions(Page):
    def earlier(self) -> list:
        self.wait_for(lambda: self.browser.find_element(By.ID, "earlier").get_attribute("data-traced") == "whole")
        return self.pixels(self.canvas("earlier"))

    def test_the_earlier_revision_is_drawn_as_its_own_page_draws_it(self):
        raised = 'material = "mirror"\ntransform = { translate = [0, 0, 40] }'
        self.write("earlier.toml", (SCENE % surface("hood.step")).replace('material = "mirror"', raised))
        self.open("earlier.toml")
        alone = self.pixels(self.canvas())
        self.open("scene.toml", "--against", "earlier.toml")
        now = self.pixels(self.canvas())
        self.press("both")
        mean, beyond = differences(self.earlier(), alone)
        self.assertLess(beyond, 0.01)
        self.assertGreater(differences(now, alone)[1], 0.05)
        style = "return getComputedStyle(document.getElementById('%s')).%s"
        self.assertIn("50%", self.browser.execute_script(style % ("earlier", "clipPath")))
        self.assertIn("50%", self.browser.execute_script(style % ("earlier-still", "clipPath")))
        self.press("difference")
        self.assertEqual(self.browser.execute_script(style % ("earlier", "mixBlendMode")), "difference")
        self.press("new")
        self.assertEqual(self.browser.execute_script(style % ("earlier", "display")), "none")
        self.assertEqual(self.errors(), [])

    def test_both_exact_pictures_have_one_exposure(self):
        raised = 'material = "mirror"\ntransform = { translate = [0, 0, 40] }'
        self.write("earlier.toml", (SCENE % surface("hood.step")).replace('material = "mirror"', raised))
        self.open("scene.toml", "--against", "earlier.toml")
        self.browser.execute_script("""const now = window.fetch;
            window.exposures = [];
            window.fetch = (path, options) => {
              if (path.endsWith("/still")) exposures.push(Number((/^ev = (.*)$/m.exec(options.body) ?? [])[1]));
              return now(path, options);
            };""")
        self.press("both")
        style = "return getComputedStyle(document.getElementById('%s')).display"
        self.wait_for(lambda: all(self.browser.execute_script(style % name) != "none" for name in ("still", "earlier-still")))
        exposures = self.browser.execute_script("return exposures")
        self.assertEqual(exposures[-1], exposures[-2])
        for name, scene in (("still", "scene.toml"), ("earlier-still", "earlier.toml")):
            self.succeed("render", scene, "-o", "render.png", "--ev", repr(exposures[-1]))
            self.assertEqual(self.pixels(self.canvas(name)), self.file_pixels("render.png"), name)
        self.drag(60, 30, Keys.CONTROL)
        self.wait_for(lambda: self.browser.execute_script(style % "still") == "none")
        self.press("new")
        self.wait_for_still()
        self.succeed("render", "scene.toml", "-o", "render.png", "--rig", self.saved_rig())
        self.assertEqual(self.pixels(self.canvas("still")), self.file_pixels("render.png"))
        self.assertEqual(self.errors(), [])

    def saved_rig(self) -> str:
        self.press("save")
        file = self.folder / "downloads" / "rig.toml"
        self.wait_for(file.exists)
        return str(file)

    def test_without_an_earlier_revision_nothing_offers_one(self):
        self.assertFalse(self.browser.find_element(By.ID, "compare").is_displayed())


class Analyses(Page):
    """What is shown as a file, opened by the page and by the program."""

    def write_note(self, text: str):
        self.browser.find_element(By.ID, "picture").click()
        self.browser.find_element(By.CSS_SELECTOR, "#note input").send_keys(text + Keys.ENTER)

    def hide_a_face(self, name: str):
        self.browser.execute_script("for (const body of document.querySelectorAll('#tree details')) body.open = true")
        self.browser.find_element(By.CSS_SELECTOR, f"#tree input[aria-label*='{name}']").click()

    def save_analysis(self) -> Path:
        self.press("save analysis")
        file = self.folder / "downloads" / "analysis.json"
        self.wait_for(file.exists)
        return file

    def wait_for_faces(self, *hidden: str):
        """Waits until the address hides these faces."""
        self.wait_for(lambda: re.findall(r"hidden=([^&]*)", self.browser.current_url) == list(hidden))

    def make_one(self) -> list:
        """Shows a view with a note, a section and a face less. The canvas."""
        self.write_note("sinks here")
        self.press("keep this view")
        self.drag(60, 0)
        self.press("isophotes")
        self.browser.find_element(By.CSS_SELECTOR, "#section select").send_keys("y")
        self.wait_for(lambda: "y=" in self.text("section"))
        self.hide_a_face("wing-left")
        self.wait_for_faces("1")
        return self.rested()

    def require_all(self, shown: list):
        self.wait_for(lambda: "1. sinks here" in self.text("analysis") or "sinks here" in self.text("analysis"))
        self.wait_for_faces("1")
        self.wait_for(lambda: "y=0.00" in self.text("section"))
        self.assertIn("view-1", self.text("analysis"))
        self.assertEqual(self.browser.find_element(By.CSS_SELECTOR, "#looks [aria-pressed=true]").text, "isophotes")
        self.assertEqual(differences(shown, self.rested())[1], 0)
        self.assertEqual(self.errors(), [])

    def test_a_saved_analysis_opens_with_the_program_and_a_reload_keeps_it(self):
        shown = self.make_one()
        file = self.save_analysis()
        saved = json.loads(file.read_text())
        self.assertEqual([view["look"] for view in saved["views"]], ["isophote", "lamps"])
        self.assertEqual([face["name"] for face in saved["hidden"]], ["wing-left"])
        self.browser.execute_script("sessionStorage.clear()")
        self.open(surface("hood.step"), "--analysis", str(file))
        self.require_all(shown)
        self.browser.refresh()
        self.require_all(shown)
        self.press("view-1")
        self.wait_for_still()
        self.assertGreater(differences(shown, self.rested())[1], 0.2)

    def test_directions_of_sections_are_kept(self):
        self.press("curvature")
        self.browser.find_element(By.XPATH, "//select[@aria-label='of']/option[text()='section']").click()
        direction = self.browser.find_element(By.CSS_SELECTOR, "#curvature-kind input")
        direction.send_keys(Keys.CONTROL, "a")
        direction.send_keys("1,2,0.5" + Keys.ENTER)
        self.browser.find_element(By.CSS_SELECTOR, "#section select").send_keys("f")
        numbers = self.browser.find_element(By.CSS_SELECTOR, "#section input[aria-label='normal of the section']")
        numbers.send_keys(Keys.CONTROL, "a")
        numbers.send_keys("3,4,1" + Keys.ENTER)
        self.wait_for(lambda: "3,4,1=" in self.text("section"))
        shown = self.rested()
        file = self.save_analysis()
        saved = json.loads(file.read_text())
        self.assertEqual(saved["views"][0]["across"], [1, 2, 0.5])
        self.assertEqual([plane.split("=")[0] for plane in saved["sections"]], ["3,4,1"])
        self.browser.execute_script("sessionStorage.clear()")
        self.open(surface("hood.step"), "--analysis", str(file))
        self.wait_for(lambda: "3,4,1=" in self.text("section"))
        self.assertEqual(self.browser.find_element(By.CSS_SELECTOR, "#curvature-kind input").get_attribute("value"), "1,2,0.5")
        self.assertEqual(differences(shown, self.rested())[1], 0)
        self.assertEqual(self.errors(), [])

    def test_the_page_opens_a_file(self):
        shown = self.make_one()
        text = self.save_analysis().read_text()
        self.open("scene.toml")
        self.browser.execute_script("""const text = arguments[0];
            HTMLInputElement.prototype.click = function () {
              const data = new DataTransfer();
              data.items.add(new File([text], "a.json"));
              this.files = data.files;
              this.onchange();
            };""", text)
        self.press("open analysis")
        self.require_all(shown)

    def test_notes_are_marked_flown_to_and_removed(self):
        marks = "return document.getElementById('note-marks').width"
        self.assertEqual(self.browser.execute_script(marks), 0)
        self.write_note("first")
        self.wait_for(lambda: self.browser.execute_script(marks) > 0)
        place = re.search(r"note=([^&]*)", self.browser.current_url)
        self.assertIsNotNone(place)
        before = self.browser.current_url
        self.browser.find_element(By.XPATH, "//button[text()='first']").click()
        self.wait_for(lambda: self.browser.current_url != before)
        self.browser.find_element(By.CSS_SELECTOR, "#analysis li button[title='remove the note']").click()
        self.wait_for(lambda: self.browser.execute_script(marks) == 0)
        self.assertNotIn("note=", self.browser.current_url)


class Panel(Page):
    def marked(self, x: int, y: int) -> bool:
        """Whether a pixel of the marks over the picture is drawn."""
        return self.browser.execute_script(
            "const c = document.getElementById('marks');"
            f"return c.width > 0 && c.getContext('2d').getImageData({x}, {y}, 1, 1).data[3] > 0")

    def test_a_click_names_the_place(self):
        self.browser.find_element(By.ID, "picture").click()
        self.wait_for(lambda: self.marked(240 - 5, 135))
        self.assertTrue(self.browser.execute_script(
            "return [...document.querySelectorAll('.overlay')].every(overlay => "
            "document.getElementById('still').compareDocumentPosition(overlay) & Node.DOCUMENT_POSITION_FOLLOWING)"))
        self.assertFalse(self.marked(240 - 40, 135))
        lines = self.text("pick").split("\n")
        self.assertIn("dome", lines[lines.index("face") + 1])
        x, y, z = map(float, lines[lines.index("place") + 1].removesuffix(" mm").split(","))
        eye = (-1700, -1300, 2000)
        ray = ",".join(map(str, (*eye, x - eye[0], y - eye[1], z - eye[2]))) + "\n"
        run = self.keiko("trace", "scene.toml", "--out", "t", input=ray)
        self.assertAlmostEqual(float(run.stdout.splitlines()[1]), 1, delta=1e-5)
        self.wait_for(lambda: "±" in self.text("pick"))
        lines = self.text("pick").split("\n")
        bound = float(lines[lines.index("proved to") + 1].partition(" mm")[0])
        self.assertTrue(0 < bound < 1e-6, bound)
        self.assertRegex(lines[lines.index("radii") + 1], r"^[0-9.]+ ± [0-9.e+-]+ mm \w+, [0-9.]+ ± [0-9.e+-]+ mm \w+$")

    def test_two_clicks_tell_how_far_apart_their_places_are(self):
        canvas, places = self.browser.find_element(By.ID, "picture"), []
        for x in (-40, 40):
            ActionChains(self.browser).move_to_element_with_offset(canvas, x, 0).click().perform()
            awaited = "from the last" if places else "proved to"
            self.wait_for(lambda: awaited in self.text("pick"))
            lines = self.text("pick").split("\n")
            places.append(tuple(map(float, lines[lines.index("place") + 1].removesuffix(" mm").split(","))))
            self.assertEqual("from the last" in lines, len(places) == 2)
        far = float(lines[lines.index("from the last") + 1].partition(" mm")[0])
        self.assertAlmostEqual(far, math.dist(*places), delta=0.02)

    def test_seams_are_judged_and_flown_to(self):
        self.press("judge")
        self.wait_for(lambda: "judge" not in self.text("seams"))
        before = self.pixels(self.canvas())
        self.browser.find_element(By.CSS_SELECTOR, "#seams td button").click()
        self.wait_for_still()
        self.assertGreater(differences(before, self.pixels(self.canvas()))[1], 0.1)

    def seam_lines(self) -> list:
        """Rows of the lines over the picture: whether each pixel is drawn."""
        alpha = self.browser.execute_script(
            "const c = document.getElementById('seam-lines');"
            "if (c.width === 0) return [];"
            "return Array.from(c.getContext('2d').getImageData(0, 0, c.width, c.height).data).filter((_, i) => i % 4 === 3)")
        return [alpha[i:i + 480] for i in range(0, len(alpha), 480)]

    def projected(self, place: list) -> tuple:
        """Where the camera of SCENE has a place, px."""
        eye, target, up = (-1700, -1300, 2000), (560, 0, 720), (0, 0, 1)
        cross = lambda a, b: tuple(a[i - 2] * b[i - 1] - a[i - 1] * b[i - 2] for i in range(3))
        dot = lambda a, b: sum(x * y for x, y in zip(a, b))
        forward = [t - e for t, e in zip(target, eye)]
        right = cross(forward, up)
        axes = [[x / math.hypot(*axis) for x in axis] for axis in (right, cross(right, forward), forward)]
        x, y, depth = (dot(axis, [p - e for p, e in zip(place, eye)]) for axis in axes)
        scale = 270 / 2 / math.tan(math.radians(21.5) / 2) / depth
        return 240 + x * scale, 135 - y * scale

    def test_seams_are_drawn_where_the_eye_sees_them(self):
        block = SCENE % surface("bored-block.step")
        self.write("block.toml", block.replace("[camera]", "transform = { scale = 15, translate = [560, 0, 720] }\n[camera]"))
        self.open("block.toml")
        # Without labels, which may lie on what is hidden.
        self.browser.execute_script("for (const name of ['fillRect', 'fillText']) CanvasRenderingContext2D.prototype[name] = () => {}")
        self.browser.find_element(By.ID, "picture").send_keys("s")
        self.wait_for(lambda: any(any(row) for row in self.seam_lines()))
        self.wait_for_still()
        drawn = self.seam_lines()
        seams = json.loads(self.server.ask("GET", "/seams")[2])["seams"]
        places = [place for seam in seams for piece in seam["course"] for place in piece]
        eye = (-1700, -1300, 2000)
        rays = "".join(",".join(map(str, (*eye, *(p - e for p, e in zip(place, eye))))) + "\n" for place in places)
        met = [float(line) for line in self.keiko("trace", "block.toml", "--out", "t", input=rays).stdout.splitlines()[1:]]
        # Rays beside a silhouette may miss the body: only what is well in front of a place hides it.
        hidden = [place for place, t in zip(places, met) if t < 0.9]
        shown = [place for place, t in zip(places, met) if t > 0.9999]
        self.assertGreater(len(shown), 100)

        def is_drawn(place: list) -> bool:
            x, y = map(round, self.projected(place))
            return any(drawn[j][i] > 0 for j in range(y - 1, y + 2) for i in range(x - 1, x + 2))
        # Beside silhouettes one pixel holds more depth than the rule allows.
        self.assertLess(len([place for place in shown if not is_drawn(place)]), 0.01 * len(shown))
        seen = [self.projected(place) for place, t in zip(places, met) if t >= 0.9]
        apart = [place for place in hidden if min(math.dist(self.projected(place), at) for at in seen) > 8]
        self.assertGreater(len(apart), 10)
        self.assertEqual([place for place in apart if is_drawn(place)], [])
        self.assertEqual(self.errors(), [])

    def test_a_click_on_a_seam_chooses_it(self):
        picture = self.browser.find_element(By.ID, "picture")
        picture.send_keys("s")
        self.wait_for(lambda: any(any(row) for row in self.seam_lines()))
        self.wait_for_still()
        seam = json.loads(self.server.ask("GET", "/seams")[2])["seams"][0]
        piece = seam["course"][0]
        x, y = self.projected(piece[len(piece) // 2])
        scale = picture.size["width"] / 480
        ActionChains(self.browser).move_to_element_with_offset(picture, (x - 240) * scale, (y - 135) * scale).click().perform()
        self.assertIn(f"{seam['faces']}, {seam['kind']}, {seam['length']:.1f} mm", self.text("seam"))
        self.assertIn("G0 gap", self.text("seam"))
        self.wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#seam .plot polyline"))
        pressed = self.browser.find_elements(By.CSS_SELECTOR, "#seams td [aria-pressed=true]")
        self.assertEqual([button.text for button in pressed], [seam["faces"]])
        self.assertEqual(self.errors(), [])

    def test_a_link_keeps_the_seams_over_the_picture(self):
        self.open(surface("seam-g1-angle.step"))
        self.press("judge")
        self.wait_for(lambda: "seams=shown" in self.browser.current_url)
        red = ("const c = document.getElementById('seam-lines'), d = (c?.width ?? 0) && c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
               "let n = 0; for (let i = 0; i < d.length; i += 4) n += d[i] > 200 && d[i + 1] < 100 && d[i + 3] > 200; return n;")
        self.wait_for(lambda: self.browser.execute_script(red) > 100)
        self.assertIn("G1", self.text("seams"))
        self.browser.refresh()
        self.wait_for(lambda: self.browser.execute_script(red) > 100)
        self.press("over the picture")
        self.wait_for(lambda: self.browser.execute_script("return document.getElementById('seam-lines').width") == 0)
        self.assertNotIn("seams", self.browser.current_url)

    def lamp_lines(self) -> list:
        """Places of the pixels of the lines over the picture that are drawn."""
        return self.browser.execute_script(
            "const c = document.getElementById('lamp-lines'), found = [];"
            "if (!c || c.width === 0) return found;"
            "const { data } = c.getContext('2d').getImageData(0, 0, c.width, c.height);"
            "for (let i = 0; i < data.length / 4; ++i) if (data[4 * i + 3] > 0) found.push([i % c.width, Math.floor(i / c.width)]);"
            "return found")

    def row(self) -> str:
        """The row of lamps that is shown, as a request has it."""
        rig = tomllib.loads(self.server.ask("GET", "/rig")[2].decode())["c_plane"][0]
        return "[[c_plane]]\n" + "".join(f"{key} = {json.dumps(value)}\n" for key, value in rig.items())

    def test_reflection_lines_lie_on_the_stripes_and_go_with_the_lamps(self):
        self.browser.find_element(By.ID, "picture").send_keys("r")
        self.wait_for(self.lamp_lines)
        camera = 'projection = "perspective"\neye = [-1700, -1300, 2000]\ntarget = [560, 0, 720]\nvertical_fov = 21.5\nsize = [480, 270]\n'
        found = json.loads(self.server.ask("POST", "/lines", f"[camera]\n{camera}{self.row()}")[2])
        self.assertIn(f"{len(found['lines'])} lines", self.text("lines"))
        drawn = set(map(tuple, self.lamp_lines()))
        places = [point for line in found["lines"] for piece in line["pieces"] for point in piece["points"]]
        self.assertGreater(len(places), 500)
        for place in places:
            x, y = map(round, self.projected(place))
            self.assertTrue(any((i, j) in drawn for i in range(x - 1, x + 2) for j in range(y - 1, y + 2)), place)
        # The axis of a lamp is in the middle of its stripe.
        stripes = self.rested()
        bright = [stripes[480 * round(y - 0.5) + round(x - 0.5)][1] > 100 for x, y in map(self.projected, places)]
        self.assertGreater(sum(bright), 0.9 * len(bright))
        self.drag(60, 20, Keys.CONTROL)
        self.wait_for(lambda: self.lamp_lines() and set(map(tuple, self.lamp_lines())) != drawn)
        self.wait_for(lambda: "lines=shown" in self.browser.current_url)
        moved = self.lamp_lines()
        self.browser.refresh()
        self.wait_for(self.lamp_lines)
        self.assertEqual(self.lamp_lines(), moved)
        self.press("over the picture")
        self.wait_for(lambda: not self.lamp_lines())
        self.assertNotIn("lines", self.browser.current_url)
        self.assertEqual(self.errors(), [])

    def test_a_broken_reflection_line_is_marked_and_listed(self):
        self.write("aslant.toml", ASLANT)
        self.open(surface("seam-g1-angle.step"), "--rig", "aslant.toml", "--view", "high-front", "--size", "480x270")
        self.press("over the picture")
        self.wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#lines li button"))
        worst = self.browser.find_elements(By.CSS_SELECTOR, "#lines li")[0]
        self.assertEqual(worst.get_attribute("class"), "fail")
        worst.find_element(By.TAG_NAME, "button").click()
        lines = self.text("crossing").split("\n")
        self.assertIn("face", lines[0])
        self.assertTrue(any(re.fullmatch(r".* -?[0-9.]+°, limit [0-9.]+°", line) for line in lines), lines)
        marked = self.browser.execute_script(
            "const c = document.getElementById('marks'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            "return d.some((x, i) => i % 4 === 3 && x > 0)")
        self.assertTrue(marked)
        red = self.browser.execute_script(
            "const c = document.getElementById('lamp-lines'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;"
            "let n = 0; for (let i = 0; i < d.length; i += 4) n += d[i] > 200 && d[i + 1] < 100 && d[i + 3] > 200; return n")
        self.assertGreater(red, 20)
        self.assertEqual(self.errors(), [])

    def test_a_fault_that_is_flown_to_lies_in_the_middle_and_has_a_profile(self):
        self.open(surface("seam-g1-angle.step"))
        self.press("inspect")
        self.wait_for(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#faults li"))
        self.wait_for(lambda: self.text("work") == "", 3)
        self.assertIn("tangent", self.text("faults"))
        self.browser.find_element(By.CSS_SELECTOR, "#faults li button").click()
        self.wait_for_still()
        self.assertIn("angle up to", self.browser.find_element(By.CSS_SELECTOR, "#faults .plot text").text)
        # The seam is drawn through the place, which lies in the middle of a picture of 960 x 540.
        self.wait_for(lambda: self.marked(480, 270 - 5) or self.marked(480 - 5, 270))
        self.browser.find_element(By.ID, "picture").click()
        self.assertTrue(self.marked(480, 270 - 40) or self.marked(480 - 40, 270), "the stretch stays beside the click")
        fault = json.loads(self.server.ask("GET", "/inspect")[2])["items"][0]
        lines = self.text("pick").split("\n")
        place = map(float, lines[lines.index("place") + 1].removesuffix(" mm").split(","))
        away = sum((a - b) ** 2 for a, b in zip(place, fault["place"])) ** 0.5
        self.assertLess(away, 0.02 * fault["length"])
        self.assertEqual(self.errors(), [])

    def test_faces_are_hidden_isolated_and_shown_again(self):
        whole = self.pixels(self.canvas())

        def shows(condition):
            self.wait_for(lambda: condition(differences(self.pixels(self.canvas()), whole)[1]))
        self.browser.execute_script("arguments[0].scrollIntoView()", self.browser.find_element(By.ID, "tree"))
        self.browser.execute_script("for (const body of document.querySelectorAll('#tree details')) body.open = true")
        boxes = self.browser.find_elements(By.CSS_SELECTOR, "#tree li input")
        names = self.browser.find_elements(By.CSS_SELECTOR, "#tree li button")
        self.assertEqual(len(boxes), len(names))
        dome = next(i for i, name in enumerate(names) if "dome" in name.text)
        boxes[dome].click()
        shows(lambda share: share > 0.05)
        self.press("show all")
        shows(lambda share: share == 0)
        names[dome].click()
        self.assertEqual([box.is_selected() for box in boxes].count(True), 1)
        shows(lambda share: share > 0.01)
        self.assertEqual(self.errors(), [])

    def test_a_section_is_drawn_where_the_plane_cuts(self):
        def drawn() -> int:
            return self.browser.execute_script(
                "const c = document.getElementById('section-lines');"
                "if (c.width === 0) return 0;"
                "return c.getContext('2d').getImageData(0, 0, c.width, c.height).data.filter((x, i) => i % 4 === 3 && x > 0).length")
        axis = self.browser.find_element(By.CSS_SELECTOR, "#section select")
        axis.send_keys("y")
        self.wait_for(lambda: "y=" in self.text("section") and drawn() > 500)
        self.assertRegex(self.text("section"), r"y=-?0\.00: [0-9.]+ mm, radii from [0-9.]+ mm")
        slider = self.browser.find_element(By.CSS_SELECTOR, "#section input[type=range]")
        slider.send_keys(Keys.ARROW_RIGHT * 3)
        self.wait_for(lambda: "y=0.00" not in self.text("section"))
        self.browser.find_element(By.ID, "picture").click()
        axis.send_keys("n")
        self.wait_for(lambda: drawn() == 0)
        self.assertEqual(self.errors(), [])

    def section_pixels(self) -> set:
        """Places of the pixels of the section that are drawn in yellow, as its curves and its outline are."""
        return set(map(tuple, self.browser.execute_script(
            "const c = document.getElementById('section-lines'), found = [];"
            "if (!c || c.width === 0) return found;"
            "const { data } = c.getContext('2d').getImageData(0, 0, c.width, c.height);"
            "for (let i = 0; i < data.length / 4; ++i) if (data[4 * i + 3] > 40) found.push([i % c.width, Math.floor(i / c.width)]);"
            "return found")))

    def test_a_section_is_turned_by_hand_and_by_numbers(self):
        def plane() -> str:
            found = re.search(r"(\S+=-?[0-9.]+): [0-9.]+ mm, radii", self.text("section"))
            return found[1] if found else ""

        def require_drawn():
            drawn = self.section_pixels()
            curves = json.loads(self.server.ask("POST", "/section", plane())[2])["curves"]
            places = [sample["place"] for curve in curves for piece in curve["pieces"] for sample in piece["samples"]]
            self.assertGreater(len(places), 30)
            for place in places:
                x, y = map(round, self.projected(place))
                self.assertTrue(any((i, j) in drawn for i in range(x - 1, x + 2) for j in range(y - 1, y + 2)), place)

        address = self.browser.current_url
        canvas = self.browser.find_element(By.ID, "picture")
        ActionChains(self.browser).move_to_element(canvas).key_down(Keys.CONTROL).key_down(Keys.SHIFT).click_and_hold() \
            .move_by_offset(-50, 20).move_by_offset(-50, 10).release().key_up(Keys.SHIFT).key_up(Keys.CONTROL).perform()
        self.wait_for(plane)
        turned = plane()
        self.assertRegex(turned, r"^-?[0-9.]+,-?[0-9.]+,-?[0-9.]+=")
        require_drawn()
        # The middle of the body stays on the plane, and neither eye nor lamps move.
        normal, height = turned.split("=")
        normal = [float(x) for x in normal.split(",")]
        bounds = json.loads(self.server.ask("GET", "/scene")[2])["bounds"]
        middle = [(a + b) / 2 for a, b in zip(bounds["lower"], bounds["upper"])]
        self.assertAlmostEqual(sum(n * m for n, m in zip(normal, middle)) / math.hypot(*normal), float(height), delta=0.02)
        self.assertIn("=".join(("section", turned.replace(",", "%2C").replace("=", "%3D"))), self.browser.current_url)
        self.assertEqual(self.browser.current_url.split("&section")[0], address.split("&section")[0])
        canvas.send_keys(Keys.CONTROL + Keys.SHIFT + Keys.ARROW_UP)
        self.wait_for(lambda: plane() not in ("", turned))
        numbers = self.browser.find_element(By.CSS_SELECTOR, "#section input[aria-label='normal of the section']")
        numbers.send_keys(Keys.CONTROL, "a")
        numbers.send_keys("1, 2, 0.5" + Keys.ENTER)
        self.wait_for(lambda: plane().startswith("1,2,0.5="))
        position = self.browser.find_element(By.CSS_SELECTOR, "#section input[type=number]")
        position.send_keys(Keys.CONTROL, "a")
        position.send_keys("260" + Keys.ENTER)
        self.wait_for(lambda: plane() == "1,2,0.5=260.00")
        require_drawn()
        self.browser.refresh()
        self.wait_for(lambda: plane() == "1,2,0.5=260.00")
        self.assertEqual(numbers_of(self.browser), "1,2,0.5")
        self.assertEqual(self.errors(), [])

    def test_a_face_is_found_by_its_name(self):
        self.browser.find_element(By.CSS_SELECTOR, "#tree input[type=search]").send_keys("WING")
        shown = [leaf.text for leaf in self.browser.find_elements(By.CSS_SELECTOR, "#tree li") if leaf.is_displayed()]
        self.assertEqual(shown, ["1 wing-left", "3 wing-right"])

    def test_lamps_are_placed_for_the_view(self):
        before = self.text("rows")
        self.press("place for this view")
        self.wait_for_still()
        self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "#rows tr")), 1)
        self.assertEqual(before.split()[:2], self.text("rows").split()[:2])
        self.assertEqual(self.errors(), [])

    def test_a_reload_keeps_the_key(self):
        self.assertNotIn("token", self.browser.current_url)
        self.browser.refresh()
        self.wait_for(lambda: "surfaces in" in self.state())
        self.assertEqual(self.errors(), [])

    def test_mouse_buttons_follow_a_system(self):
        before = self.browser.current_url
        self.browser.find_element(By.XPATH, "//select[@aria-label='mouse']/option[text()='Blender']").click()
        self.drag(50, 0)
        self.assertEqual(self.browser.current_url, before)
        self.browser.find_element(By.XPATH, "//select[@aria-label='mouse']/option[text()='Keiko']").click()
        self.drag(50, 0)
        self.wait_for(lambda: self.browser.current_url != before)

    def test_keys_are_listed_and_pictures_tell_their_command(self):
        self.press("keys")
        self.assertIn("isophotes", self.browser.find_element(By.TAG_NAME, "dialog").text)
        self.press("close")
        self.press("picture")
        self.wait_for(lambda: self.browser.find_elements(By.TAG_NAME, "dialog"))
        self.assertIn("keiko render scene.toml --view view.toml", self.browser.find_element(By.TAG_NAME, "dialog").text)
        file = self.folder / "downloads" / "picture.png"
        self.wait_for(file.exists)
        self.succeed("render", "scene.toml", "-o", "render.png")
        self.assertEqual(file.read_bytes(), (self.folder / "render.png").read_bytes())

    def test_a_page_without_the_key_says_so(self):
        self.browser.execute_script("sessionStorage.clear()")
        self.browser.refresh()
        self.wait_for(lambda: "token" in self.state())


if __name__ == "__main__":
    if not browser.is_there():
        print("skipped: the browser tests need chromium, chromium-driver and python3-selenium")
        sys.exit(1 if os.environ.get("CI") else SKIPPED)
    unittest.main()
