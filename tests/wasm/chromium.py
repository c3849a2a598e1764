"""Modules of target wasm in headless Chromium, which needs chromium, chromium-driver and python3-selenium."""
import base64
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
MISSING = "there is no selenium: toolchains/install-packages browser"

RUN = """
const done = arguments[arguments.length - 1], [module, options] = arguments;
const bytes = Uint8Array.from(atob(module), (character) => character.charCodeAt(0));
Simulation.of(bytes).then((simulation) => {
  const {about} = simulation;
  simulation.begin(options.seed || 1);
  const began = performance.now();
  const steps = simulation.episodes(options.agent || about.agent, BigInt(options.episodes || 1), BigInt(options.steps || about.steps));
  done({hash: simulation.hash, steps: Number(steps), seconds: (performance.now() - began) / 1000});
}).catch((problem) => done({problem: String(problem)}));
"""


class Chromium:
    """One page with targets/wasm/simulation.js in it."""

    def __init__(self):
        from selenium import webdriver
        options = webdriver.ChromeOptions()
        for word in ("--headless=new", "--no-sandbox", "--disable-dev-shm-usage", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND"):
            options.add_argument(word)
        self.driver = webdriver.Chrome(options=options)
        self.driver.set_script_timeout(300)
        self.driver.get("about:blank")
        script = (ROOT / "targets/wasm/simulation.js").read_text()
        self.driver.execute_script("const element = document.createElement('script'); element.textContent = arguments[0]; "
                                   "document.head.append(element)", script)

    def run(self, image, words):
        """{hash, steps, seconds} of a module with the options of run.js, or {problem}."""
        options = {name.removeprefix("--"): value for name, value in zip(words[::2], words[1::2])}
        return self.driver.execute_async_script(RUN, base64.b64encode(image.read_bytes()).decode(), options)

    def close(self):
        self.driver.quit()
