# SPDX-License-Identifier: Apache-2.0
"""Options and outputs that ask for the impossible: a clear error, soon, in little memory."""

import unittest

from program import SCENE, ProgramTest

REFUSED = {
    "image of 10^9 x 10^9": ("+W1000000000", "+H1000000000"),
    "image of 10^5 x 10^5": ("+W100000", "+H100000"),
    "image of 0 x 0": ("+W0", "+H0"),
    "negative image": ("+W-5", "+H-5"),
    "width that is no number": ("+Wten", "+H10"),
    "number beyond every range": ("+W99999999999999999999999", "+H10"),
    "unknown options": ("+Z99", "--foo"),
    "unknown integrator": ("--integrator", "nonsense"),
    "unknown accelerator": ("--accelerator", "nonsense"),
}


class HostileOptions(ProgramTest):
    def test_impossible_options_are_refused(self):
        self.write("a.pov", SCENE)
        for name, options in REFUSED.items():
            with self.subTest(case=name):
                outcome = self.dioptre("+Ia.pov", "+Oa.png", "-D", *options, cpu_seconds=10)
                self.assertGreater(outcome.status, 0, outcome.output)
                self.assertLess(outcome.cpu_seconds, 2)
                self.assertLess(outcome.peak_bytes, 512 << 20)
                self.assertTrue(outcome.output.strip())
                self.assertFalse((self.folder / "a.png").exists())

    def test_a_folder_is_not_a_scene(self):
        (self.folder / "folder.pov").mkdir()
        outcome = self.dioptre("+Ifolder.pov", "+Oa.png", "-D", cpu_seconds=10)
        self.assertGreater(outcome.status, 0)
        self.assertIn("folder.pov", outcome.output)


if __name__ == "__main__":
    unittest.main()
