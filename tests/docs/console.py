# SPDX-License-Identifier: GPL-3.0-or-later
"""Console blocks: what the pages and the transcripts of the command line are made of. A block of ```console holds
commands ("$ ", continued by "> ") and their output, in which "..." stands for any text in a line, and alone for any
lines."""
import re

BLOCK = re.compile(r"(?:<!-- ([^>]*) -->\n+)?^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def blocks(text):
    """Each fenced block: (the comment before it or "", its language, its lines)."""
    return [(match[1] or "", match[2], match[3].splitlines()) for match in BLOCK.finditer(text)]


def commands(lines):
    """Each command of a console block, with the lines of output that are shown."""
    found = []
    for line in lines:
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif line.startswith("> ") and not found[-1][1]:
            found[-1] = (found[-1][0] + "\n" + line[2:], [])
        else:
            found[-1][1].append(line)
    return found


def agrees(shown, printed):
    pattern = "".join(r"(?:.*\n)*" if line == "..." else ".*".join(map(re.escape, line.split("..."))) + r"\n"
                      for line in shown)
    return re.fullmatch(pattern, "".join(line + "\n" for line in printed.splitlines())) is not None


def rewritten(text, printed):
    """The text, in which each command of a console block shows what printed(command) says where that does not agree."""
    def block(match):
        if match[2] != "console":
            return match[0]
        lines = []
        for command, shown in commands(match[3].splitlines()):
            now = printed(command)
            lines += ["$ " + command.replace("\n", "\n> "), *(shown if agrees(shown, now) else now.splitlines())]
        begin, end = match.start(3) - match.start(), match.end(3) - match.start()
        return match[0][:begin] + "".join(line + "\n" for line in lines) + match[0][end:]
    return BLOCK.sub(block, text)
