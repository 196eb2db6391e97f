# SPDX-License-Identifier: Apache-2.0
"""The tools: the layer check refuses what it should, the image comparison counts right."""

import importlib.machinery
import importlib.util
import struct
import unittest
import zlib

from program import ROOT, ProgramTest, images, processes


def load_tool(name):
    loader = importlib.machinery.SourceFileLoader(name, str(ROOT / "tools" / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


class LayerCheck(ProgramTest):
    def check(self, file, include):
        path = self.folder / "src/dioptre" / file
        path.parent.mkdir(parents=True)
        path.write_text(f'#pragma once\n#include "{include}"\n')
        (self.folder / "layers.txt").write_text((ROOT / "layers.txt").read_text())
        return list(load_tool("check_layers").check(self.folder))

    def test_a_layer_may_not_reach_up(self):
        self.assertEqual(
            self.check("geometry/box/box.h", "dioptre/scene/scene.h"),
            ['src/dioptre/geometry/box/box.h:2: error: '
             'geometry may not include "dioptre/scene/scene.h"'])

    def test_only_data_headers_where_only_data_is_allowed(self):
        self.assertEqual(len(self.check("scene/a.h", "dioptre/geometry/shape.h")), 1)

    def test_data_headers_where_data_is_allowed(self):
        self.assertEqual(self.check("scene/a.h", "dioptre/geometry/box/box.h"), [])

    def test_io_may_not_see_the_renderer(self):
        self.assertEqual(len(self.check("io/a.cpp", "dioptre/render/compile.h")), 1)

    def test_the_library_may_not_include_a_program(self):
        self.assertEqual(len(self.check("core/a.h", "apps/dioptre/settings.h")), 1)

    def test_a_folder_must_be_in_the_table(self):
        self.assertEqual(len(self.check("extra/a.h", "dioptre/core/vec.h")), 1)


class ImageComparison(ProgramTest):
    def test_ppm_of_16_bits_is_read_as_8(self):
        path = self.write("a.ppm", b"P6\n# a note\n2 1\n65535\n" + struct.pack(
            ">6H", 0, 65535, 32768, 128, 129, 257))
        self.assertEqual(images.read_ppm(path).rgb, bytes([0, 255, 128, 0, 1, 1]))

    def test_a_cut_ppm_is_refused(self):
        with self.assertRaises(ValueError):
            images.read_ppm(self.write("a.ppm", b"P6 2 1 255\n12345"))

    def test_same_pixels_are_those_within_the_tolerance(self):
        first = images.Image(4, 1, bytes([10] * 12))
        second = images.Image(4, 1, bytes([10, 10, 10, 12, 8, 10, 13, 10, 10, 10, 10, 110]))
        measured = images.compare(first, second)
        self.assertEqual(measured.same_pixels, 0.5)
        self.assertEqual(measured.largest_difference, 100)

    def test_png_holds_the_pixels(self):
        path = self.folder / "a.png"
        images.write_png(path, images.Image(1, 2, bytes([1, 2, 3, 4, 5, 6])))
        data = path.read_bytes()
        start = data.index(b"IDAT")
        size = struct.unpack(">I", data[start - 4 : start])[0]
        rows = zlib.decompress(data[start + 4 : start + 4 + size])
        self.assertEqual(rows, bytes([0, 1, 2, 3, 0, 4, 5, 6]))


class Limits(ProgramTest):
    def test_the_processor_limit_ends_a_run(self):
        outcome = processes.run(["sh", "-c", "while :; do :; done"], cpu_seconds=1)
        self.assertTrue(outcome.timed_out)
        self.assertLess(outcome.cpu_seconds, 4)


if __name__ == "__main__":
    unittest.main()
