# SPDX-License-Identifier: Apache-2.0
"""Every page of docs/lecture has commands that work, and shows and links to files that exist."""

import shutil
import unittest
from pathlib import Path

from program import ROOT, ProgramTest

from measure import lecture_pages

PAGES = ROOT / "docs/lecture"
# Smaller pictures than the pages show; a pixel to explain needs the page's own size.
SMALL = ("--size", "48x36")


class Lecture(ProgramTest):
    def pages(self):
        return sorted(PAGES.glob("[0-9][0-9]-*.md"))

    def test_there_is_a_page_for_each_subject(self):
        numbers = [int(page.name[:2]) for page in self.pages()]
        self.assertEqual(numbers, list(range(1, 19)))
        index = (PAGES / "index.md").read_text(encoding="utf-8")
        for page in self.pages():
            self.assertIn(f"({page.name})", index)

    def test_links_lead_somewhere(self):
        for page in [PAGES / "index.md", *self.pages()]:
            for link in lecture_pages.links(page.read_text(encoding="utf-8")):
                with self.subTest(page=page.name, link=link):
                    self.assertTrue((PAGES / link).exists())

    def test_commands_work_and_make_the_pictures(self):
        here = self.folder / "docs/lecture"
        shutil.copytree(PAGES / "scenes", here / "scenes")
        shutil.copytree(ROOT / "examples", self.folder / "examples")
        self.folder = here
        for page in self.pages():
            text = page.read_text(encoding="utf-8")
            shutil.rmtree(here / "images", ignore_errors=True)
            (here / "images").mkdir()
            commands = lecture_pages.commands(text)
            self.assertTrue(commands, page.name)
            for arguments in commands:
                with self.subTest(page=page.name, command=" ".join(arguments)):
                    smaller = () if arguments[0] == "explain" else SMALL
                    outcome = self.dioptre(*arguments, *smaller)
                    self.assertEqual(outcome.status, 0, outcome.output)
            for link in lecture_pages.links(text):
                if Path(link).parts[0] == "images":
                    self.assertTrue((here / link).exists(), f"{page.name}: nothing makes {link}")


if __name__ == "__main__":
    unittest.main()
