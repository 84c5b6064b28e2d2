"""Opens the pages of a book in Chromium without a network, and prints as JSON what is wrong with each.

Usage: book.py BROWSER BOOK SHOWN [PICTURES]; SHOWN is one of its pages, or the folder BOOK itself; pictures of a few pages, in three widths, light and dark, go to the folder PICTURES.
"""

import json
import pathlib
import shutil
import sys

from playwright.sync_api import sync_playwright

VIEWS = [(width, scheme) for width in (1400, 500, 360) for scheme in ("light", "dark")]
PHONE = {"width": 360, "height": 780}
SHOWN = ["start", "simulate", "guide/index", "guide/noise"]
# What mdBook makes of no page.
OWN = ["print.html", "toc.html", "404.html"]

# The book hides what is wider than its page, so the width of the page does not show it.
FAULTS = """() => {
  const clips = (e) => e && e.tagName !== "MAIN" && (getComputedStyle(e).overflowX !== "visible" || clips(e.parentElement));
  const width = document.documentElement.clientWidth;
  const wide = [...document.querySelectorAll("main *")]
    .filter((e) => e.getBoundingClientRect().right > width + 1 && !clips(e.parentElement));
  const blank = [...document.images].filter((e) => e.complete && e.naturalWidth === 0);
  return [...wide.map((e) => `wider than a phone: ${e.tagName} ${e.textContent.slice(0, 40)}`),
          ...blank.map((e) => `a picture that is not shown: ${e.src.slice(0, 80)}`)];
}"""


def main(binary, book, shown, pictures=None):
    book, shown = pathlib.Path(book).resolve(), pathlib.Path(shown).resolve()
    arguments = ["--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND"]
    told = {}
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=shutil.which(binary), args=arguments)
        phone = browser.new_context(viewport=PHONE, offline=True).new_page()
        for path in [shown] if shown.is_file() else sorted(shown.rglob("*.html")):
            if path.name not in OWN:
                phone.goto(path.as_uri(), wait_until="load")
                told[str(path.relative_to(book))] = phone.evaluate(FAULTS)
        for name in SHOWN if pictures else []:
            for width, scheme in VIEWS:
                context = browser.new_context(
                    viewport={"width": width, "height": 900}, color_scheme=scheme, offline=True
                )
                page = context.new_page()
                page.goto((book / f"{name}.html").as_uri(), wait_until="load")
                picture = f"{pictures}/{name.replace('/', '.')}.{scheme}.{width}.png"
                page.screenshot(path=picture, full_page=True)
                context.close()
        browser.close()
    print(json.dumps(told))


main(*sys.argv[1:])
