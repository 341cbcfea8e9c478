"""Debian's Chromium without a window, for tests, benchmarks and pictures of the page of keiko view."""
import os
import shutil
import sys

SYSTEM_PYTHON = "/usr/bin/python3"
try:
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
except ImportError:
    # The package belongs to the system's interpreter.
    if os.path.exists(SYSTEM_PYTHON) and not os.path.samefile(SYSTEM_PYTHON, sys.executable):
        os.execv(SYSTEM_PYTHON, [SYSTEM_PYTHON, "-B", *sys.argv])
    webdriver = None


def is_there() -> bool:
    """True if chromium, chromium-driver and python3-selenium are installed."""
    return bool(webdriver and shutil.which("chromium") and shutil.which("chromedriver"))


def browser(profile: str, downloads: str, size: str = "1400,900"):
    """A browser with a profile and a folder for downloads of its own, and a window of a size in pixels."""
    options = webdriver.ChromeOptions()
    for flag in ("--headless=new", "--disable-gpu", "--disable-dev-shm-usage", f"--window-size={size}",
                 f"--user-data-dir={profile}"):
        options.add_argument(flag)
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    options.binary_location = shutil.which("chromium")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    options.add_experimental_option("prefs", {"download.default_directory": downloads})
    return webdriver.Chrome(service=Service(shutil.which("chromedriver")), options=options)
