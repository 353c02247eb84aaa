package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.WebElement;

/** Tests the page of the leaderboard in a browser. */
class LeaderboardPageTest {
  @TempDir Path folder;

  @Test
  void pageDrawsTasksOfLeaderboardAsBars() {
    Path entry = folder.resolve("entry");
    Path out = folder.resolve("board");
    run("benchmark", "run", "--policy", "zoom-out", "--tasks", "passage-v1", "--out", entry);
    run("benchmark", "leaderboard", entry, "--out", out);
    Browser browser = Browser.shared();
    browser.open(out.resolve("leaderboard.html").toUri().toString());
    assertEquals(1, browser.findAll(".bars .score").size());
    assertFalse(browser.findAll(".bars .none").isEmpty());
    browser.find("summary").click();
    browser.until("return document.querySelector('.sortable th button') !== null");
    List<String> heads =
        browser.findAll(".sortable th button").stream().map(WebElement::getText).toList();
    assertEquals(3, heads.size(), heads.toString());
    Accessibility.checkEverywhere(browser);
  }

  private static void run(Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(0, cli.exit(), cli.err());
  }
}
