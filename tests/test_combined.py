# SPDX-License-Identifier: Apache-2.0
"""Scenes that combine features in unusual ways, against pictures that POV-Ray 3.7 made of them."""

import unittest
from pathlib import Path

from program import ROOT, ProgramTest, images

SCENES = ROOT / "tests" / "combined"
CLOSE = 2  # of 255, in each channel
ENOUGH = 0.99  # of the pixels


def same(ours, theirs):
    """The share of pixels that are close in every channel."""
    close = sum(
        all(abs(a - b) <= CLOSE for a, b in zip(ours.rgb[i : i + 3], theirs.rgb[i : i + 3]))
        for i in range(0, len(theirs.rgb), 3))
    return 3 * close / len(theirs.rgb)


class CombinedFeatures(ProgramTest):
    def test_every_scene_is_the_same_as_povrays(self):
        references = sorted(SCENES.glob("*.ppm"))
        self.assertGreater(len(references), 10)
        for path in references:
            with self.subTest(path.stem):
                theirs = images.read_ppm(path)
                scene = path.with_suffix(".pov")
                outcome = self.dioptre(f"+I{scene}", "+Oa.ppm", "+FP", "-D", "-A",
                                       f"+W{theirs.width}", f"+H{theirs.height}")
                self.assertEqual(outcome.status, 0, outcome.output)
                ours = images.read_ppm(Path(self.folder) / "a.ppm")
                self.assertGreaterEqual(same(ours, theirs), ENOUGH)


if __name__ == "__main__":
    unittest.main()
