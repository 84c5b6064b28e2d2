"""Opens pages of HTML in Chromium without a network, and prints what it saw, one line of JSON a page.

Usage: report.py BROWSER PAGE...; beside each page it leaves pictures of it, in three widths, light and dark.
"""

import json
import pathlib
import shutil
import sys

from playwright.sync_api import sync_playwright

# What is looked at from inside: the policy of a page forbids it scripts, not its debugger.
LOOK = """() => {
  const boxes = (name) => [...document.querySelectorAll(name)].map((e) => e.getBoundingClientRect());
  const seen = (name) => boxes(name).filter((b) => b.width > 2 && b.height > 2).length;
  const colour = (e, key) => getComputedStyle(e)[key];
  const page = document.documentElement;
  return {
    formulas: boxes("math").length,
    formulas_seen: seen("math"),
    figures_seen: seen("svg"),
    text: document.body.innerText.length,
    too_wide: page.scrollWidth > page.clientWidth,
    letters: Math.min(...[...document.querySelectorAll("svg text")].map((e) => parseFloat(colour(e, "fontSize")) * e.getScreenCTM().a)),
    paper: colour(document.body, "backgroundColor"),
    figure_paper: colour(document.querySelector("svg rect"), "fill"),
  };
}"""

VIEWS = {f"{scheme}.{width}": (width, scheme) for width in (1400, 500, 360) for scheme in ("light", "dark")}


def look(browser, path):
    told = {"requests": [], "refused": [], "views": {}}
    for name, (width, scheme) in VIEWS.items():
        viewport = {"width": width, "height": 900}
        context = browser.new_context(viewport=viewport, color_scheme=scheme, offline=True)
        page = context.new_page()
        page.on("request", lambda request: told["requests"].append(request.url))
        page.on("console", lambda message: told["refused"].append(message.text))
        page.on("pageerror", lambda error: told["refused"].append(str(error)))
        # What is not the page itself gets no answer, if it ever asks.
        page.route("**/*", lambda r: r.continue_() if r.request.url == path.as_uri() else r.abort())
        page.goto(path.as_uri(), wait_until="load")
        for details in page.locator("details").all():
            details.locator("summary").click()
        told["views"][name] = page.evaluate(LOOK)
        page.screenshot(path=path.with_suffix(f".{name}.png"), full_page=True)
        if name == "light.1400":
            told["printed"] = len(page.pdf())
        context.close()
    told["requests"] = sorted({url for url in told["requests"] if url != path.as_uri()})
    told["refused"] = sorted(set(told["refused"]))
    return told


def main(binary, paths):
    arguments = ["--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND"]
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=shutil.which(binary), args=arguments)
        for path in paths:
            print(json.dumps(look(browser, pathlib.Path(path).resolve())))
        browser.close()


main(sys.argv[1], sys.argv[2:])
