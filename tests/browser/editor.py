"""The page of `eagerx-gen serve` as tests use it: with pointer and keys. What it does is done as people do it; scripts only
look, and wait until the server has answered."""
import contextlib
import os
import pathlib
import re
import signal
import subprocess
import time

try:
    from selenium import webdriver
    from selenium.common.exceptions import StaleElementReferenceException, WebDriverException
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import Select
except ImportError:
    webdriver = None

ROOT = pathlib.Path(__file__).resolve().parents[2]
POINTER_MS = 20  # of a way of the pointer: Selenium's own is a quarter of a second
PATIENCE_S = 60  # for what takes less than a second on a machine that has time
problems = []
checks = 0


class NoBrowser(Exception):
    pass


class NoServer(Exception):
    pass


def check(good, what):
    global checks
    checks += 1
    if not good:
        problems.append(what)
        print("FAIL", what, flush=True)
    return good


def failed():
    print(f"{checks} checks, {len(problems)} failed")
    return 1 if problems or not checks else 0


def environment():
    """Programs and libraries are looked at for their bits alone: they are those of every build type."""
    return dict(os.environ, EAGERX_HOME=str(ROOT), CMAKE_BUILD_TYPE="Fastest",
                CMAKE_TOOLCHAIN_FILE=str(ROOT / "tests/support/quick_simd.cmake"))


def hash_of(generator, graph, output):
    """The trace hash of 300 steps of a graph's program; None and the output if there is none."""
    done = subprocess.run([str(generator), "run", str(graph), "-o", str(output), "--seed", "1", "--steps", "300", "--hash"],
                          env=environment(), capture_output=True, text=True, timeout=900, check=False)
    found = re.search(r"trace hash ([0-9a-f]+)", done.stdout)
    if not found:
        print(done.stdout[-2000:], done.stderr[-2000:])
    return found and found[1]


@contextlib.contextmanager
def served(generator, graph):
    """The address of the page of a graph."""
    process = subprocess.Popen([str(generator), "serve", str(graph)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                               env=environment())
    try:
        address = process.stdout.readline().strip()
        if not address.startswith("http://127.0.0.1:"):
            said = process.communicate(timeout=10)[1]
            raise (NoServer if "libcpp-httplib" in said else AssertionError)(said.strip().splitlines()[0] if said else "serve says nothing")
        yield address
    finally:
        if process.poll() is None:
            process.send_signal(signal.SIGINT)
        try:
            process.communicate(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.communicate()
            check(False, "serve does not end")


def browser():
    if webdriver is None:
        raise NoBrowser("there is no selenium (toolchains/install-packages browser)")
    options = webdriver.ChromeOptions()
    for word in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--window-size=1400,900",
                 "--force-device-scale-factor=1", "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    try:
        return webdriver.Chrome(options=options)
    except WebDriverException as problem:
        raise NoBrowser(f"there is no browser (toolchains/install-packages browser): {problem.msg}") from problem


@contextlib.contextmanager
def editor(generator, graph, screenshots, name):
    driver = browser()
    try:
        with served(generator, graph) as address:
            page = Editor(driver, screenshots, name)
            page.driver.get(address)
            page.until(lambda: page.js("return typeof editing !== 'undefined' && editing.client.state !== null"), "the page")
            page.settle()
            try:
                yield page
            except BaseException:
                page.shot("failed")
                print(*(entry["message"] for entry in driver.get_log("browser")), sep="\n")
                raise
            page.well_behaved()
    finally:
        driver.quit()


class Editor:
    if webdriver is not None:
        ENTER, ESCAPE, DELETE, TAB, ARROW_RIGHT = Keys.ENTER, Keys.ESCAPE, Keys.DELETE, Keys.TAB, Keys.ARROW_RIGHT
        SHIFT_RIGHT, UNDO, REDO = (Keys.SHIFT, Keys.ARROW_RIGHT), (Keys.CONTROL, "z"), (Keys.CONTROL, Keys.SHIFT, "z")

    def __init__(self, driver, screenshots, name):
        self.driver, self.screenshots, self.name = driver, screenshots, name

    # ---- Looking
    def js(self, text, *values):
        return self.driver.execute_script(text, *values)

    def until(self, condition, what, patience_s=PATIENCE_S):
        end = time.monotonic() + patience_s
        while not (found := condition()):
            if time.monotonic() > end:
                self.shot("never")
                raise AssertionError(f"{self.name}: never: {what}")
            time.sleep(0.05)
        return found

    def settle(self):
        """The server has answered everything, and the answer is painted."""
        self.driver.execute_async_script(
            "const done = arguments[0]; setTimeout(() => editing.client.inTurn(() => {}).then(() => "
            "requestAnimationFrame(() => requestAnimationFrame(() => done()))), 20)")

    def find(self, css):
        return self.driver.find_element(By.CSS_SELECTOR, css)

    def all(self, css, text=""):
        """Those that are shown, with this text in them. One question to the browser: each takes milliseconds."""
        return self.js("return [...document.querySelectorAll(arguments[0])].filter((each) => each.getClientRects().length > 0 && "
                       "(arguments[1] === '' || each.innerText.includes(arguments[1])))", css, text)

    def text(self, css):
        return self.js("const found = document.querySelector(arguments[0]); return found ? found.innerText ?? found.textContent : ''", css)

    def is_good(self):
        self.settle()
        return self.js("return editing.client.state.good")

    def notice(self):
        return self.js("return editing.notice")

    def shot(self, what):
        if self.screenshots:
            self.driver.save_screenshot(str(self.screenshots / f"serve-{self.name}-{what}.png"))

    def narrow_enough(self):
        wide = self.js("return document.documentElement.scrollWidth - innerWidth")
        check(wide <= 0, f"{self.name}: the page is {wide} pixels too wide")

    def well_behaved(self):
        broken = self.js("return document.body.innerText.match(/undefined|\\bNaN\\b|\\[object/)")
        check(not broken, f"{self.name}: the page says {broken}")
        said = [entry["message"] for entry in self.driver.get_log("browser")
                if "favicon" not in entry["message"] and not re.search(r"status of 4(09|22)", entry["message"])]
        check(not said, f"{self.name}: the console says {said}")
        self.narrow_enough()

    # ---- Places
    @property
    def drawing(self):
        return self.find("svg.editor")

    def within(self):
        """Where fields are: in the dialog, if it is open."""
        return "dialog[open] " if self.driver.find_elements(By.CSS_SELECTOR, "dialog[open]") else ""

    def field(self, key):
        found = self.until(lambda: self.all(f"{self.within()}[data-key='{key}']"), f"the field {key}")
        return found[0]

    def port(self, address):
        titles = self.js("return [...document.querySelectorAll('svg.editor g.port')].map((g) => g.querySelector('title').textContent)")
        number = next(i for i, title in enumerate(titles) if re.split(r"[:;]", title)[0] == address)
        return self.driver.find_elements(By.CSS_SELECTOR, "svg.editor g.port circle")[number]

    def box(self, name):
        names = self.js("return [...document.querySelectorAll('svg.editor g.box text.name')].map((text) => text.textContent)")
        return self.driver.find_elements(By.CSS_SELECTOR, "svg.editor g.box text.name")[names.index(name)]

    def entry(self, kind):
        return next(each for each in self.all(".entry", kind) if each.text.split("\n")[0] == kind)

    # ---- Doing
    def pointer_and_keys(self):
        return ActionChains(self.driver, duration=POINTER_MS)

    def write(self, css, text):
        element = self.find(css)
        element.clear()
        element.send_keys(text)

    def type(self, key, text, enter=True, settle=True):
        """Types into a field, or chooses; Enter sends it."""
        try:
            self.type_once(key, text, enter)
        except StaleElementReferenceException:  # a change on the disk made the form anew before the first event
            self.type_once(key, text, enter)
        if settle:
            self.settle()

    def type_once(self, key, text, enter):
        element = self.field(key)
        self.js("arguments[0].scrollIntoView({block: 'center'})", element)
        if element.tag_name == "select":
            Select(element).select_by_value(text)
        elif element.get_attribute("type") == "checkbox":
            if element.is_selected() != text:
                element.click()
        else:
            # To whatever has the focus: a change on the disk makes the form anew, and gives the focus back.
            chain = self.pointer_and_keys().click(element).key_down(Keys.CONTROL).send_keys("a").key_up(Keys.CONTROL)
            chain.send_keys(Keys.BACKSPACE + text + (Keys.ENTER if enter else "")).perform()

    def press(self, text):
        self.all("button", text)[0].click()
        self.settle()

    def can(self, text):
        return self.all("button", text)[0].is_enabled()

    def keys(self, *keys):
        """Each is a text, a key, or some that are held together."""
        for key in keys:
            chain = self.pointer_and_keys()
            if isinstance(key, tuple):
                for held in key[:-1]:
                    chain.key_down(held)
                chain.send_keys(key[-1])
                for held in reversed(key[:-1]):
                    chain.key_up(held)
            else:
                chain.send_keys(key)
            chain.perform()
            self.settle()

    def drag(self, what, to, offset=(0, 0)):
        chain = self.pointer_and_keys().click_and_hold(what)
        chain.move_to_element_with_offset(to, *offset).release().perform()
        self.settle()

    def fill(self, values):
        """The fields of a form, without sending it; `submit` does."""
        for key, text in values.items():
            self.type(key, text, enter=False, settle=False)

    def submit(self):
        revision = self.js("return editing.client.state.revision")
        next(each for each in self.all(f"{self.within()}button.primary")).click()
        self.until(lambda: self.js("return editing.client.state.revision") != revision or self.notice(), "the answer to a form")
        self.settle()
        check(not self.notice(), f"{self.name}: {self.notice()}")

    def search(self, words):
        self.write(".library input", words)

    def add(self, kind, values):
        self.search(kind)
        self.entry(kind).click()
        self.fill(values)
        self.submit()

    def pull(self, address, to, values=None):
        """A wire from a port to another one, or to a box."""
        self.drag(self.port(address), to)
        self.fill(values or {})
        self.submit()

    def connect(self, source, target, values=None):
        """With the button of a form instead of a wire. `actions` and `observations` are new ones."""
        is_new = source == "actions"
        known = target if is_new else source
        self.select_box(known.split(".")[0])
        side = "inputs" if is_new else "outputs"
        button = self.field(f"connect.{side}.{known.split('.', 1)[1]}")
        self.js("arguments[0].scrollIntoView({block: 'center'})", button)
        button.click()
        self.fill({"from" if is_new else "to": source if is_new else target, **(values or {})})
        self.submit()

    def select_box(self, name):
        self.box(name).click()
        self.settle()

    def select_nothing(self):
        self.drawing.send_keys(Keys.ESCAPE)
        self.settle()

    def open_part(self, title):
        for summary in self.all(".inspect summary", title):
            if summary.text.split(" ")[0] == title or summary.text.startswith(title):
                if not self.js("return arguments[0].parentElement.open", summary):
                    self.js("arguments[0].scrollIntoView({block: 'center'})", summary)
                    summary.click()
                return
        raise AssertionError(f"{self.name}: there is no part {title}")

    def lower(self, name):
        self.all(".lower-tabs button", name)[0].click()
        self.settle()

    def view(self, name):
        self.find(f"#tab-{name}").click()
        self.until(lambda: self.js("return document.readyState === 'complete' && typeof state !== 'undefined' && state.view?.id") == name,
                   f"the view {name}")

    def light_or_dark(self):
        self.find("#theme").click()

    def phone(self):
        self.driver.set_window_size(430, 900)

    def desk(self):
        self.driver.set_window_size(1400, 900)
