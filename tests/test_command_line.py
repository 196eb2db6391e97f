# SPDX-License-Identifier: Apache-2.0
"""What the program promises to its caller: exit codes, whole files, a clean stop."""

import unittest

from program import SCENE, ProgramTest

SLOW = SCENE + """
#for (I, 0, 200) sphere { <I/50 - 2, 0, I/100>, 1.5 pigment { rgbf 0.99 } interior { ior 1.2 } } #end
global_settings { max_trace_level 100 adc_bailout 0 }
"""


class CommandLine(ProgramTest):
    def test_success_is_0_and_the_file_is_there(self):
        self.write("a.pov", SCENE)
        outcome = self.dioptre("+Ia.pov", "+Oa.png", "+W32", "+H24", "-D")
        self.assertEqual(outcome.status, 0, outcome.output)
        self.assertEqual((self.folder / "a.png").read_bytes()[:4], b"\x89PNG")

    def test_a_broken_scene_is_1_and_leaves_the_old_picture(self):
        self.write("a.pov", SCENE + "sphere {")
        self.write("a.png", "old")
        outcome = self.dioptre("+Ia.pov", "+Oa.png", "+W32", "+H24", "-D")
        self.assertEqual(outcome.status, 1)
        self.assertRegex(outcome.output, r"a\.pov:\d+:\d+: error: ")
        self.assertEqual((self.folder / "a.png").read_text(), "old")

    def test_a_missing_scene_is_named(self):
        outcome = self.dioptre("+Inone.pov", "+Oa.png", "-D")
        self.assertNotEqual(outcome.status, 0)
        self.assertIn("none.pov", outcome.output)

    def test_an_unknown_option_is_refused_and_named(self):
        for option in ("+Z99", "--foo", "Foo=3"):
            with self.subTest(option=option):
                outcome = self.dioptre(option)
                self.assertGreater(outcome.status, 0)
                self.assertIn(option.lstrip("+-").split("=")[0], outcome.output)

    def test_help_and_version_are_successes(self):
        for option in ("--help", "--version"):
            outcome = self.dioptre(option)
            self.assertEqual(outcome.status, 0)
            self.assertIn("dioptre", outcome.output.lower())

    def test_nothing_is_left_beside_the_picture(self):
        self.write("a.pov", SCENE)
        self.dioptre("+Ia.pov", "+Oa.png", "+W32", "+H24", "-D")
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["a.png", "a.pov"])

    def test_an_output_folder_that_is_not_there_is_an_error(self):
        self.write("a.pov", SCENE)
        outcome = self.dioptre("+Ia.pov", "+Onone/a.png", "+W32", "+H24", "-D")
        self.assertGreater(outcome.status, 0)
        self.assertIn("none/a.png", outcome.output)

    def test_an_interrupt_ends_with_2_and_leaves_the_old_picture(self):
        self.write("a.pov", SLOW)
        self.write("a.png", "old")
        outcome = self.dioptre("+Ia.pov", "+Oa.png", "+W4000", "+H3000", "+A0.0", "-D",
                               cpu_seconds=60, interrupt_after=1.0)
        self.assertEqual(outcome.status, 2, outcome.output)
        self.assertEqual((self.folder / "a.png").read_text(), "old")
        self.assertTrue(outcome.output.strip())

    def test_an_interrupt_ends_the_reading_too(self):
        self.write("a.pov", "#declare I = 0; #while (I < 1) #declare J = I; #end")
        outcome = self.dioptre("+Ia.pov", "+Oa.png", "-D", cpu_seconds=20, interrupt_after=0.5)
        self.assertEqual(outcome.status, 2, outcome.output)
        self.assertIn("error: stopped here", outcome.output)
        self.assertFalse((self.folder / "a.png").exists())


if __name__ == "__main__":
    unittest.main()
