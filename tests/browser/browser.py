# SPDX-License-Identifier: BSD-3-Clause
"""Drives a headless Chromium by its DevTools protocol. Its messages go through two pipes, each
ended by a zero byte, so that neither a port nor a library for sockets is needed."""

from __future__ import annotations

import base64
import json
import os
import select
import subprocess
import time
from pathlib import Path

PROGRAM = "chromium"
# WebGL by the processor: no machine must have a graphics card.
FLAGS = ("--headless", "--no-sandbox", "--hide-scrollbars", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--no-first-run", "--disable-background-networking",
         "--remote-debugging-pipe")
_KEYS = {"ArrowLeft": 37, "ArrowRight": 39, "Home": 36, "End": 35, " ": 32, ",": 188}  # by numbers
_PATIENCE = 60.0  # s that an answer may take


class Page:
    """One page of a browser of its own. `problems` lists what the console reported as an error or
    a warning and every exception, `requests` the addresses of all that was fetched."""

    def __init__(self, profile: Path, size: tuple[int, int] = (1200, 900)):
        self.problems: list[str] = []
        self.requests: list[str] = []
        self._number, self._rest = 0, b""
        self._answers: dict[int, dict] = {}
        self._loaded = False
        to_browser, self._write = os.pipe()
        self._read, from_browser = os.pipe()
        # The protocol is spoken on the descriptors 3 and 4.
        command = f'exec "$@" 3<&{to_browser} 4>&{from_browser} 2>"{profile}/log"'
        self._process = subprocess.Popen(
            ["bash", "-c", command, "bash", PROGRAM, *FLAGS, f"--user-data-dir={profile}",
             f"--window-size={size[0]},{size[1]}", "about:blank"],
            pass_fds=(to_browser, from_browser))
        os.close(to_browser)
        os.close(from_browser)
        self._session = None
        target = next(t for t in self._send("Target.getTargets")["targetInfos"]
                      if t["type"] == "page")
        attached = self._send("Target.attachToTarget", targetId=target["targetId"], flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self._send(f"{domain}.enable")

    def open(self, address: str) -> None:
        """Goes to an address and waits until the page has loaded."""
        self._loaded = False
        self._send("Page.navigate", url=address)
        end = time.monotonic() + _PATIENCE
        while not self._loaded:
            self._receive(end)

    def evaluate(self, expression: str):
        """The value of a JavaScript expression; of a promise what it comes to."""
        answer = self._send("Runtime.evaluate", expression=expression, awaitPromise=True,
                            returnByValue=True)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def wait_for(self, expression: str, patience: float = _PATIENCE) -> None:
        """Waits until an expression is true. Raises TimeoutError where it never is."""
        end = time.monotonic() + patience
        while not self.evaluate(expression):
            if time.monotonic() > end:
                raise TimeoutError(f"{expression} is not true; problems: {self.problems}")
            time.sleep(0.05)

    def mouse(self, kind: str, x: float, y: float, **more) -> None:
        """Sends mouseMoved, mousePressed, mouseReleased or mouseWheel at a place of the window."""
        self._send("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def press(self, key: str, text: str = "") -> None:
        """Presses a key and lets it go, for what has the focus."""
        for kind in ("keyDown", "keyUp"):
            self._send("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                       windowsVirtualKeyCode=_KEYS[key], **({"text": text} if text else {}))

    def resize(self, width: int, height: int) -> None:
        self._send("Emulation.setDeviceMetricsOverride", width=width, height=height,
                   deviceScaleFactor=1, mobile=False)

    def before_pages(self, script: str) -> None:
        """Runs a script in every page that is opened from now on, before its own."""
        self._send("Page.addScriptToEvaluateOnNewDocument", source=script)

    def screenshot(self, whole: bool = False) -> bytes:
        """A PNG of the window, or of the whole page."""
        answer = self._send("Page.captureScreenshot", format="png", captureBeyondViewport=whole,
                            **({"clip": self._extent()} if whole else {}))
        return base64.b64decode(answer["data"])

    def close(self) -> None:
        self._session = None
        self._send("Browser.close")
        self._process.wait(_PATIENCE)
        os.close(self._write)
        os.close(self._read)

    def _extent(self) -> dict:
        size = self._send("Page.getLayoutMetrics")["cssContentSize"]
        return {"x": 0, "y": 0, "width": size["width"], "height": size["height"], "scale": 1}

    def _send(self, method: str, **parameters) -> dict:
        self._number += 1
        message = {"id": self._number, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._write, json.dumps(message).encode() + b"\0")
        end = time.monotonic() + _PATIENCE
        while self._number not in self._answers:
            self._receive(end)
        answer = self._answers.pop(self._number)
        if "error" in answer:
            raise RuntimeError(f"{method}: {answer['error']}")
        return answer["result"]

    def _receive(self, end: float) -> None:
        """Waits for more messages and takes them in. Raises TimeoutError after `end`."""
        if not select.select([self._read], [], [], max(0.0, end - time.monotonic()))[0]:
            raise TimeoutError("the browser does not answer")
        part = os.read(self._read, 1 << 20)
        if not part:
            raise RuntimeError("the browser has ended")
        *whole, self._rest = (self._rest + part).split(b"\0")
        for text in whole:
            self._take(json.loads(text))

    def _take(self, message: dict) -> None:
        if "id" in message:
            self._answers[message["id"]] = message
            return
        method, parameters = message["method"], message.get("params", {})
        if method == "Page.loadEventFired":
            self._loaded = True
        elif method == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
        elif method == "Runtime.exceptionThrown":
            self.problems.append(str(parameters["exceptionDetails"]))
        elif method == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning"):
            self.problems.append(str(parameters["args"]))
        elif method == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
            self.problems.append(parameters["entry"]["text"])
