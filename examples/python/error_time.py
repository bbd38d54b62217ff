#!/usr/bin/env python3
# SPDX-License-Identifier: AGPL-3.0-or-later
"""Plots error against time of scenes, measured by `integral tune SCENE --csv -o TABLE.csv`:

    error_time.py PLOT.png TABLE.csv... [--target 0.01] [--processor]

Each table has a line for settings with +A (anti-aliasing in the light field) and one for uniform samples.
The script prints, for each line, its slope in the logarithmic plot (-0.5: four times the time for half
the error) and, between the measured settings, the seconds that the target requires. --processor counts
processor time, not elapsed time.
"""
import argparse
import csv
import pathlib

import numpy as np

import integral


def read_table(path, column):
    """{line: [(seconds, error), ...]} of a table, by rising seconds."""
    lines = {"+A": [], "samples": []}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            point = float(row[column]), float(row["error"])
            if min(point) > 0:
                lines["+A" if row["setting"].startswith("+A") else "samples"].append(point)
    return {name: sorted(points) for name, points in lines.items() if len(points) > 1}


def slope(points):
    """Of the straight line through the points in a logarithmic plot."""
    return np.polyfit(*np.log(np.transpose(points)), 1)[0]


def seconds_for(points, target):
    """Where the line first reaches an error, straight between its points; None if it does not."""
    for (time, error), (next_time, next_error) in zip(points, points[1:]):
        if error > target >= next_error:
            part = np.log(error / target) / np.log(error / next_error)
            return float(time * (next_time / time) ** part)
    return points[0][0] if points[0][1] <= target else None


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("plot")
    parser.add_argument("tables", nargs="+", metavar="TABLE.csv")
    parser.add_argument("--target", type=float, default=0.01, help="an error (default: 0.01)")
    parser.add_argument("--processor", action="store_true", help="count processor time")
    given = parser.parse_args()
    column = "processor_seconds" if given.processor else "seconds"
    curves = {}
    try:
        for table in given.tables:
            for name, points in read_table(table, column).items():
                label = f"{pathlib.Path(table).stem}, {name}"
                curves[label] = (*np.transpose(points), "both")
                time = seconds_for(points, given.target)
                needs = "not reached" if time is None else f"{time:.3g} s"
                print(f"{label}: slope {slope(points):.2f}; error {given.target:g}: {needs}")
        if not curves:
            parser.error("no table has two settings; make tables by integral tune SCENE --csv -o FILE")
        integral.plot(given.plot, curves, "processor time (s)" if given.processor else "time (s)",
                      "estimated error (rms, 1 is full scale)", "Error against time", log_x=True, log_y=True)
    except KeyError as error:
        parser.error(f"a table has no column {error}; make it by integral tune SCENE --csv -o FILE")
    except (ValueError, OSError) as error:
        parser.error(str(error))


if __name__ == "__main__":
    main()
