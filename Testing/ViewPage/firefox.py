# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Firefox without a window, driven by Marionette, its own protocol: no driver is needed."""

import base64
import json
import pathlib
import shutil
import socket
import subprocess
import tempfile

import needed
from browser import PATIENCE, Browser

_SETTINGS = """\
user_pref("marionette.port", 0);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("app.update.enabled", false);
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("layout.css.devPixelsPerPx", "1.0");
"""


class Firefox(Browser):
    """Firefox, in a profile of its own."""

    def __init__(self, size=(1000, 1000)):
        program = needed.program("firefox-esr", "firefox", package="firefox-esr")
        self.profile = pathlib.Path(tempfile.mkdtemp())
        (self.profile / "user.js").write_text(_SETTINGS)
        self.process = subprocess.Popen(
            [program, "--headless", "--marionette", "--no-remote", "--profile", str(self.profile),
             f"--width={size[0]}", f"--height={size[1]}"],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.socket = None
        self.number = 0
        port = self.profile / "MarionetteActivePort"
        self.wait_until(lambda: self.process.poll() is not None or port.exists() and port.read_text().strip(),
                        "Firefox listens")
        if self.process.poll() is not None:
            shutil.rmtree(self.profile, ignore_errors=True)
            needed.skip("Firefox does not start here.")
        self.socket = socket.create_connection(("127.0.0.1", int(port.read_text())), PATIENCE)
        self.receive()
        self.command("WebDriver:NewSession", capabilities={"alwaysMatch": {}})

    def quit(self):
        self.command("Marionette:Quit", flags=["eForceQuit"])
        self.socket.close()
        self.process.wait(PATIENCE)
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self):
        """The next message: its length in digits, a colon, JSON."""
        length = b""
        while not length.endswith(b":"):
            length += self.receive_bytes(1)
        message = bytearray()
        while len(message) < int(length[:-1]):
            message += self.receive_bytes(int(length[:-1]) - len(message))
        return json.loads(message)

    def receive_bytes(self, most):
        """One byte or more."""
        received = self.socket.recv(most)
        if not received:
            raise AssertionError("Firefox has gone.")
        return received

    def command(self, name, **arguments):
        """What a command of Marionette returns."""
        self.number += 1
        message = json.dumps([0, self.number, name, arguments]).encode()
        self.socket.sendall(b"%d:%s" % (len(message), message))
        _, number, error, result = self.receive()
        if error or number != self.number:
            raise AssertionError(f"{name}: {error}")
        return result["value"] if isinstance(result, dict) and "value" in result else result

    def go_to(self, address):
        self.command("WebDriver:Navigate", url=address)

    def run(self, script, *arguments):
        return self.command("WebDriver:ExecuteScript", script=script, args=arguments, sandbox=None)

    def wait_for_call(self, script):
        return self.command("WebDriver:ExecuteAsyncScript", script=script, args=[], sandbox=None)

    def perform(self, actions):
        self.command("WebDriver:PerformActions", actions=[actions])

    def screenshot(self):
        """A PNG of the window."""
        return base64.b64decode(self.command("WebDriver:TakeScreenshot", full=False))
