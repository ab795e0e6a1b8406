"""Headless Chromium over its DevTools pipe: pages opened from files, their errors and requests, scripts, keys, pictures."""

from __future__ import annotations

import base64
import io
import json
import os
import select
import subprocess
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

SOFTWARE = ("--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader")
NO_WEBGL = ("--disable-gpu", "--disable-3d-apis")
_PATIENCE = 60.0


class Browser:
    """A running browser with one page; ``errors`` and ``requests`` gather what the page has said and asked for."""

    def __init__(self, to: int, back: int) -> None:
        self._to, self._back, self._rest, self._next = to, back, b"", 0
        self.place: Path | None = None
        self.errors: list[str] = []
        self.requests: list[str] = []
        target = next(one for one in self.call("Target.getTargets")["targetInfos"] if one["type"] == "page")
        attached = self.call("Target.attachToTarget", targetId=target["targetId"], flatten=True)
        self._session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")

    _session: str | None = None

    def call(self, method: str, **parameters: Any) -> Any:
        """Call a method of the protocol and return its result."""
        self._next += 1
        message = {"id": self._next, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._to, json.dumps(message).encode() + b"\0")
        return self._until(self._next)

    def _until(self, number: int) -> Any:
        until = time.monotonic() + _PATIENCE
        while True:
            message = self._read(until)
            if message.get("id") == number:
                assert "error" not in message, message
                return message["result"]
            self._note(message)

    def _read(self, until: float) -> dict[str, Any]:
        while b"\0" not in self._rest:
            ready, _, _ = select.select([self._back], [], [], max(until - time.monotonic(), 0.0))
            assert ready, "the browser does not answer"
            part = os.read(self._back, 1 << 20)
            assert part, "the browser has gone"
            self._rest += part
        text, _, self._rest = self._rest.partition(b"\0")
        found: dict[str, Any] = json.loads(text)
        return found

    def _note(self, message: dict[str, Any]) -> None:
        told = message.get("params", {})
        match message.get("method"):
            case "Runtime.exceptionThrown":
                details = told["exceptionDetails"]
                self.errors.append(details.get("exception", {}).get("description", details["text"]))
            case "Runtime.consoleAPICalled" if told["type"] in ("error", "warning", "assert"):
                self.errors.append(str(told["args"]))
            case "Log.entryAdded" if told["entry"]["level"] == "error":
                self.errors.append(told["entry"]["text"])
            case "Network.requestWillBeSent":
                self.requests.append(told["request"]["url"])

    def size(self, width: int, height: int, *, phone: bool = False) -> None:
        """Give the window a size in pixels, one a CSS pixel."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=phone)

    def media(self, **features: str) -> None:
        """Set what media queries ask for, like ``prefers_color_scheme="dark"``."""
        wanted = [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.call("Emulation.setEmulatedMedia", features=wanted)

    def open(self, page: Path, fragment: str = "") -> None:
        """Open a page from a file and wait until its player is ready."""
        self.errors.clear()
        self.requests.clear()
        # Another page in between: a new fragment alone would not load it again.
        self.place = None
        self.call("Page.navigate", url="about:blank")
        self.call("Page.navigate", url=page.as_uri() + (f"#{fragment}" if fragment else ""))
        self.run("new Promise((done) => document.readyState === 'complete' ? done() : addEventListener('load', done))")
        self.run("window.skylight.ready.then(() => null)")
        self.place = page

    def run(self, script: str) -> Any:
        """Evaluate an expression, wait for it if it is a promise, and return its value."""
        found = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True, userGesture=True)
        assert "exceptionDetails" not in found, found["exceptionDetails"]
        return found["result"].get("value")

    def frames(self) -> None:
        """Wait for two pictures of the page."""
        self.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(null))))")

    def key(self, key: str, *, shift: bool = False) -> None:
        """Press a key and let it go."""
        text = {"text": key} if len(key) == 1 else {}
        code = {"key": key, "code": "Space" if key == " " else key, "modifiers": 8 if shift else 0}
        self.call("Input.dispatchKeyEvent", type="keyDown", **code, **text)
        self.call("Input.dispatchKeyEvent", type="keyUp", **code)
        self.frames()

    def drag(self, start: Sequence[float], end: Sequence[float]) -> None:
        """Drag with the left button between two places in CSS pixels."""
        for kind, (x, y) in (("mousePressed", start), ("mouseMoved", end), ("mouseReleased", end)):
            held = {"button": "left", "buttons": 0 if kind == "mouseReleased" else 1, "clickCount": 1}
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **held)
        self.frames()

    def picture(self) -> NDArray[np.uint8]:
        """Return what the window shows ``(rows, columns, 3)``."""
        return decoded(self.call("Page.captureScreenshot", format="png")["data"])

    def canvas(self, name: str) -> NDArray[np.uint8]:
        """Return a canvas of the player ``(rows, columns, 3)``."""
        return decoded(self.run(f"document.getElementById('player-{name}').toDataURL().split(',')[1]"))


def decoded(text: str) -> NDArray[np.uint8]:
    """Return the picture in a base64 text."""
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(text))).convert("RGB"))


@contextmanager
def browser(folder: Path, flags: Sequence[str] = SOFTWARE) -> Iterator[Browser]:
    """Run the browser with its profile in ``folder``; it ends with the block."""
    to_read, to_write = os.pipe()
    from_read, from_write = os.pipe()
    command = ["chromium", "--headless", "--no-sandbox", "--remote-debugging-pipe", f"--user-data-dir={folder}", *flags]
    command += ["--no-first-run", "--hide-scrollbars", "--force-device-scale-factor=1", "about:blank"]
    # The pipe is the browser's 3, which it reads, and 4.
    shell = ["bash", "-c", f'exec "$@" 3<&{to_read} 4>&{from_write}', "bash", *command]
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    running = subprocess.Popen(shell, pass_fds=(to_read, from_write), **quiet)
    os.close(to_read)
    os.close(from_write)
    try:
        yield Browser(to_write, from_read)
    finally:
        running.terminate()
        running.wait(timeout=20)
        os.close(to_write)
        os.close(from_read)
