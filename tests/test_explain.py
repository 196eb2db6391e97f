# SPDX-License-Identifier: Apache-2.0
"""dioptre explain: the rays of a pixel, whose contributions sum to it."""

import json
import math
import os
import random
import re
import unittest

from program import ROOT, ProgramTest

SCENES = ("csg", "glass", "textures", "lights", "blob", "prism", "mesh", "loops", "orthographic", "showcase")
WIDTH, HEIGHT = 160, 120
# How many pixels of each scene; more take longer.
PIXELS = int(os.environ.get("EXPLAIN_PIXELS", "20"))


def light_of(tree, index):
    """What a ray brings, added up from the leaves of the tree."""
    ray = tree["rays"][index]
    light = [sum(part["light"][k] for part in ray["received"]) for k in range(3)]
    for child in ray["children"]:
        share = tree["rays"][child]["share"]
        light = [a + s * b for a, s, b in zip(light, share, light_of(tree, child))]
    return light


class Explain(ProgramTest):
    def explain(self, scene, *arguments):
        return self.dioptre("explain", scene, *arguments, "--size", f"{WIDTH}x{HEIGHT}")

    def tree(self, scene, column, row):
        outcome = self.explain(scene, "--pixel", f"{column},{row}", "--json", "tree.json")
        self.assertEqual(outcome.status, 0, outcome.output)
        return json.loads((self.folder / "tree.json").read_text(encoding="utf-8"))

    def test_the_contributions_sum_to_the_pixel(self):
        numbers = random.Random(1)
        for name in SCENES:
            scene = ROOT / "examples" / f"{name}.pov"
            for _ in range(PIXELS):
                column, row = numbers.randrange(WIDTH), numbers.randrange(HEIGHT)
                with self.subTest(scene=name, pixel=(column, row)):
                    tree = self.tree(scene, column, row)
                    largest = max(1, *map(abs, tree["value"]))
                    for found, wanted in zip(light_of(tree, 0), tree["value"]):
                        self.assertLess(abs(found - wanted) / largest, 1e-6)

    def test_the_value_is_that_of_the_picture(self):
        scene = ROOT / "examples/glass.pov"
        self.render(scene, "glass.ppm", f"+W{WIDTH}", f"+H{HEIGHT}", "File_Gamma=1.0")
        pixels = (self.folder / "glass.ppm").read_bytes()[-3 * WIDTH * HEIGHT:]
        for column, row in ((0, 0), (40, 70), (80, 60), (120, 75), (159, 119)):
            value = self.tree(scene, column, row)["value"]
            place = 3 * (row * WIDTH + column)
            for written, light in zip(pixels[place:place + 3], value):
                self.assertEqual(written, int(min(max(light, 0), 1) * 255 + 0.5))

    def test_text_names_objects_operators_and_lines(self):
        text = self.explain(ROOT / "examples/csg.pov", "--pixel", "125,65").output
        self.assertRegex(text, r"meets \w+ '\w+' \(.*csg\.pov:\d+\)")
        self.assertIn("intersection: ", text)
        self.assertRegex(text, r"is removed by the intersection, being outside")
        self.assertIn("the value of the pixel.", text)

    def test_glass_tells_of_snell_and_fresnel(self):
        scene = self.write("ball.pov", """#version 3.7; global_settings { assumed_gamma 1 }
            camera { location <0.5, 0, -5> look_at <0.5, 0, 0> } background { rgb 0.5 }
            sphere { 0, 1 pigment { rgbf 1 } interior { ior 1.5 } }""")
        tree = self.tree(scene, WIDTH // 2, HEIGHT // 2)
        bends = [ray["refraction"] for ray in tree["rays"] if "refraction" in ray]
        self.assertEqual(len(bends), 2)
        for bend in bends:
            before = bend["index_before"] * math.sin(bend["angle_before"])
            behind = bend["index_behind"] * math.sin(bend["angle_behind"])
            self.assertAlmostEqual(before, behind, places=9)

    def test_the_page_stands_alone(self):
        outcome = self.explain(ROOT / "examples/glass.pov", "--pixel", "40,70", "--html", "tree.html")
        self.assertEqual(outcome.status, 0, outcome.output)
        page = (self.folder / "tree.html").read_text(encoding="utf-8")
        self.assertNotIn("{{", page.split("<script>")[0])
        self.assertFalse(re.search(r"<(?:script|link|img)[^>]+(?:src|href)=.?https?:", page))

    def test_misuse_is_explained(self):
        scene = ROOT / "examples/glass.pov"
        for arguments, status, message in (((), 64, "--pixel"), (("--pixel", "3"), 64, "column,row"),
                                           (("--pixel", "160,3"), 1, "160 x 120"),
                                           (("--pixel", "1,2", "--integrator", "x"), 1, "whitted")):
            with self.subTest(arguments=arguments):
                outcome = self.explain(scene, *arguments)
                self.assertEqual(outcome.status, status, outcome.output)
                self.assertIn(message, outcome.output)


if __name__ == "__main__":
    unittest.main()
