# SPDX-License-Identifier: Apache-2.0
"""What compare promises: every accelerator gives the same image, in reports that others can read."""

import csv
import io
import json
import re
import unittest

from program import ROOT, ProgramTest

SCENES = ("csg", "glass", "mesh")
NAMES = ["bvh", "bsp", "bsp-median", "octree", "grid2", "grid", "boxes", "slabs", "spheres",
         "extents", "none"]


class Compare(ProgramTest):
    def compare(self, scene, *options):
        outcome = self.dioptre("compare", scene, "--size", "80x60", "-V", "-D", *options)
        self.assertEqual(outcome.status, 0, outcome.output)
        return outcome.output

    def test_all_images_are_equal_and_the_reports_can_be_read(self):
        for name in SCENES:
            with self.subTest(scene=name):
                said = self.compare(ROOT / "examples" / f"{name}.pov", "--csv", "out.csv",
                                    "--json", "out.json", "--html", "out.html")
                self.assertIn(f"All {len(NAMES)} images are equal", said)
                self.check_csv(self.folder / "out.csv")
                self.check_json(self.folder / "out.json")
                self.check_page(self.folder / "out.html")

    def check_csv(self, path):
        rows = list(csv.DictReader(io.StringIO(path.read_text())))
        self.assertEqual([row["structure"] for row in rows], NAMES)
        for row in rows:
            self.assertEqual((row["same_image"], row["same_answers"]), ("1", "1"))
            self.assertGreater(float(row["eye_nanoseconds"]), 0)
        none = rows[-1]
        self.assertEqual(float(none["eye_boxes"]), float(none["items"]))

    def check_json(self, path):
        report = json.loads(path.read_text())
        self.assertTrue(report["all_equal"])
        self.assertEqual([each["name"] for each in report["structures"]], NAMES)
        self.assertEqual(report["rays"]["eye"]["traced"], 80 * 60)

    def check_page(self, path):
        page = path.read_text()
        self.assertNotRegex(page, r"https?://")
        self.assertNotIn("{{", page)
        data = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
        self.assertTrue(json.loads(data[1])["all_equal"])
        self.assertIn('src="data:image/png;base64,iVBOR', page)

    def test_only_what_is_named_is_compared(self):
        said = self.compare(ROOT / "examples" / "csg.pov", "--accel", "grid,slabs:3", "--csv", "-")
        rows = list(csv.DictReader(io.StringIO(said)))
        self.assertEqual([row["structure"] for row in rows], ["grid", "slabs:3"])

    def test_an_unknown_accelerator_lists_those_that_there_are(self):
        outcome = self.dioptre("compare", ROOT / "examples" / "csg.pov", "--accel", "bvh,tree")
        self.assertEqual(outcome.status, 64)
        for name in NAMES:
            self.assertIn(name, outcome.output)

    def test_a_render_says_the_share_of_intersection(self):
        outcome = self.dioptre(ROOT / "examples" / "csg.pov", "--size", "320x240", "-o", "a.png")
        self.assertEqual(outcome.status, 0, outcome.output)
        self.assertRegex(outcome.output, r"\d+ camera, \d+ reflected, \d+ transmitted, \d+ shadow")
        self.assertRegex(outcome.output, r"\d+ % of the time in intersection")


if __name__ == "__main__":
    unittest.main()
