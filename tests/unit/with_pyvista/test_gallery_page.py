"""The gallery's page as a browser shows it, from its folder and without a network.

Usage: test_gallery_page.py FOLDER [-v]      FOLDER: where the gallery is
"""

import html
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()
BROWSER = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
if BROWSER is None:
    print("there is no Chromium to show the page")
    sys.exit(0)
if not (FOLDER / "index.html").exists():
    print("there is no gallery: it has not been drawn")
    sys.exit(0)

EXAMPLES = pathlib.Path(__file__).resolve().parents[3] / "examples" / "pyvista"

# Runs within the page: what it shows, and how many colours each picture has on a grid.
PROBE = """<script>
window.addEventListener("load", () => {
  const colours = (image) => {
    const canvas = document.createElement("canvas");
    canvas.width = 80; canvas.height = 60;
    const context = canvas.getContext("2d");
    if (!image.naturalWidth) return 0;
    context.drawImage(image, 0, 0, 80, 60);
    return new Set(new Uint32Array(context.getImageData(0, 0, 80, 60).data.buffer)).size;
  };
  const place = (image) => {
    const at = image.getBoundingClientRect();
    return [at.left, at.top, at.width, at.height].map(Math.round);
  };
  const found = {
    images: [...document.images].map((image) => ({
      name: image.getAttribute("src"), width: image.naturalWidth, colours: colours(image), place: place(image),
      alternative: image.alt })),
    scripts: [...document.querySelectorAll("pre")].map((each) => each.textContent),
    outside: [...document.querySelectorAll("[src], [href]")].map((each) => each.src || each.href)
      .filter((each) => !/^(file|data):/.test(each)),
    wider: document.documentElement.scrollWidth - window.innerWidth,
  };
  const result = document.createElement("textarea");
  result.id = "probe";
  result.textContent = JSON.stringify(found);
  document.body.append(result);
});
</script>"""


def show(folder, width=1200):
    """What the probe finds on the page, and what the browser complains about."""
    page = folder / "probed.html"
    page.write_text((folder / "index.html").read_text() + PROBE)
    with tempfile.TemporaryDirectory() as profile:
        shown = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run",
             f"--user-data-dir={profile}", f"--window-size={width},900", "--allow-file-access-from-files",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--enable-logging=stderr", "--virtual-time-budget=20000",
             "--dump-dom", page.as_uri()], capture_output=True, text=True, timeout=240)
    page.unlink()
    found = re.search(r'<textarea id="probe">(.*?)</textarea>', shown.stdout, re.DOTALL)
    if found is None:
        raise AssertionError(f"the page does not load: {shown.stderr[-2000:]}")
    complaints = [line for line in shown.stderr.splitlines() if "CONSOLE" in line]
    return json.loads(html.unescape(found.group(1))), complaints


class TestPage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.found, cls.complaints = show(FOLDER)

    def test_the_browser_has_nothing_to_complain_about(self):
        self.assertEqual(self.complaints, [])

    def test_every_picture_is_there_and_shows_something(self):
        self.assertEqual(sorted(image["name"] for image in self.found["images"]),
                         sorted(file.name for file in FOLDER.glob("*.png")))
        self.assertEqual(len(self.found["images"]), 24)
        for image in self.found["images"]:
            with self.subTest(image["name"]):
                self.assertGreater(image["width"], 0)
                self.assertGreater(image["colours"], 20)
                self.assertTrue(image["alternative"])

    def test_plain_is_beside_ours(self):
        for plain, ours in zip(self.found["images"][::2], self.found["images"][1::2]):
            self.assertEqual(plain["name"], ours["name"].replace(".png", "-plain.png"))
            self.assertEqual(plain["place"][1:], ours["place"][1:])
            self.assertGreaterEqual(ours["place"][0], plain["place"][0] + plain["place"][2])

    def test_each_scene_has_its_script(self):
        names = [image["name"].removesuffix(".png") for image in self.found["images"][1::2]]
        self.assertEqual(self.found["scripts"], [(EXAMPLES / f"{name}.py").read_text() for name in names])

    def test_nothing_comes_from_elsewhere(self):
        self.assertEqual(self.found["outside"], [])

    def test_it_fits_a_narrow_window(self):
        found, complaints = show(FOLDER, 500)
        self.assertEqual((found["wider"] <= 0, complaints), (True, []))

    def test_what_is_wrong_would_be_noticed(self):
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(shutil.copytree(FOLDER, pathlib.Path(folder) / "copy"))
            (copy / "part.png").unlink()
            page = copy / "index.html"
            page.write_text(page.read_text() + "<script src='https://example.org/a.js'></script><script>no()</script>")
            found, complaints = show(copy)
        self.assertEqual([image["name"] for image in found["images"] if not image["colours"]], ["part.png"])
        self.assertEqual(found["outside"], ["https://example.org/a.js"])
        self.assertTrue(any("no is not defined" in line for line in complaints), complaints)


if __name__ == "__main__":
    unittest.main()
