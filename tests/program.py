# SPDX-License-Identifier: Apache-2.0
"""Runs the built program in a folder of its own, under limits."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

from measure import images, processes  # noqa: E402,F401

DIOPTRE = os.environ.get("DIOPTRE", str(ROOT / "build/release/dioptre"))
MEMORY = 2 << 30
SCENE = """#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 } light_source { <-3, 5, -5> rgb 1 }
sphere { 0, 1 pigment { rgb <1, .5, .2> } }
"""


class ProgramTest(unittest.TestCase):
    """A test with a scratch folder in which the program runs."""

    def setUp(self):
        self._scratch = tempfile.TemporaryDirectory()
        self.folder = Path(self._scratch.name)

    def tearDown(self):
        self._scratch.cleanup()

    def write(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def dioptre(self, *arguments, cpu_seconds=20, **more):
        return processes.run([DIOPTRE, *map(str, arguments)], cwd=self.folder,
                             cpu_seconds=cpu_seconds, address_space=MEMORY, **more)

    def render(self, scene, name, *options):
        """Renders to a PPM and gives its bytes."""
        outcome = self.dioptre(f"+I{scene}", f"+O{name}", "+W64", "+H48", "+FP", "-D", *options)
        self.assertEqual(outcome.status, 0, outcome.output)
        return (self.folder / name).read_bytes()
