# SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a window, driven by Selenium."""

import base64
import json

import needed
from browser import Browser

try:
    from selenium import webdriver
    from selenium.common.exceptions import SessionNotCreatedException
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
except ImportError as error:
    needed.skip(f"there is no Selenium here (Debian: python3-selenium): {error}")

#: What a page throws is kept from the beginning.
_LISTEN = """
globalThis.thrown = [];
addEventListener("error", (event) => thrown.push(String(event.message)));
addEventListener("unhandledrejection", (event) => thrown.push(String(event.reason)));
addEventListener("securitypolicyviolation", (event) => thrown.push(`forbidden: ${event.blockedURI}`));
"""


class Chromium(Browser):
    """Chromium, and chromedriver."""

    def __init__(self, downloads=None, size=(1000, 1000), arguments=()):
        options = Options()
        options.binary_location = needed.program("chromium", "google-chrome", package="chromium")
        for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage",
                         "--force-device-scale-factor=1", "--force-color-profile=srgb", "--no-first-run",
                         f"--window-size={size[0]},{size[1]}", *arguments):
            options.add_argument(argument)
        options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
        if downloads:
            options.add_experimental_option("prefs", {
                "download.default_directory": str(downloads), "download.prompt_for_download": False})
        driver = needed.program("chromedriver", package="chromium-driver")
        try:
            self.driver = webdriver.Chrome(service=Service(driver), options=options)
        except SessionNotCreatedException as error:
            needed.skip(f"Chromium does not start here: {error.msg.splitlines()[0]}")
        self.driver.set_script_timeout(600)
        self.before_scripts(_LISTEN)

    def quit(self):
        self.driver.quit()

    def devtools(self, command, **arguments):
        """A command of Chrome's DevTools."""
        return self.driver.execute_cdp_cmd(command, arguments)

    def before_scripts(self, script):
        """Run a script in each page before its own; returns what drop_script() takes."""
        return self.devtools("Page.addScriptToEvaluateOnNewDocument", source=script)["identifier"]

    def drop_script(self, identifier):
        self.devtools("Page.removeScriptToEvaluateOnNewDocument", identifier=identifier)

    def go_to(self, address):
        self.complaints()
        self.driver.get(address)

    def run(self, script, *arguments):
        return self.driver.execute_script(script, *arguments)

    def wait_for_call(self, script):
        return self.driver.execute_async_script(script)

    def perform(self, actions):
        self.driver.execute("actions", {"actions": [actions]})

    def screenshot(self):
        """A PNG of the window."""
        return base64.b64decode(self.devtools("Page.captureScreenshot", format="png")["data"])

    def complaints(self):
        """What the console got and the page threw, since the page was opened or this was asked."""
        said = [f"{entry['level']}: {entry['message']}" for entry in self.driver.get_log("browser")]
        return said + (self.run("const all = globalThis.thrown ?? []; globalThis.thrown = []; return all;") or [])

    def requests(self):
        """The addresses that were asked for since the last call, but for data in the page itself."""
        messages = [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]
        addresses = [message["params"]["request"]["url"] for message in messages
                     if message["method"] == "Network.requestWillBeSent"]
        return [address for address in addresses if not address.startswith(("data:", "blob:"))]

    def set_window(self, width, height, scale=1.0, is_mobile=False):
        """The size of the page's part of the window; small ones, too."""
        self.devtools("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=scale,
                      mobile=is_mobile)
        self.devtools("Emulation.setTouchEmulationEnabled", enabled=is_mobile)

    def reset_window(self):
        self.devtools("Emulation.clearDeviceMetricsOverride")
        self.devtools("Emulation.setTouchEmulationEnabled", enabled=False)

    def set_scheme(self, scheme):
        """ "dark", "light", or "": that of the system."""
        self.devtools("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
