# SPDX-License-Identifier: Apache-2.0
"""The layers of a picture: Whitted's terms and what pixels cost, in OpenEXR files and as PNGs."""

import math
import struct
import subprocess
import unittest

import exr
from program import ROOT, SCENE, ProgramTest

TERMS = ("ambient", "diffuse", "specular", "reflected", "refracted")
COSTS = {"rays": "Y", "steps": "Y", "tests": "Y", "spans": "Y", "depth": "Z", "time": "Y"}
SCENES = ("glass", "csg", "lights")


def png_size(path):
    data = path.read_bytes()
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    return struct.unpack(">II", data[16:24])


class Layers(ProgramTest):
    def run_well(self, scene, *options):
        outcome = self.dioptre(scene, "+W64", "+H48", "--progress=none", *options)
        self.assertEqual(outcome.status, 0, outcome.output)
        return outcome

    def layers_of(self, scene, *options):
        self.run_well(scene, "-o", "out.exr", *options)
        return exr.read(self.folder / "out.exr")[2]

    def test_the_terms_in_the_file_sum_to_its_picture(self):
        for name in SCENES:
            for extra in ((), ("+A0.2",), ("+A0.2", "+AM2"), ("+UA",)):
                with self.subTest(scene=name, extra=extra):
                    values = self.layers_of(ROOT / f"examples/{name}.pov", "--layers=terms", *extra)
                    for channel in "RGB":
                        terms = zip(*(values[f"{term}.{channel}"] for term in TERMS))
                        for picture, parts in zip(values[channel], terms):
                            bound = 1e-6 * max(1, abs(picture))
                            self.assertLessEqual(abs(picture - math.fsum(parts)), bound)

    def test_terms_sum_in_linear_light_for_any_assumed_gamma(self):
        scene = self.write("scene.pov", SCENE.replace("assumed_gamma 1", "assumed_gamma 2.2"))
        values = self.layers_of(scene, "--layers=terms")
        for channel in "RGB":
            terms = zip(*(values[f"{term}.{channel}"] for term in TERMS))
            for picture, parts in zip(values[channel], terms):
                self.assertLessEqual(abs(picture - math.fsum(parts)), 1e-6)

    def test_the_picture_is_the_same_with_layers_as_without(self):
        scene = ROOT / "examples/glass.pov"
        plain = self.layers_of(scene, "+A0.2")
        self.assertEqual(set(plain), set("RGB"))
        layered = self.layers_of(scene, "+A0.2", "--layers=all")
        for channel in "RGB":
            self.assertEqual(plain[channel], layered[channel])

    def test_another_program_reads_names_and_types(self):
        self.run_well(ROOT / "examples/glass.pov", "-o", "out.exr", "--layers", "terms,cost",
                      "+FE16")
        done = subprocess.run(["exrheader", self.folder / "out.exr"], capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        expected = {channel: "16-bit" for channel in "RGB"}
        expected |= {f"{term}.{channel}": "32-bit" for term in TERMS for channel in "RGB"}
        expected |= {f"{cost}.{channel}": "32-bit" for cost, channel in COSTS.items()}
        listed = [line.strip().split(", ") for line in done.stdout.splitlines()
                  if line.endswith("sampling 1 1")]
        self.assertEqual({name: kind.split()[0] for name, kind, _ in listed}, expected)

    def test_threads_change_nothing_but_the_time(self):
        chosen = "--layers=terms,rays,steps,tests,spans,depth"
        for name in SCENES:
            files = []
            for threads in (1, 3):
                self.run_well(ROOT / f"examples/{name}.pov", "-o", "out.exr", chosen,
                              f"+WT{threads}", "+A0.2")
                files.append((self.folder / "out.exr").read_bytes())
            self.assertTrue(files[0] == files[1], name)

    def test_terms_are_five_pictures_beside_the_output(self):
        self.write("scene.pov", SCENE)
        self.run_well("scene.pov", "--terms")
        for term in TERMS:
            self.assertEqual(png_size(self.folder / f"scene.{term}.png"), (64, 48))
        self.assertEqual(len(list(self.folder.glob("*.png"))), 6)

    def test_heat_maps_have_the_size_of_the_picture_and_a_legend(self):
        self.write("scene.pov", SCENE)
        self.run_well("scene.pov", "+W300", "-o", "out.ppm", "--heatmap", "cost")
        for cost in COSTS:
            width, height = png_size(self.folder / f"out.{cost}.png")
            self.assertEqual(width, 300)
            self.assertGreater(height, 48 + 30)
        self.run_well("scene.pov", "-o", "one.png", "--heatmap=depth")
        self.assertEqual({path.name for path in self.folder.glob("one.*")},
                         {"one.png", "one.depth.png"})

    def test_wrong_names_list_the_right_ones(self):
        for option, known in (("--layers", (*TERMS, *COSTS, "terms", "cost", "all")),
                              ("--heatmap", (*COSTS, "cost", "all"))):
            outcome = self.dioptre("scene.pov", option, "heat")
            self.assertEqual(outcome.status, 64, outcome.output)
            self.assertIn("unknown layer 'heat'; known: " + ", ".join(known), outcome.output)
        outcome = self.dioptre("scene.pov", "--layers")
        self.assertEqual(outcome.status, 64)

    def test_what_cannot_hold_layers_is_refused_before_the_work(self):
        scene = self.write("scene.pov", SCENE)
        for options, reason in ((("--layers=terms",), "OpenEXR"),
                                (("--layers=terms", "-o", "out.hdr"), "OpenEXR"),
                                (("--terms", "-o", "-"), "beside"),
                                (("--heatmap=rays", "-o", "-"), "beside")):
            outcome = self.dioptre(scene, *options)
            self.assertEqual(outcome.status, 1, outcome.output)
            self.assertIn(reason, outcome.output)
            self.assertEqual([path.name for path in self.folder.iterdir()], ["scene.pov"])

    def test_attenuation_is_off_by_default_and_darkens_what_mirrors_and_glass_show(self):
        scene = ROOT / "examples/glass.pov"
        plain = self.layers_of(scene, "--layers=terms")
        self.assertEqual(self.layers_of(scene, "--layers=terms", "--attenuation=0"), plain)
        dim = self.layers_of(scene, "--layers=terms", "--attenuation=0,0.1")
        self.assertLess(sum(dim["refracted.G"]), 0.9 * sum(plain["refracted.G"]))
        for term in ("ambient", "diffuse", "specular"):
            self.assertEqual(dim[f"{term}.G"], plain[f"{term}.G"])
        for wrong in ("", "-1", "1,", "1,2,3", "nan", "x"):
            outcome = self.dioptre(scene, f"--attenuation={wrong}")
            self.assertEqual(outcome.status, 64, wrong)


if __name__ == "__main__":
    unittest.main()
