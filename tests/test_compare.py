# SPDX-License-Identifier: Apache-2.0
"""What compare promises: every accelerator gives the same image, in reports that others can read."""

import csv
import io
import json
import re
import unittest
import xml.dom.minidom

from program import ROOT, ProgramTest

from measure import growth_plot

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


class GrowthPlot(unittest.TestCase):
    BENCH = """kind    spheres name             rays/s    nodes    boxes    items
even        100 bvh           3853092     10.4      0.0      1.7    0.000    98.1    0.8    1.0  2.1
eye         100 bvh           9999999     10.4      0.0      1.7    0.000    98.1    0.8    1.0  2.1
even       1000 bvh           2076490     19.8      0.5      2.1    0.002   100.1    0.9    1.0  2.3
even        100 none          1380536      0.0    100.0      1.9    0.000    56.0    0.0    1.0  2.1
"""

    def test_the_rows_of_one_kind_are_read(self):
        rows = growth_plot.read(self.BENCH)
        self.assertEqual([(row["structure"], row["objects"]) for row in rows],
                         [("bvh", 100), ("bvh", 1000), ("none", 100)])
        self.assertEqual(growth_plot.looks(rows[1]), 20.3)

    def test_the_plot_names_each_structure(self):
        document = xml.dom.minidom.parseString(growth_plot.svg(growth_plot.read(self.BENCH)))
        said = [node.firstChild.data for node in document.getElementsByTagName("text")]
        self.assertEqual((said.count("bvh"), said.count("none")), (2, 1))


if __name__ == "__main__":
    unittest.main()
