# SPDX-License-Identifier: GPL-3.0-or-later
"""A certificate cut into its parts, and put together again."""

ONE_LINE = ("radius_a", "radius_b", "halfspace_a", "halfspace_b")


class Parts:
    """A certificate without comments and id: the claim's words, and the rows of each part as lists of words. Radius and half-space are
    parts of one row; of a shape, each term is a row and each atom; of patches, each patch is a row, each corner and each side."""

    def __init__(self, text):
        lines = [line.split(" ") for line in text.split("\n")[:-1] if not line.startswith(("#", "id "))]
        assert lines[0][0] == "fathom-certificate" and lines[-1][0] == "end"
        self.format, self.claim, self.which, self.rows, at = lines[0][1], [], "some", {}, 1
        while lines[at][0] != "end":
            word, *rest = lines[at]
            at += 1
            if word == "claim":
                self.claim = rest
                continue
            if word in ONE_LINE:
                self.rows[word] = [rest]
                continue
            count = int(rest[0])
            if word.startswith("shape_"):
                self.rows[word] = []
                for _ in range(count):
                    atoms = int(lines[at][1])
                    self.rows[word] += [["term"], *(list(row) for row in lines[at + 1:at + 1 + atoms])]
                    at += 1 + atoms
                continue
            if word == "patches":
                self.rows[word] = []
                for _ in range(count):
                    end = at + 1 + int(lines[at][1]) + int(lines[at][2])
                    self.rows[word] += [["patch"], *(list(row) for row in lines[at + 1:end])]
                    at = end
                continue
            if word == "directions":
                self.which = rest[1]
            self.rows[word] = [list(row) for row in lines[at:at + count]]
            at += count

    def copy(self):
        other = object.__new__(Parts)
        other.format, other.claim, other.which = self.format, list(self.claim), self.which
        other.rows = {part: [list(row) for row in rows] for part, rows in self.rows.items()}
        return other

    def text(self):
        out, counts = ["fathom-certificate " + self.format], []

        def announce(word, count, more=""):
            counts.append(count)
            out.append(f"{word} {count}{more}")

        for part, rows in self.rows.items():
            if part in ONE_LINE:
                out += [" ".join([part, *row]) for row in rows]
            elif part == "patches":
                starts = [k for k, row in enumerate(rows) if row == ["patch"]] + [len(rows)]
                announce(part, len(starts) - 1)
                for start, end in zip(starts, starts[1:]):
                    sides = [row for row in rows[start + 1:end] if row[0] in ("a", "b")]
                    corners = [row for row in rows[start + 1:end] if row[0] not in ("a", "b")]
                    announce("patch", len(corners), f" {len(sides)}")
                    counts.append(len(sides))
                    out += map(" ".join, corners + sides)
            elif part.startswith("shape_"):
                starts = [k for k, row in enumerate(rows) if row == ["term"]] + [len(rows)]
                announce(part, len(starts) - 1)
                for start, end in zip(starts, starts[1:]):
                    announce("term", end - start - 1)
                    out += map(" ".join, rows[start + 1:end])
            else:
                if part == "directions":
                    out.append(" ".join(["claim", *self.claim]))
                announce(part, len(rows), f" {self.which}" if part == "directions" else "")
                out += map(" ".join, rows)
        counts += [0] * (5 - len(counts) if self.format == "1" else 0)
        return "\n".join(out + [" ".join(map(str, ["end", *counts]))]) + "\n"
