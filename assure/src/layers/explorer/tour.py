"""What the page shows and does with designs of each kind, one fact each, for look.py."""

CHAIN = """# At rest after 1 s.
n = 2
mu = "exp(a=1)"
poles = [-4, -5]
sample_time = 1e-3
tau = 1        # s
u_max = 50
"""

OPEN = """n = 2
mu = "exp(a=1)"
poles = [-4, -5]
"""

OBSERVER = """n = 2
mu = "exp(a=1)"
clock = "samples"
sample_time = 1e-3
delay = 1
poles = [-4, -5]
measured = ["x1"]
disturbance = "constant"
observer_poles = [-4, -5, -6]
observer_samples = 200

[params]
tau = 0.8
u_max = 200
"""

# The sign that an answer is awaited is for what takes longer than 150 ms, which no design does on every machine:
# requests are held back.
HELD_BACK = """() => {
  window.awaited = [];
  const busy = document.querySelector("#busy");
  new MutationObserver(() => awaited.push(busy.textContent)).observe(busy, { childList: true });
  window.post = Worker.prototype.postMessage;
  Worker.prototype.postMessage = function (...words) {
    setTimeout(() => post.apply(this, words), 400);
  };
}"""

REFERENCE = CHAIN.replace("n = 2", 'n = 2\nreference = "0.1*sin(2*t)"')

LIMITED = """n = 2
mu = "exp(a=1)"
clock = "samples"
sample_time = 1e-3
poles = [-4, -5]
x0_max = [1, 0.1]
late = "extend"

[params]
tau = 0.5
u_max = 20

[[event]]
at = 0.2
kick = 8
for = 0.1
"""

FILTER = """what = "filter"
n = 2
sample_time = 1e-3
keep_below = [0.5, 0.8]
keep_above = [-0.5, -0.8]
keep_poles = [-10, -40]

[params]
tau = 0.4
u_max = 10
"""

PATHS = '() => [...document.querySelectorAll("#charts path.line")].map((e) => e.getAttribute("d")).join("|")'

# Parts of the window that neither side of the page fills, as a share of its height.
GAP = """() => {
  const [side, stage] = [".side", ".stage"].map((name) => document.querySelector(name).getBoundingClientRect());
  const last = document.querySelector(".stage").lastElementChild.getBoundingClientRect().bottom;
  return Math.max(Math.abs(side.bottom - stage.bottom), Math.min(stage.bottom, innerHeight) - last) / innerHeight;
}"""


def taken(opened):
    """Each fact by its name; a page that is as it should be has none that is false."""
    page = opened.page

    def put(design, x0=""):
        page.fill("#x0", x0)
        opened.after(lambda: page.fill("#text", design))

    def count(selector):
        return page.locator(selector).count()

    facts = {}
    page.set_viewport_size({"width": 1400, "height": 900})
    put(CHAIN, "1, 0")
    facts["errors are logarithmic at first"] = page.is_checked("#log") and "|x1|" in page.text_content("#charts")
    facts["neither side of a wide page is empty"] = page.evaluate(GAP) < 0.2
    order = page.evaluate('() => ["#runs", "#checks", "#output"].map((id) => document.querySelector(id).getBoundingClientRect().top)')
    facts["the picture is above checks and code"] = order == sorted(order)
    facts["the head of the code is folded"] = count("#files details.fold:not([open])") > 0 and "Head" in page.text_content("#files summary")
    first = page.locator("#files article").first.locator("pre.code").last.locator("code").text_content()
    facts["the code is first"] = first.startswith("ptc_status ")
    facts["code is coloured and numbered"] = count("#files .word") > 0 and count("#files .gutter[data-numbers]") > 0
    facts["the loop is drawn"] = count("#diagram rect.box") == 5
    facts["margins are shown"] = "times the input gain" in page.text_content("#figures")
    facts.update(tried(opened, put))
    put(OPEN)
    facts["defaults are said"] = "tau = 1 s" in page.text_content("#legend") and "1 s" in page.text_content("#value-tau")
    page.locator("#knob-tau").focus()
    opened.after(lambda: page.keyboard.press("ArrowRight"))
    facts["a slider adds its key"] = "\ntau = 1.05\n" in page.input_value("#text")
    put(OBSERVER, "0.1, 0")
    facts["estimates are drawn"] = count("#charts path.run0.estimate") == 2 and "estimated disturbance" in page.text_content("#charts")
    opened.after(lambda: page.click("#tab-formulas"))
    facts["a law in samples is typeset"] = count("#files math mfrac") > 0 and count("#files math mtable") > 0
    put(REFERENCE)
    facts["a law in time is typeset"] = count("#files math mfrac") > 0 and count("#files math msup") > 0
    opened.after(lambda: page.click("#tab-c"))
    facts["tracking errors are drawn"] = "tracking error" in page.text_content("#charts")
    opened.after(lambda: page.click("#log"))
    facts["the reference is drawn"] = count("#charts path.run0.reference") == 2
    opened.after(lambda: page.click("#log"))
    put(LIMITED)
    facts["a deadline in flight is drawn"] = count("#charts path.line") > 0 and "deadlines at" in page.text_content("#legend")
    facts["the worst case and the soonest deadline are shown"] = all(
        text in page.text_content("#figures") for text in ("worst case", "Soonest deadline"))
    opened.after(lambda: page.click("#figures button"))
    facts["the soonest deadline can be taken"] = "tau = 0.5\n" not in page.input_value("#text")
    put(FILTER)
    facts["a filter says why it is not run"] = "not simulated: " in page.text_content("#legend")
    return facts


def tried(opened, put):
    """The sliders of the plant, comments, and the sign that an answer is awaited."""
    page = opened.page
    facts = {}
    for name in ("gain", "force", "friction"):
        text, before = page.input_value("#text"), page.evaluate(PATHS)
        page.locator(f"#try-{name}").focus()
        opened.after(lambda: page.keyboard.press("PageUp"))
        facts[f"{name} of the plant is tried"] = page.evaluate(PATHS) != before and page.input_value("#text") == text
        opened.after(lambda: page.click(f".knob:has(#try-{name}) .reset"))
        facts[f"{name} of the plant is reset"] = page.evaluate(PATHS) == before
    page.locator("#knob-tau").focus()
    opened.after(lambda: page.keyboard.press("ArrowRight"))
    facts["comments stay true"] = "# At rest after 1.05 s." in page.input_value("#text")
    page.evaluate(HELD_BACK)
    put(CHAIN.replace("tau = 1", "tau = 2"), "1, 0")
    facts["an answer that takes longer is said to be awaited"] = page.evaluate("() => awaited[0] !== '' && awaited.at(-1) === ''")
    page.evaluate("() => { Worker.prototype.postMessage = post; }")
    put(CHAIN, "1, 0")
    return facts
