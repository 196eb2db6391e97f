# SPDX-License-Identifier: Apache-2.0
"""Files as programs and people write them: what is forgiven, what is said, and how they look.

The references are POV-Ray 3.7's; where it refuses the file, those of the file with its mistake
mended.
"""

import re
import shutil
import unittest

from program import ROOT, ProgramTest, images

WILD = ROOT / "tests" / "wild"
CLOSE = 2  # of 255, in each channel
ENOUGH = 0.99  # of the pixels
OLD_LOOK = "the scene names no #version: read as 3.7, but with the look of 3.6"
UNNAMED = ["{}: warning: " + OLD_LOOK]


def semicolons(first_line):
    return [f"{{}}:{first_line + line}:10: warning: the declaration of {name} has no ';' at its end"
            for line, name in ((0, "Size"), (1, "Tall"), (2, "Brown"), (4, "Half"))]


def keyword(line, name):
    return (f"{{}}:{line}:10: warning: '{name}' is a reserved word: "
            "from here on it is the scene's name")


def other_case(place, name):
    return f"{{}}:{place}: warning: the file '{name}' was found in other upper or lower case"


# What POV-Ray 3.7 refuses, and all that is said when it is read; {} stands for the file's name.
FORGIVEN = {
    "arrays_38": ["{}:1:10: warning: version 3.8 is read as 3.7"],
    "version_38": ["{}:1:10: warning: version 3.8 is read as 3.7"],
    "backslash": [
        "{}:3:10: warning: '\\' in the file name '.\\parts\\sizes.inc' is read as '/'",
        "{}:6:51: warning: '\\' in the file name '..\\wild\\oak.png' is read as '/'"],
    "keyword_names": [
        keyword(4, "slope"), keyword(5, "thickness"), keyword(6, "poly"),
        keyword(7, "translucency"), keyword(8, "emission"), *UNNAMED],
    "missing_font": ["{}:5:12: warning: cannot find the font 'C:\\WINDOWS\\Fonts\\arial.ttf': "
                     "cyrvetic.ttf stands for it"],
    "moray_radiosity": [
        "{}:4:3: warning: hf_gray_16 does nothing",
        "{}:5:13: warning: radiosity is not rendered yet: ignored",
        "{}:8:5: warning: distance_maximum is no setting of POV-Ray 3.7: ignored"],
    "no_semicolon": semicolons(2) + UNNAMED,
    "no_semicolon_37": semicolons(2),
    "other_case": [other_case("3:10", "Colors.INC"), other_case("4:10", "Other_Case_Parts.inc"),
                   other_case("7:41", "OAK.PNG")],
    "poseray_comma": ["{}:4:16: warning: ',' is read as a decimal point"],
}
# What is said of files that POV-Ray 3.7 renders; nothing of those that are not here.
SAID = {
    "ldcad": ["{}:5:13: warning: radiosity is not rendered yet: ignored"],
    "ldview": UNNAMED,
    "leocad": UNNAMED,
    "moray": ["{}:7:3: warning: hf_gray_16 does nothing"],
    "morpho": UNNAMED,
    "version_none": UNNAMED,
    "vmd": UNNAMED,
}
SIMPLE = WILD / "touching.pov"


def headlines(output):
    """The messages without source lines and notes."""
    return [line for line in output.splitlines() if re.search(r": (warning|error): ", line)]


def same(ours, theirs):
    """The share of pixels that are close in every channel."""
    close = sum(
        all(abs(a - b) <= CLOSE for a, b in zip(ours.rgb[i : i + 3], theirs.rgb[i : i + 3]))
        for i in range(0, len(theirs.rgb), 3))
    return 3 * close / len(theirs.rgb)


class FilesInTheWild(ProgramTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(WILD, self.folder / "wild", ignore=shutil.ignore_patterns("reference"))
        self.folder = self.folder / "wild"

    def draw(self, scene, *options):
        return self.dioptre(f"+I{scene}", "+Oa.ppm", "+W64", "+H48", "+FP", "-D", "-A", "-V",
                            *options)

    def assert_looks_like(self, name):
        theirs = images.read_ppm(WILD / "reference" / f"{name}.ppm")
        ours = images.read_ppm(self.folder / "a.ppm")
        self.assertEqual((ours.width, ours.height), (theirs.width, theirs.height))
        self.assertGreaterEqual(same(ours, theirs), ENOUGH)

    def test_every_file_renders_says_what_it_should_and_looks_like_povrays(self):
        references = sorted((WILD / "reference").glob("*.ppm"))
        self.assertGreater(len(references), 25)
        for path in references:
            with self.subTest(path.stem):
                outcome = self.draw(f"{path.stem}.pov")
                self.assertEqual(outcome.status, 0, outcome.output)
                said = FORGIVEN.get(path.stem, SAID.get(path.stem, []))
                self.assertEqual(headlines(outcome.output),
                                 [each.format(path.stem + ".pov") for each in said])
                self.assert_looks_like(path.stem)

    def test_what_is_forgiven_is_an_error_when_strict(self):
        for name, said in FORGIVEN.items():
            with self.subTest(name):
                outcome = self.draw(f"{name}.pov", "--strict")
                self.assertEqual(outcome.status, 1, outcome.output)
                error = headlines(outcome.output)[-1]
                self.assertIn(": error: ", error)
                self.assertIn(error.split(": error: ")[0],
                              [each.format(name + ".pov").split(": warning: ")[0] for each in said])

    def test_strictness_refuses_nothing_that_povray_renders(self):
        for path in sorted((WILD / "reference").glob("*.ppm")):
            if path.stem in FORGIVEN:
                continue
            with self.subTest(path.stem):
                outcome = self.draw(f"{path.stem}.pov", "--strict")
                self.assertEqual(outcome.status, 0, outcome.output)

    def test_any_name_of_a_file_will_do(self):
        for name in ("two words.pov", "höhe.pov", "日本.pov", "it's 100%.pov"):
            with self.subTest(name):
                shutil.copy(SIMPLE, self.folder / name)
                outcome = self.draw(name)
                self.assertEqual((outcome.status, outcome.output), (0, ""))
                self.assert_looks_like("touching")

    def test_a_povray_ini_of_another_machine_does_not_hide_the_library(self):
        self.write("povray.ini", "; of an old installation\n"
                   'Library_Path="C:\\Program Files\\POV-Ray\\include"\n'
                   "Library_Path=/usr/local/lib/povray31/include\n"
                   "Width=320\nHeight=200\nDisplay=on\nVerbose=off\nTest_Abort=On\nBounding=On\n")
        outcome = self.draw("ase.pov")
        self.assertEqual(outcome.status, 0, outcome.output)
        self.assert_looks_like("ase")

    def test_a_missing_image_or_include_is_an_error_at_its_name(self):
        outcome = self.draw("missing_image.pov")
        self.assertEqual(outcome.status, 1)
        self.assertIn("missing_image.pov:5:42: error: cannot find the file "
                      "'C:/pictures/bark.jpg'", outcome.output)
        scene = self.write("lonely.pov", '#version 3.7;\n#include "lgeo.inc"\n')
        outcome = self.draw(scene.name)
        self.assertEqual(outcome.status, 1)
        self.assertIn("lonely.pov:2:10: error: cannot find the file 'lgeo.inc'", outcome.output)


if __name__ == "__main__":
    unittest.main()
