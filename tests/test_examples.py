# SPDX-License-Identifier: Apache-2.0
"""Every scene of examples/ renders, and the commands of the README run."""

import re
import subprocess
import unittest

from program import DIOPTRE, ROOT, ProgramTest, images


class Examples(ProgramTest):
    def test_each_scene_renders_without_a_complaint(self):
        for scene in sorted((ROOT / "examples").glob("*.pov")):
            self.render_clean(scene)

    def test_each_procedural_database_renders_at_small_sizes(self):
        scenes = sorted((ROOT / "examples/spd").glob("*.pov"))
        self.assertEqual(len(scenes), 7)
        for scene in scenes:
            for size in (1, 3):
                # A plane face under one distant light has a single colour.
                self.render_clean(scene, f"Declare=Size={size}", colours=4)

    def render_clean(self, scene, *options, colours=16):
        """Renders a scene without a complaint, and to a picture that shows something."""
        with self.subTest(scene=scene.name, options=options):
            outcome = self.dioptre(f"+I{scene}", "+Oout.ppm", "+W64", "+H48", "+FP", "-D",
                                   "--progress=none", *options, cpu_seconds=60)
            self.assertEqual(outcome.status, 0, outcome.output)
            self.assertNotRegex(outcome.output, r"(?i)\b(warning|error|not rendered)\b")
            image = images.read_ppm(self.folder / "out.ppm")
            self.assertGreater(len(set(image.rgb)), colours, "hardly anything to see")

    def test_the_commands_of_the_readme_run(self):
        text = (ROOT / "README.md").read_text()
        blocks = re.findall(r"```sh\n(.*?)```", text, re.DOTALL)
        commands = [line for line in "".join(blocks).splitlines()
                    if line.startswith("build/release/dioptre ")]
        self.assertGreater(len(commands), 2)
        (self.folder / "examples").symlink_to(ROOT / "examples")
        (self.folder / "build").mkdir()
        for command in commands:
            with self.subTest(command=command):
                here = command.replace("build/release/dioptre", DIOPTRE, 1)
                whole = command.split()[1] in ("dump", "explain")  # a pixel needs its own size
                done = subprocess.run(here if whole else here + " +W64 +H48", shell=True,
                                      cwd=self.folder, capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
