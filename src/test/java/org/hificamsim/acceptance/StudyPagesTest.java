package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.openqa.selenium.By;
import org.openqa.selenium.WebElement;

/** The pages of a study of CamSim's network and of the leaderboard in a browser. */
class StudyPagesTest {
  @TempDir Path folder;

  @Test
  void namesStrategiesOnFrontAndMergesEqualFronts() throws IOException {
    Path out = folder.resolve("tradeoff");
    run(
        "tradeoff",
        Cli.scenario("tutorial-camsim"),
        "--heterogeneous",
        "sample:15",
        "--bandits",
        "UCB1",
        "--steps",
        60,
        "--repeat",
        3,
        "--out",
        out);
    Browser browser = Browser.shared();
    browser.open(out.resolve("report.html").toUri().toString());
    List<String> fronts = Files.readAllLines(out.resolve("fronts.csv"));
    String first = fronts.get(1).substring(fronts.get(1).lastIndexOf(',') + 1).split(" ")[0];
    assertTrue(browser.text(".front-name").contains(first), browser.text(".front-name"));
    long different =
        fronts.stream().skip(1).map(row -> row.substring(row.lastIndexOf(','))).distinct().count();
    assertEquals(different, browser.findAll(".sortable").get(0).findElements(tag("tr")).size() - 1);
    Accessibility.checkEverywhere(browser);
  }

  @Test
  void drawsTasksOfLeaderboardAsBars() {
    Path entry = folder.resolve("entry");
    Path out = folder.resolve("board");
    run("benchmark", "run", "--policy", "zoom-out", "--tasks", "passage-v1", "--out", entry);
    run("benchmark", "leaderboard", entry, "--out", out);
    Browser browser = Browser.shared();
    browser.open(out.resolve("leaderboard.html").toUri().toString());
    assertEquals(1, browser.findAll(".bars .score").size());
    assertFalse(browser.findAll(".bars .none").isEmpty());
    browser.find("summary").click();
    List<String> heads =
        browser.findAll(".sortable th button").stream().map(WebElement::getText).toList();
    assertEquals(3, heads.size(), heads.toString());
    Accessibility.checkEverywhere(browser);
  }

  private static By tag(String name) {
    return By.tagName(name);
  }

  private static void run(Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(0, cli.exit(), cli.err());
  }
}
