# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""A page shows texts as they are, whatever is in them, and runs nothing of them. Opened from a file, it asks
for nothing, and its content security policy stops what is not its own."""

import re
import unittest

import needed  # noqa: F401
from pages import PageTest
from scenes import Scene, waves

ATTACK = """<script>document.title = "run"</script><img src=x onerror="document.title = 'run'">"""
TITLES = (
    "Über Größen: „Äußeres“ – ½ µm, 断面, 🫀", ATTACK, """'single' "double" &amp; &lt;b&gt; \\u003c""",
    "</title></script><!-- --> ]]>", "@TITLE@ @CAPTION@ @DATA@ @POSTER@ $1 $&", 'id="view-file">AAAA<')


class Texts(PageTest):
    def test_as_they_are(self):
        scene = Scene(waves(), 1.3, (64, 64))
        for title in TITLES:
            caption, citation, units = f"{title}\nsecond line", f"cited: {title}", f"m/{title}"
            self.open(scene, title=title, caption=caption, citation=citation, units=units)
            self.assertEqual(self.browser.text("title"), title)
            self.assertEqual(self.browser.run("return document.title;"), " ".join(title.split()))
            self.assertEqual(self.browser.text("caption"), caption)
            self.assertEqual(self.browser.text("citation"), citation)
            self.assertEqual(
                self.browser.run("return document.querySelector('meta[name=description]').content;"), caption)
            self.browser.drag("slider", (0.5, 0.5))
            self.assertTrue(self.browser.text("told").endswith(units))
            self.assertTrue(self.browser.attribute("slider", "aria-valuetext").endswith(units))
            self.assertIn(units, self.browser.text("about"))
            self.assertEqual(self.browser.run("return document.scripts.length;"), 1)
            self.assert_no_complaints()

    def test_names_of_views(self):
        scene = Scene(waves(), 1.3, (64, 64))
        self.open(scene, views={name: scene.renderer.GetActiveCamera() for name in TITLES[:3]})
        for name in (*TITLES[1:3], TITLES[0]):
            self.browser.press("n")
            self.browser.wait_until(lambda: self.browser.text("told") == name, "the name of the view is told")
        self.assert_no_complaints()

    def test_without_texts(self):
        self.open(Scene(waves(), 1.3, (64, 64)))
        self.assertTrue(self.browser.text("title").strip())
        self.assertTrue(self.browser.run("return document.title;").strip())
        for name in ("caption", "citation"):
            self.assertEqual(self.browser.text(name), "")

    def test_no_network(self):
        scene = Scene(waves(), 1.3, (64, 64))
        self.browser.requests()
        self.open(scene, title="Alone", views=2)
        for keys in (("n",), ("Tab", "ArrowRight"), ("s",)):
            self.browser.press(*keys)
        self.browser.drag("picture", (0.5, 0.5), (0.9, 0.9))
        asked = [address for address in self.browser.requests() if not address.endswith("favicon.ico")]
        self.assertEqual(asked, [(self.folder / "view.html").resolve().as_uri()])
        self.assert_no_complaints()

    def test_addresses(self):
        """A page has no address but in its texts."""
        page = Scene(waves(), 1.3, (64, 64)).write(self.folder / "view.html").read_text(encoding="utf-8")
        self.assertEqual(re.findall(r"https?://|//[a-z]+\.|\b(?:src|href)=\"(?!data:)", page), [])

    def test_policy(self):
        """What comes into the page later does not run, and cannot send anything."""
        self.open(Scene(waves(), 1.3, (64, 64)))
        self.browser.run("""
            const script = document.createElement("script");
            script.textContent = "document.title = 'run'";
            document.body.append(script);
            const image = new Image();
            image.src = "http://127.0.0.1:9/picture.png";
            document.body.append(image);
            document.body.insertAdjacentHTML("beforeend", "<p id=styled style='color: red'></p>");
            fetch("http://127.0.0.1:9/").catch(() => {});""")
        self.browser.wait_until(
            lambda: self.browser.run("return globalThis.thrown.filter((each) => each.startsWith('forbidden')).length;")
            >= 4, "the policy forbids")
        self.assertNotEqual(self.browser.run("return document.title;"), "run")


if __name__ == "__main__":
    unittest.main()
