"""A hook of MkDocs that makes the documentation site of the repository's pages, with the same links.

A paragraph that is one link to a CSV file becomes its table.
"""

import csv
import pathlib
import re
import shutil
import subprocess

ROOT = pathlib.Path(__file__).resolve().parent.parent
PAGES = ROOT / "build/site/pages"
LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\((?!https?:|mailto:|#)([^)#\s]+)(#[^)\s]*)?\)")
TABLE = re.compile(r"^\[[^\]]+\]\(([^)\s]+\.csv)\)\.?$", re.M)
LIST = re.compile(r"(?m)^(?![ \t]*(?:[-*]|\d+\.) |[ \t]*$|    |\|)(.*)\n(?=(?:[-*]|\d+\.) )")


def on_pre_build(config) -> None:
    """Copies the pages, and the files that they link to, to the same paths as in the repository."""
    shutil.rmtree(PAGES, ignore_errors=True)
    tracked = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard", "-z"], cwd=ROOT, text=True)
    files = {pathlib.Path(name) for name in tracked.split("\0") if name and (ROOT / name).exists()}
    pages = [name for name in files if name.suffix == ".md" and (len(name.parts) == 1 or name.parts[0] == "docs")]
    for page in pages:
        linked = set(links(page, page))
        linked |= {name for file in linked if file.suffix == ".csv" for name in links(file, page)}
        for name in {page, *linked, pathlib.Path("docs/site.css"), pathlib.Path("docs/site.js")} & files:
            (PAGES / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, PAGES / name)


def links(file: pathlib.Path, page: pathlib.Path):
    """Returns the targets of the links in a file that is part of a page."""
    return (within(page, link[3]) for link in LINK.finditer((ROOT / file).read_text(encoding="utf-8")))


def within(page: pathlib.Path, link: str) -> pathlib.Path:
    """Returns the target of a page's link, relative to the root."""
    target = (ROOT / page.parent / link).resolve()
    return target.relative_to(ROOT) if target.is_relative_to(ROOT) else pathlib.Path("..")


def on_page_markdown(markdown: str, page, config, files) -> str:
    here = pathlib.Path(page.file.src_uri)
    markdown = TABLE.sub(lambda link: table(PAGES / within(here, link[1])), markdown)
    markdown = LIST.sub(r"\1\n\n", markdown)  # shows a list after a line of text, as GitHub does
    return LINK.sub(lambda link: link[2] if is_folder(here, link[3]) else link[0], markdown)


def on_page_content(html: str, page, config, files) -> str:
    """Makes the empty corner of a table an ordinary cell instead of a heading."""
    return re.sub(r"<th[^>]*></th>", "<td></td>", html)


def is_folder(here: pathlib.Path, link: str) -> bool:
    """Whether a link leads to a folder of the repository, which has no page."""
    return (ROOT / within(here, link)).is_dir()


def table(file: pathlib.Path) -> str:
    with open(file, newline="", encoding="utf-8") as lines:
        rows = [[cell.replace("|", "\\|") for cell in row] for row in csv.reader(lines)]
    rows.insert(1, ["---"] * len(rows[0]))
    return "".join("| " + " | ".join(row) + " |\n" for row in rows)
