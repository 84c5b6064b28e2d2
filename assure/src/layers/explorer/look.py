"""Opens an explorer in Chromium without a network, types designs, and prints what it saw as JSON.

Usage: look.py BROWSER PAGE DESIGNS LANGUAGES PICTURES; DESIGNS is a file of JSON, a list of {"name", "text"},
LANGUAGES are names of tabs, separated by commas. Pictures of the page go to the folder PICTURES.
"""

import json
import pathlib
import shutil
import sys

from playwright.sync_api import sync_playwright

import tour

STARTS = 5
ANSWERED = "body[data-answers]"
WAIT = 60_000

# Controls that a screen reader has no name for.
NAMELESS = """() => [...document.querySelectorAll("button, input, select, textarea, [role=slider], [role=img]")]
  .filter((e) => !(e.labels?.length || e.getAttribute("aria-label") || e.getAttribute("aria-labelledby") || e.textContent.trim()))
  .map((e) => e.outerHTML.slice(0, 80))"""

FILES = """() => Object.fromEntries([...document.querySelectorAll("#files article")]
  .map((e) => [e.dataset.file, [...e.querySelectorAll("pre.code code")].map((code) => code.textContent).join("")]))"""

ERRORS = """() => [...document.querySelectorAll("#errors li")].map((e) => ({
  code: e.dataset.code, line: e.dataset.line ?? null, column: e.dataset.column ?? null,
  help: e.querySelector(".help").textContent,
  message: e.querySelector(".message").textContent.replace(/^line \\d+, column \\d+: /, "") }))"""

# Text of the design that is underlined.
MARKED = """() => [...document.querySelectorAll("#marks mark")]
  .filter((e) => e.getClientRects().length > 0).map((e) => e.textContent)"""

VIEWS = {f"{scheme}.{width}": (width, scheme) for width in (1400, 800, 390, 360) for scheme in ("light", "dark")}


class Page:
    """The explorer in a context of its own."""

    def __init__(self, browser, path, told, **options):
        self.context = browser.new_context(offline=True, **options)
        self.page = self.context.new_page()
        own = path.as_uri()
        inside = ("data:", "blob:")

        def requested(request):
            if not request.url.startswith(inside) and request.url.split("#")[0] != own:
                told["requests"].append(request.url)

        self.page.on("request", requested)
        self.page.on("console", lambda message: told["refused"].append(message.text))
        self.page.on("pageerror", lambda error: told["refused"].append(str(error)))
        self.page.goto(own, wait_until="load")
        self.page.wait_for_selector(ANSWERED, timeout=WAIT)

    def after(self, act):
        """Acts, and waits until an answer to it is shown."""
        count = int(self.page.get_attribute("body", "data-answers"))
        act()
        self.page.wait_for_selector(f'body:not([data-answers="{count}"])[data-settled="yes"]', timeout=WAIT)


def started(browser, path, told):
    """Milliseconds from the start of the navigation to the first answer, and those of a processor."""
    opened = Page(browser, path, told)
    time = float(opened.page.get_attribute("body", "data-ready"))
    tools = opened.context.new_cdp_session(opened.page)
    tools.send("Performance.enable")
    metrics = tools.send("Performance.getMetrics")["metrics"]
    busy = 1000 * next(one["value"] for one in metrics if one["name"] == "ProcessTime")
    opened.context.close()
    return time, busy


def looked(browser, path, told, pictures):
    views = {}
    for name, (width, scheme) in VIEWS.items():
        opened = Page(browser, path, told, viewport={"width": width, "height": 900}, color_scheme=scheme)
        page = opened.page
        views[name] = {
            "too_wide": page.evaluate("document.documentElement.scrollWidth > document.documentElement.clientWidth"),
            "paper": page.evaluate("getComputedStyle(document.body).backgroundColor"),
            "nameless": page.evaluate(NAMELESS),
        }
        page.screenshot(path=pictures / f"explorer.{name}.png", full_page=True)
        opened.context.close()
    return views


def typed(opened, design, languages):
    page = opened.page
    opened.after(lambda: page.fill("#text", design["text"]))
    seen = {
        "verdict": page.inner_text("#verdict"),
        "errors": page.evaluate(ERRORS),
        "marked": page.evaluate(MARKED),
        "charts": page.locator("#charts path.line").count(),
        "legend": page.inner_text("#legend"),
        "files": {},
    }
    for language in [] if seen["errors"] else languages:
        opened.after(lambda: page.click(f"#tab-{language}"))
        errors = page.evaluate(ERRORS)
        seen["files"][language] = {"refused": errors} if errors else page.evaluate(FILES)
    opened.after(lambda: page.click(f"#tab-{languages[0]}"))
    return seen


def handled(opened, browser, path, told, design):
    """The keyboard, the address and the comparison."""
    page = opened.page
    opened.after(lambda: page.fill("#text", design["text"]))
    seen = {}
    for name, target, key in [("tau", "#knob-tau", "ArrowRight"), ("pole", ".pole", "ArrowLeft")]:
        before = page.input_value("#text")
        page.locator(target).first.focus()
        # Faster than answers come.
        opened.after(lambda: [page.keyboard.press(key) for _ in range(5)])
        seen[name] = before != page.input_value("#text")
    seen["errors"] = page.evaluate(ERRORS)
    page.click("#compare summary")
    opened.after(lambda: page.locator("#overlays input[type=checkbox]").nth(3).check())
    seen["overlaid"] = page.locator("#legend li.run").count()
    address, text = page.url, page.input_value("#text")
    other = Page(browser, path, told)
    other.page.goto("about:blank")
    other.page.goto(address)
    other.page.wait_for_selector(ANSWERED, timeout=WAIT)
    seen["from_address"] = other.page.input_value("#text") == text
    seen["overlaid_from_address"] = other.page.locator("#legend li.run").count()
    # An address that compares with more mappings than the page takes, 49 kB of them.
    other.page.goto("about:blank")
    other.page.goto(address + "".join(f"&with=exp(a%3D{number})" for number in range(3000)))
    other.page.wait_for_selector(ANSWERED, timeout=WAIT)
    seen["overlaid_at_most"] = other.page.locator("#overlays input:checked").count()
    seen["says_so"] = "At most 20" in other.page.text_content("#said")
    other.context.close()
    return seen


def main(binary, path, designs, languages, pictures):
    path, pictures = pathlib.Path(path).resolve(), pathlib.Path(pictures)
    told = {"requests": [], "refused": []}
    designs = json.loads(pathlib.Path(designs).read_text())
    arguments = ["--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND"]
    with sync_playwright() as play:
        browser = play.chromium.launch(executable_path=shutil.which(binary), args=arguments)
        starts = [started(browser, path, told) for _ in range(STARTS)]
        told["start"], told["busy"] = (min(each) for each in zip(*starts))
        told["views"] = looked(browser, path, told, pictures)
        opened = Page(browser, path, told)
        opened.after(lambda: opened.page.fill("#x0", ""))
        told["designs"] = {design["name"]: typed(opened, design, languages.split(",")) for design in designs}
        told["handled"] = handled(opened, browser, path, told, designs[0])
        told["tour"] = tour.taken(opened)
        browser.close()
    told["requests"] = sorted(set(told["requests"]))
    told["refused"] = sorted(set(told["refused"]))
    print(json.dumps(told))


main(*sys.argv[1:])
