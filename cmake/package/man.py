"""Man pages from what `cylon --help` and `cylon COMMAND --help` print: one of the program and one of each command; that
of a command with commands of its own (track) describes these too.

The layout read here is CLI11's: a sentence, "Usage: …", sections of rows whose text begins in column 30 of their line or
of the next, a footer.  A line that does not fit raises ValueError, so that no page loses what the help says.
"""
import re

column = 30  # of a row's text
titles = {"Positionals": "Arguments", "Options": "Options", "Subcommands": "Commands", "Environment": "Environment"}


class Help:
    """What one help says: summary, usage, rows [[name, text]] by section, and the lines of its footer."""

    def __init__(self, text):
        self.summary, usage, *lines = text.splitlines()
        self.usage = usage.removeprefix("Usage: ")
        self.sections, self.footer = {}, []
        rows = None  # of the section that the line is in
        for line, following in zip(lines, lines[1:] + [""]):
            text_below = following.startswith(" " * column)
            if line.rstrip(":") in titles:
                rows = self.sections.setdefault(line.rstrip(":"), [])
            elif not line:
                rows = None
            elif rows is None:
                self.footer.append(line)
            elif line.startswith(" " * column) and rows and not rows[-1][1]:
                rows[-1][1] = line.strip()
            elif re.match(r"  \S", line) and text_below:
                rows.append([line.strip(), ""])
            elif re.match(r"  \S", line) and line[column - 1:column] in (" ", ""):
                rows.append([line[:column].strip(), line[column:].strip()])
            else:
                raise ValueError(f"a line of the help that no man page has room for: {line!r}")


def escaped(text):
    for character, code in {"\\": "\\(rs", "-": "\\-", "'": "\\(aq", "`": "\\(ga", "^": "\\(ha", "~": "\\(ti"}.items():
        text = text.replace(character, code)
    return f"\\&{text}" if text.startswith(".") else text


def name_of(row):
    """A row's name: what is typed bold, the kind of its value in italics."""
    typed, _, kind = row.partition(" ")
    bold = ", ".join(f"\\fB{escaped(word)}\\fR" for word in typed.split(","))
    return f"{bold} \\fI{escaped(kind)}\\fR" if kind else bold


def rows(pairs):
    return [line for name, text in pairs for line in (".TP", name_of(name), escaped(text) or "\\&")]


def paragraphs(lines):
    """Of a footer: lines that are indented, and those that introduce them, stay as they are."""
    out, kept = [], False
    for line, before in zip(lines, [""] + lines):
        if keep := line.startswith(" "):
            out += [] if kept else [".PP", ".nf"]
        elif kept:
            out += [".fi", ".PP"]
        elif not before or before.endswith((".", ":")):
            out.append(".PP")
        kept = keep
        out.append(escaped(line))
    return out + ([".fi"] if kept else [])


def exit_codes(footer):
    """[[code, meaning]] of the line of a footer that lists them."""
    of = [line.removeprefix("Exit codes: ") for line in footer if line.startswith("Exit codes: ")]
    return [re.match(r"(\d+) (.*)", part).groups() for line in of for part in re.split(r", (?=\d)", line.rstrip("."))]


def described(help, heading, shared=()):
    """Usage, summary, footer and sections, under headings of a level; without the lines that another page has."""
    out = [".PP", escaped(help.summary.rstrip(".") + "."),
           *paragraphs([line for line in help.footer if line not in shared and not line.startswith("Exit codes: ")])]
    for section, pairs in help.sections.items():
        out += [heading(titles[section]), *rows(pairs)]
    if codes := exit_codes(line for line in help.footer if line not in shared):
        out += [heading("Exit status"), *rows(codes)]
    return out


def page(name, help, version, parts, see):
    out = [f'.TH {name.upper()} 1 "" "{version}" "User Commands"',
           ".SH NAME", f"{escaped(name)} \\- {escaped(help.summary.removeprefix('Cylon: ').rstrip('.'))}",
           ".SH SYNOPSIS", escaped(help.usage), ".SH DESCRIPTION",
           *described(help, lambda title: f".SH {title.upper()}")]
    for part in parts:
        out += [f".SH {escaped(part.usage)}", *described(part, lambda title: f".SS {title}", help.footer)]
    return "\n".join(out + [".SH SEE ALSO", ",\n".join(f"\\fB{escaped(one)}\\fR(1)" for one in see)]) + "\n"


def pages(said):
    """{name: page}; said(words…) is what the program prints for them."""
    version = said("--version").strip()
    top = Help(said("--help"))
    commands = [name for name, _ in top.sections["Subcommands"]]
    result = {"cylon": page("cylon", top, version, [], [f"cylon-{name}" for name in commands])}
    for name in commands:
        help = Help(said(name, "--help"))
        parts = [Help(said(name, part, "--help")) for part, _ in help.sections.get("Subcommands", [])]
        result[f"cylon-{name}"] = page(f"cylon-{name}", help, version, parts, ["cylon"])
    return result
