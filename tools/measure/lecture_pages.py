# SPDX-License-Identifier: Apache-2.0
"""The pages of docs/lecture: their commands, and the places where the output goes."""

import re
import shlex

SHELL = re.compile(r"```sh\n(.*?)```", re.S)
OUTPUT = re.compile(r"(```sh\n(?:(?!```).)*```\n\n```text\n)(.*?)(```)", re.S)


def commands(text):
    """All command lines of a page, as lists of words without the program's name."""
    lines = [line for block in SHELL.findall(text) for line in block.splitlines() if line.strip()]
    for line in lines:
        if not line.startswith("dioptre "):
            raise ValueError(f"not a command of dioptre: {line}")
    return [shlex.split(line)[1:] for line in lines]


def with_outputs(text, output_of):
    """The page with what output_of(arguments) gives for the last command of each block whose output
    is shown."""

    def fill(match):
        return match.group(1) + output_of(commands(match.group(1))[-1]).rstrip("\n") + "\n" + match.group(3)

    return OUTPUT.sub(fill, text)


def links(text):
    """The files that a page links to or shows."""
    targets = re.findall(r"\]\(([^)#]+)\)", text)
    return [target for target in targets if "://" not in target]
