# SPDX-License-Identifier: Apache-2.0
"""The results of tools/parity as text, Markdown, CSV and HTML."""

import csv
import html
import io
import re
from collections import Counter, defaultdict
from dataclasses import dataclass

VERDICTS = ("same", "same in the mean", "different", "error", "time limit", "no reference")
SAME = ("same", "same in the mean")


@dataclass
class Head:
    """What was compared."""

    povray: str
    dioptre: str
    options: list


def compared(results):
    return [result for result in results if "dioptre" in result]


def cause_of_error(result):
    """An error without the place, so that equal ones count together."""
    text = re.sub(r"^\S+:\d+(:\d+)?:\s*", "", result["dioptre"]["error"])
    return re.sub(r"^error:\s*", "", text) or "error"


def summary(results):
    """The counts in a few lines."""
    counts = Counter(result["verdict"] for result in results)
    exact = [result for result in results if not result["random"]]
    exact_same = sum(1 for result in exact if result["verdict"] == "same")
    pairs = [r for r in compared(results) if r["verdict"] in (*SAME, "different")]
    theirs = sum(result["povray"]["cpu"] for result in pairs)
    ours = sum(result["dioptre"]["cpu"] for result in pairs)
    peak = max((result["dioptre"]["peak_mb"] for result in pairs), default=0)
    lines = [f"{len(results)} scenes: "
             + ", ".join(f"{counts[name]} {name}" for name in VERDICTS if counts[name])]
    lines.append(f"Scenes without randomness: {exact_same} of {len(exact)} the same")
    if pairs:
        lines.append(f"Processor time where both rendered: POV-Ray {theirs:.1f} s, "
                     f"Dioptre {ours:.1f} s ({theirs / max(ours, 1e-3):.2f} times as fast)")
        lines.append(f"Largest memory of Dioptre: {peak:.0f} MB")
    return "\n".join(lines)


def groups(results):
    """What keeps scenes from being the same: cause to list of results, the largest first."""
    causes = defaultdict(list)
    for result in compared(results):
        if result["verdict"] in SAME:
            continue
        facts = result["dioptre"]
        if result["verdict"] == "time limit":
            causes["Time limit"].append(result)
        elif result["verdict"] == "error":
            causes[f"Error: {cause_of_error(result)}"].append(result)
        elif facts["notices"]:
            for feature in facts["notices"]:
                causes[f"Not rendered: {feature}"].append(result)
        elif result["random"]:
            causes[f"Random in POV-Ray: {result['random']}"].append(result)
        else:
            causes["No notice given: to be looked at"].append(result)
    return sorted(causes.items(), key=lambda item: (-len(item[1]), item[0]))


def percent(result):
    same = result.get("same_pixels")
    return f"{100 * same:.2f}" if same is not None else ""


def percent_of_blocks(result):
    same = result.get("same_blocks")
    return f"{100 * same:.2f}" if same is not None else ""


def _folders(results):
    table = defaultdict(Counter)
    for result in results:
        table[result["scene"].split("/")[0]][result["verdict"]] += 1
    return sorted(table.items())


def write_markdown(path, head, results):
    """The report for docs/: counts, causes, and a line for each scene."""
    out = io.StringIO()
    print("# POV-Ray's own scenes in both programs\n", file=out)
    print("Made by `tools/parity`; do not edit. Each scene is rendered by "
          f"{head.povray} and by {head.dioptre} with `{' '.join(head.options)}`. *Same* means that "
          "at least 99 % of the pixels differ by no more than 2/255 in every channel; *same in the "
          "mean*, of scenes where nothing but jittered area lights, crand and focal blur is random, "
          "that the means of at least 99 % of the blocks of 8 x 8 pixels do.\n", file=out)
    print("\n".join(f"- {line}" for line in summary(results).split("\n")), file=out)
    print("\n| folder | scenes | same | in the mean | different | error | time limit |", file=out)
    print("|---|---:|---:|---:|---:|---:|---:|", file=out)
    for folder, counts in _folders(results):
        print(f"| {folder} | {sum(counts.values())} | {counts['same']} "
              f"| {counts['same in the mean']} | {counts['different']} "
              f"| {counts['error']} | {counts['time limit']} |", file=out)
    print("\n## Why scenes are not the same\n", file=out)
    print("A scene counts under each feature it lacks.\n", file=out)
    print("| cause | scenes | which |", file=out)
    print("|---|---:|---|", file=out)
    for cause, members in groups(results):
        names = [member["scene"].removesuffix(".pov") for member in members]
        shown = ", ".join(names[:8]) + (", ..." if len(names) > 8 else "")
        print(f"| {cause.replace('|', '/')} | {len(members)} | {shown} |", file=out)
    print("\n## Every scene\n", file=out)
    print("| scene | verdict | same % | blocks % | mean difference | POV-Ray s | Dioptre s | notes |",
          file=out)
    print("|---|---|---:|---:|---:|---:|---:|---|", file=out)
    for result in results:
        ours = result.get("dioptre", {})
        notes = ours.get("error") or ", ".join(ours.get("notices", [])) or result["random"]
        print(f"| {result['scene']} | {result['verdict']} | {percent(result)} "
              f"| {percent_of_blocks(result)} | {result.get('mean_difference', '')} "
              f"| {result['povray']['cpu']:.2f} "
              f"| {ours.get('cpu', '')} | {notes.replace('|', '/')} |", file=out)
    path.write_text(out.getvalue())


def write_csv(path, results):
    """One line for each scene, for other programs."""
    with open(path, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["scene", "verdict", "same_pixels", "same_blocks", "mean_difference",
                         "largest_difference", "povray_cpu", "dioptre_cpu", "dioptre_peak_mb",
                         "status", "random", "not_rendered", "error"])
        for result in results:
            ours = result.get("dioptre", {})
            writer.writerow([
                result["scene"], result["verdict"], result.get("same_pixels", ""),
                result.get("same_blocks", ""), result.get("mean_difference", ""),
                result.get("largest_difference", ""),
                result["povray"]["cpu"], ours.get("cpu", ""), ours.get("peak_mb", ""),
                ours.get("status", ""), result["random"], "; ".join(ours.get("notices", [])),
                ours.get("error", "")])


def write_html(path, head, results):
    """A page with each pair of images, the most different first."""
    ordered = sorted(compared(results), key=lambda r: r.get("same_pixels", -1))
    out = io.StringIO()
    print("<!doctype html><meta charset=utf-8><title>Parity</title><style>"
          "body{font:14px sans-serif;background:#222;color:#ddd}figure{margin:12px;"
          "display:inline-block;max-width:500px;vertical-align:top}img{image-rendering:pixelated}"
          "</style>", file=out)
    print(f"<h1>{html.escape(head.povray)} | {html.escape(head.dioptre)} | difference x 4</h1>"
          f"<pre>{html.escape(summary(results))}</pre>", file=out)
    for result in ordered:
        facts = result["dioptre"]
        note = facts["error"] or ", ".join(facts["notices"]) or result["random"]
        name = result["scene"].removesuffix(".pov").replace("/", "__")
        print(f"<figure><img loading=lazy src='pairs/{html.escape(name)}.png'><figcaption>"
              f"{html.escape(result['scene'])}: {result['verdict']} {percent(result)}<br>"
              f"{html.escape(note)}</figcaption></figure>", file=out)
    path.write_text(out.getvalue())
