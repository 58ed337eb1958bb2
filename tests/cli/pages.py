# SPDX-License-Identifier: GPL-3.0-or-later
"""The pages of help, as their readers see them."""


def section(text, title):
    """The lines of a section."""
    lines = text.splitlines()
    begin = lines.index(title) + 1
    end = next((i for i in range(begin, len(lines)) if not lines[i]), len(lines))
    return lines[begin:end]


def page_names(test):
    """"" for fathom itself, then "depth", "golden verify" and so on."""
    names = [""]
    for line in section(test.answer("help"), "Commands"):
        if line[2] == " ":
            continue
        names.append(line.split()[0])
        page = test.answer("help", names[-1])
        if "\nCommands\n" in page:
            names += [f"{names[-1]} {task.split()[0]}" for task in section(page, "Commands") if task[2] != " "]
    return names
