# SPDX-License-Identifier: Apache-2.0
"""The same scene gives the same bytes, whatever the threads and whichever way it came."""

import unittest

from program import ROOT, ProgramTest

SCENES = ("csg", "glass", "textures", "lights", "blob", "prism", "mesh", "loops")


class Determinism(ProgramTest):
    def test_threads_do_not_change_the_image(self):
        for name in SCENES:
            scene = ROOT / "examples" / f"{name}.pov"
            for extra in ((), ("+A0.1",)):
                one = self.render(scene, "one.ppm", "+WT1", *extra)
                for threads in (2, 4):
                    with self.subTest(scene=name, threads=threads, extra=extra):
                        many = self.render(scene, "many.ppm", f"+WT{threads}", *extra)
                        self.assertTrue(one == many, "the images differ")

    def test_a_dump_renders_as_the_scene_it_came_from(self):
        for name in SCENES:
            with self.subTest(scene=name):
                scene = ROOT / "examples" / f"{name}.pov"
                outcome = self.dioptre("dump", scene, "-o", "scene.json", "+W64", "+H48")
                self.assertEqual(outcome.status, 0, outcome.output)
                direct = self.render(scene, "direct.ppm")
                again = self.render("scene.json", "again.ppm")
                self.assertTrue(direct == again, "the images differ")


if __name__ == "__main__":
    unittest.main()
