# SPDX-License-Identifier: Apache-2.0
"""Each construct of the scene language is read as POV-Ray reads it.

A file of tests/language is a beginning and then pieces under lines `// -- NAME`; each piece with the
beginning before it is a scene of its own. NAME.ppm.gz beside it holds POV-Ray's pictures of the pieces,
32x24 each, one below the other, and NAME.txt what POV-Ray says for `#debug "= ..."`. A piece whose
name ends with (fails) is an error in POV-Ray too; of one with (parses) the picture is not compared,
nor is it while the program says that something in it is not rendered yet.
With the arguments --measure NAME..., POV-Ray renders the pieces of those files (or of all) and their
references are written anew.
"""

import gzip
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from program import DIOPTRE, MEMORY, ROOT, ProgramTest, images, processes

FOLDER = ROOT / "tests/language"
WIDTH, HEIGHT = 32, 24
PIECE = 3 * WIDTH * HEIGHT
OPTIONS = ("+Iscene.pov", "+Oout.ppm", f"+W{WIDTH}", f"+H{HEIGHT}", "-A", "-D", "+FP8", "+WT1",
           f"+L{FOLDER}")
DIFFERENT = WIDTH * HEIGHT // 100  # pixels that may differ


def pieces(path):
    """(name, scene) of each piece of a file."""
    parts = re.split(r"(?m)^// -- (.*)\n", path.read_text())
    return [(name, parts[0] + body) for name, body in zip(parts[1::2], parts[2::2])]


def said(text):
    return [line.rstrip() for line in text.splitlines() if line.startswith("= ")]


def spoken(path):
    """What POV-Ray says in each piece of a file."""
    parts = re.split(r"(?m)^// -- (.*)\n", path.read_text() if path.exists() else "")
    return {name: said(body) for name, body in zip(parts[1::2], parts[2::2])}


def differing(a, b):
    """How many pixels differ by more than 2 of 255."""
    return sum(any(abs(a[i + c] - b[i + c]) > 2 for c in range(3)) for i in range(0, PIECE, 3))


class Language(ProgramTest):
    def test_each_piece_is_as_in_the_reference(self):
        for path in sorted(FOLDER.glob("*.pov")):
            pictures = gzip.decompress(path.with_suffix(".ppm.gz").read_bytes()).split(b"\n", 3)[3]
            words = spoken(path.with_suffix(".txt"))
            jobs = [(path.stem, i, *piece) for i, piece in enumerate(pieces(path))]
            self.assertEqual(len(pictures), PIECE * len(jobs), path.name)
            with ThreadPoolExecutor(2) as pool:
                outcomes = list(pool.map(self.run_piece, jobs))
            for (_, i, name, _), (outcome, picture) in zip(jobs, outcomes):
                with self.subTest(file=path.name, piece=name):
                    expected = pictures[PIECE * i:PIECE * (i + 1)]
                    self.check(name, outcome, picture, expected, words.get(name, []))

    def run_piece(self, job):
        stem, i, _, scene = job
        folder = self.folder / f"{stem}{i}"
        folder.mkdir()
        (folder / "scene.pov").write_text(scene)
        outcome = processes.run([DIOPTRE, *OPTIONS, "--progress=none"], cwd=folder,
                                cpu_seconds=20, address_space=MEMORY)
        picture = folder / "out.ppm"
        return outcome, images.read_ppm(picture).rgb if picture.exists() else None

    def check(self, name, outcome, picture, expected, words):
        if name.endswith("(fails)"):
            self.assertEqual(outcome.status, 1, outcome.output)
            return
        self.assertEqual(outcome.status, 0, outcome.output)
        self.assertEqual(said(outcome.output), words)
        if not name.endswith("(parses)") and "not rendered yet" not in outcome.output:
            self.assertLessEqual(differing(picture, expected), DIFFERENT)


def measure(folder, names):
    """Writes the references with the POV-Ray that is installed."""
    for path in sorted(FOLDER.glob("*.pov")):
        if names and path.stem not in names:
            continue
        pictures, words = [], []
        for name, scene in pieces(path):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir()
            (folder / "scene.pov").write_text(scene)
            done = subprocess.run(["povray", *OPTIONS], cwd=folder, capture_output=True,
                                  text=True, errors="replace")
            if (done.returncode != 0) != name.endswith("(fails)"):
                sys.exit(f"{path.name}: {name}: POV-Ray ends with {done.returncode}")
            picture = folder / "out.ppm"
            pictures.append(images.read_ppm(picture).rgb if picture.exists() else bytes(PIECE))
            lines = [] if name.endswith("(fails)") else said(done.stderr)
            if lines:
                words.append("\n".join([f"// -- {name}", *lines, ""]))
        header = f"P6\n{WIDTH} {HEIGHT * len(pictures)}\n255\n".encode()
        path.with_suffix(".ppm.gz").write_bytes(gzip.compress(header + b"".join(pictures), mtime=0))
        if words:
            path.with_suffix(".txt").write_text("".join(words))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--measure"]:
        with tempfile.TemporaryDirectory() as scratch:
            measure(Path(scratch) / "reference", sys.argv[2:])
    else:
        unittest.main()
