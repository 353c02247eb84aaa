package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import java.util.logging.Logger;
import java.util.stream.StreamSupport;
import org.openqa.selenium.By;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.interactions.Actions;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;
import org.openqa.selenium.support.ui.WebDriverWait;

/**
 * Debian's Chromium without a window, with the logs of its console and of its network requests. All
 * tests share one, which ends with this process.
 */
final class Browser {
  private static final Path CHROMIUM = Path.of("/usr/bin/chromium");
  private static final Path DRIVER = Path.of("/usr/bin/chromedriver");
  private static final Logger SELENIUM = Logger.getLogger("org.openqa.selenium");
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final Duration MAX_WAIT = Duration.ofSeconds(30);
  private static final Duration MAX_SCRIPT = Duration.ofMinutes(2); // axe-core on a busy machine

  /** Whether the page's script has ended and everything has been drawn. */
  private static final String DRAWN =
      """
const {player, players = player ? [player] : []} = window.hificamsim ?? {};
const page = document.getElementById('page'); // none in the documentation
return (page ? page.dataset.ready !== undefined : document.readyState === 'complete')
    && players.every(player => player.field.map)
    && [...document.querySelectorAll('.plot, .lines')].every(
        box => !box.offsetParent || box.querySelector('canvas')); // none in what is hidden
""";

  private static Browser shared;

  private final ChromeDriver driver;

  private Browser(Path profile) {
    SELENIUM.setLevel(
        Level.SEVERE); // it does not know the DevTools of this Chromium, which are not used
    LoggingPreferences logs = new LoggingPreferences();
    logs.enable(LogType.BROWSER, Level.ALL);
    logs.enable(LogType.PERFORMANCE, Level.ALL);
    ChromeOptions options = new ChromeOptions();
    options.setBinary(CHROMIUM.toFile());
    options.addArguments(
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--disable-quic",
        "--no-first-run",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-sync",
        "--user-data-dir=" + profile);
    options.setCapability("goog:loggingPrefs", logs);
    ChromeDriverService service =
        new ChromeDriverService.Builder().usingDriverExecutable(DRIVER.toFile()).build();
    driver = new ChromeDriver(service, options);
    driver.manage().timeouts().scriptTimeout(MAX_SCRIPT);
  }

  /** Starts a browser with a new profile, unless one runs; skips the test without a browser. */
  static synchronized Browser shared() {
    assumeTrue(
        Files.isExecutable(CHROMIUM) && Files.isExecutable(DRIVER),
        "no Chromium: apt-get install chromium chromium-driver");
    if (shared == null) {
      shared = Results.untilTheEnd("profile", Browser::new, browser -> browser.driver.quit());
    }
    shared.size(1280, 1000);
    return shared;
  }

  /** Opens an address with empty logs, and waits until the page has been drawn. */
  void open(String address) {
    driver.get("about:blank");
    driver.manage().logs().get(LogType.BROWSER);
    driver.manage().logs().get(LogType.PERFORMANCE);
    driver.get(address);
    until(DRAWN);
  }

  /** Sets the size of the page, in CSS pixels. */
  void size(int width, int height) {
    driver.executeCdpCommand(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", false));
  }

  /** Saves files that the page offers in this folder. */
  void downloadTo(Path folder) {
    driver.executeCdpCommand(
        "Browser.setDownloadBehavior",
        Map.of("behavior", "allow", "downloadPath", folder.toAbsolutePath().toString()));
  }

  /** Runs a script, and returns its result. */
  Object run(String script, Object... arguments) {
    return driver.executeScript(script, arguments);
  }

  /** Runs a script, and returns what it passes to its last argument, a function. */
  Object runAsync(String script) {
    return driver.executeAsyncScript(script);
  }

  /** Sets whether pages are dark. */
  void dark(boolean dark) {
    driver.executeCdpCommand(
        "Emulation.setEmulatedMedia",
        Map.of(
            "features",
            List.of(Map.of("name", "prefers-color-scheme", "value", dark ? "dark" : "light"))));
  }

  /** Waits until a script returns true. */
  void until(String script) {
    new WebDriverWait(driver, MAX_WAIT, Duration.ofMillis(50))
        .withMessage(script)
        .until(driver -> Boolean.TRUE.equals(run(script)));
  }

  WebElement find(String selector) {
    return driver.findElement(By.cssSelector(selector));
  }

  List<WebElement> findAll(String selector) {
    return driver.findElements(By.cssSelector(selector));
  }

  /** Returns the text of the only element that a selector finds. */
  String text(String selector) {
    return find(selector).getText();
  }

  /** Presses keys on the focused element. */
  void press(CharSequence... keys) {
    driver.switchTo().activeElement().sendKeys(keys);
  }

  /** Leaves the page. */
  void leave() {
    follow("about:blank");
  }

  /** Opens an address that redirects to another one, without waiting. */
  void follow(String address) {
    driver.get(address);
  }

  /** Clears the log of the console. */
  void forgetConsole() {
    driver.manage().logs().get(LogType.BROWSER);
  }

  /** Actions of the mouse. */
  Actions actions() {
    return new Actions(driver);
  }

  /** Saves a picture of the visible page. */
  void screenshot(Path png) {
    try {
      Files.write(png, driver.getScreenshotAs(OutputType.BYTES));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Fails if the console has warnings or errors since {@link #open}. */
  void assertQuietConsole() {
    List<String> lines = new ArrayList<>();
    for (LogEntry entry : driver.manage().logs().get(LogType.BROWSER)) {
      lines.add(entry.toString());
    }
    assertEquals(List.of(), lines);
  }

  /** Returns the addresses requested since {@link #open}, in order, without data of the page. */
  List<String> requests() {
    return StreamSupport.stream(
            driver.manage().logs().get(LogType.PERFORMANCE).spliterator(), false)
        .map(entry -> message(entry.getMessage()))
        .filter(message -> message.path("method").asText().equals("Network.requestWillBeSent"))
        .map(message -> message.path("params").path("request").path("url").asText())
        .filter(url -> !url.startsWith("data:") && !url.startsWith("blob:"))
        .toList();
  }

  private static JsonNode message(String text) {
    try {
      return JSON.readTree(text).path("message");
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
