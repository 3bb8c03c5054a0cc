"""A page in a real browser: Debian's Chromium without a window, driven through chromedriver by the
W3C's WebDriver protocol. Everything that the page logs or asks the network for is kept."""
import base64
import json
import os
import subprocess
import tempfile
import time
import urllib.error
import urllib.request

# Without these Chromium itself asks its maker's hosts for things. It has no graphics card here:
# SwiftShader draws WebGL.
ARGUMENTS = ["--headless=new", "--no-sandbox", "--disable-quic", "--no-first-run",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--disable-dev-shm-usage", "--hide-scrollbars", "--use-angle=swiftshader",
             "--enable-unsafe-swiftshader"]
ELEMENT = "element-6066-11e4-a52e-4f735466cecf"


class Browser:
    """`with Browser() as page: page.open(URL)`. Sizes and places in CSS pixels."""

    def __init__(self, width=1280, height=800, dark=False):
        self._size = width, height
        self._dark = dark
        self._console, self._requests = [], []

    def __enter__(self):
        self._profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        # Output to a file: a pipe that nobody reads would fill up.
        self._log = open(os.path.join(self._profile.name, "chromedriver.log"), "w+b")
        self._driver = subprocess.Popen(["chromedriver", "--port=0"], stdout=self._log,
                                        stderr=subprocess.STDOUT)
        try:
            self._start_session()
        except BaseException:
            self._end()
            raise
        return self

    def __exit__(self, *_):
        try:
            self._ask("DELETE", "")
        finally:
            self._end()

    def _end(self):
        self._driver.terminate()
        self._driver.wait()
        self._log.close()
        self._profile.cleanup()

    def _start_session(self):
        self._session = f"http://127.0.0.1:{self._driver_port()}/session"
        width, height = self._size
        arguments = [*ARGUMENTS, f"--window-size={width},{height}",
                     f"--user-data-dir={self._profile.name}/profile"]
        options = {"binary": "/usr/bin/chromium", "args": arguments,
                   "perfLoggingPrefs": {"enableNetwork": True}}
        logs = {"browser": "ALL", "performance": "ALL"}
        made = self._ask("POST", "", {"capabilities": {"alwaysMatch": {
            "goog:chromeOptions": options, "goog:loggingPrefs": logs}}})
        self._session += "/" + made["sessionId"]
        scheme = {"name": "prefers-color-scheme", "value": "dark" if self._dark else "light"}
        self._devtools("Emulation.setEmulatedMedia", {"features": [scheme]})
        # What the browser's own first page has asked for is not the page's.
        self.open("about:blank")
        self._ask("POST", "/se/log", {"type": "performance"})
        # A window has a least width of its own, a phone is narrower.
        self._devtools("Emulation.setDeviceMetricsOverride",
                       {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})

    def _driver_port(self):
        words = "started successfully on port "
        for _ in range(1000):
            self._log.seek(0)
            told = self._log.read().decode(errors="replace")
            if words in told:
                return int(told.split(words)[1].split(".")[0])
            if self._driver.poll() is not None:
                break
            time.sleep(0.02)
        raise RuntimeError("chromedriver does not start: " + told)

    def _ask(self, method, path, body=None):
        data = None if method == "DELETE" else json.dumps(body or {}).encode()
        request = urllib.request.Request(self._session + path, data, method=method,
                                         headers={"Content-Type": "application/json"})
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return json.load(answer)["value"]
        except urllib.error.HTTPError as error:
            raise RuntimeError(json.load(error)["value"]["message"]) from None

    def _devtools(self, command, parameters):
        return self._ask("POST", "/goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, url):
        """Returns once the page's load event is over."""
        self._ask("POST", "/url", {"url": url})

    def run(self, script, *arguments):
        """What the JavaScript function body returns; a promise is waited for."""
        return self._ask("POST", "/execute/sync", {"script": script, "args": list(arguments)})

    def wait_for(self, script, seconds=5):
        """The first true value of the script; an AssertionError when there is none in time."""
        end = time.monotonic() + seconds
        while True:
            value = self.run(script)
            if value:
                return value
            if time.monotonic() > end:
                raise AssertionError(f"not in {seconds} s: {script}; console: {self.console()}")
            time.sleep(0.02)

    def _element(self, css):
        found = self._ask("POST", "/element", {"using": "css selector", "value": css})
        return found[ELEMENT]

    def click(self, css):
        """As a person does: refused where something else lies over the element."""
        self._ask("POST", f"/element/{self._element(css)}/click")

    def type(self, css, text):
        self._ask("POST", f"/element/{self._element(css)}/value", {"text": text})

    def drag(self, css, across, down, start=(0, 0)):
        """Presses the mouse at the element's middle plus start, moves it, lets it go."""
        origin = {ELEMENT: self._element(css)}
        left, top = start
        moves = [{"type": "pointerMove", "duration": 0, "origin": origin, "x": left, "y": top},
                 {"type": "pointerDown", "button": 0},
                 {"type": "pointerMove", "duration": 50, "origin": origin,
                  "x": left + across, "y": top + down},
                 {"type": "pointerUp", "button": 0}]
        self._ask("POST", "/actions", {"actions": [{
            "type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"},
            "actions": moves}]})

    def press(self, key):
        """One key on the whole page, a character as WebDriver names it."""
        self._ask("POST", "/actions", {"actions": [{
            "type": "key", "id": "keys", "actions": [{"type": "keyDown", "value": key},
                                                     {"type": "keyUp", "value": key}]}]})

    def screenshot(self, path, whole=False):
        """A PNG of what is seen, or of the page from its beginning to its end."""
        taken = self._devtools("Page.captureScreenshot", {"captureBeyondViewport": whole,
                                                          **({"clip": self._page()} if whole else {})})
        with open(path, "wb") as file:
            file.write(base64.b64decode(taken["data"]))

    def _page(self):
        width, height = self.run("const e = document.documentElement;"
                                 "return [e.scrollWidth, e.scrollHeight]")
        return {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}

    def console(self):
        """All messages since the beginning: what the page logs, and what goes wrong in it."""
        self._console += [f'{entry["level"]}: {entry["message"]}'
                          for entry in self._ask("POST", "/se/log", {"type": "browser"})]
        return self._console

    def requests(self):
        """URLs of all requests since the beginning but those for data that the page itself holds."""
        for entry in self._ask("POST", "/se/log", {"type": "performance"}):
            message = json.loads(entry["message"])["message"]
            if message["method"] == "Network.requestWillBeSent":
                url = message["params"]["request"]["url"]
                if not url.startswith(("data:", "blob:")):
                    self._requests.append(url)
        return self._requests
