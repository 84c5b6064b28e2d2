"""A preprocessor of mdBook: links to files outside docs/ lead to the repository, those to README.md to index.html.

Pictures outside docs/, which mdBook does not copy, become part of the page.
"""

import base64
import json
import pathlib
import posixpath
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PICTURE = re.compile(r"(!\[[^]]*\]\()([^):\s]+\.svg)\)")
LINK = re.compile(r"(\]\()([^)#\s]+)((?:#[^)\s]*)?\))")


def rewritten(text, page, repository):
    """The text of a page, whose path is from docs/."""

    def place(target):
        return posixpath.normpath(posixpath.join("docs", posixpath.dirname(page), target))

    def embedded(picture):
        path = place(picture[2])
        if path.startswith("docs/") or not (ROOT / path).is_file():
            return picture[0]
        letters = base64.b64encode((ROOT / path).read_bytes()).decode()
        return f"{picture[1]}data:image/svg+xml;base64,{letters})"

    def moved(link):
        target = link[2]
        path = place(target)
        if ":" in target:
            return link[0]
        if path.startswith("docs/"):
            return link[1] + re.sub(r"\bREADME\.md$", "index.md", target) + link[3]
        return f"{link[1]}{repository}/blob/main/{path}{link[3]}"

    return LINK.sub(moved, PICTURE.sub(embedded, text))


def walk(items, repository):
    """Rewrites chapters in place, with those below them."""
    for item in items:
        chapter = item.get("Chapter") if isinstance(item, dict) else None
        if chapter and chapter.get("path"):
            chapter["content"] = rewritten(chapter["content"], chapter["source_path"], repository)
        if chapter:
            walk(chapter["sub_items"], repository)


if sys.argv[1:2] == ["supports"]:
    sys.exit(0)
context, book = json.load(sys.stdin)
html = context["config"]["output"]["html"]
walk(book.get("items", book.get("sections")), html["git-repository-url"])
json.dump(book, sys.stdout)
