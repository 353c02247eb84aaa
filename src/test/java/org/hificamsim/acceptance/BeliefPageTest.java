package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what pages show of cooperative cameras: beliefs, messages, and reasons for choices. */
class BeliefPageTest {
  private static final String PIXELS =
      "const {canvas} = (hificamsim.player ?? hificamsim.players[0]).field.surface;"
          + "return canvas.toDataURL()";

  @TempDir static Path folder;
  private static Browser browser;

  @BeforeAll
  static void start() {
    browser = Browser.shared();
  }

  private static void open(String... channel) {
    Path out = folder.resolve("run" + channel.length);
    List<Object> words = new ArrayList<>(List.of("run", Cli.scenario("corridor"), "--record"));
    words.addAll(List.of("--policy", "cooperative:cells=200", "--steps", 40));
    words.addAll(List.of("--out", out));
    words.addAll(List.of(channel));
    Cli cli = Cli.run(words.toArray());
    assertEquals(0, cli.exit(), cli.err());
    browser.open(out.resolve("report.html").toUri() + "#20");
  }

  @Test
  void showsGainsAndReceiversOfTheChosenCamera() {
    open();
    String note = browser.text(".agent .note");
    Matcher best =
        Pattern.compile("Largest: level \\d, \\S+: (\\S+); level \\d, \\S+: (\\S+); level .*")
            .matcher(note.replaceFirst(".*(?=Largest)", ""));
    assertTrue(best.matches(), note);
    assertTrue(Double.parseDouble(best.group(1)) >= Double.parseDouble(best.group(2)), note);
    assertTrue(note.contains("sent what it saw in one message, and what it chose in"), note);
    assertTrue(note.contains("all others received it"), note);
    Object without = browser.run(PIXELS);
    browser.find("[name=beliefs]").sendKeys(" ");
    Object shown = browser.run(PIXELS);
    assertNotEquals(without, shown);
    browser.run("const {belief} = hificamsim.run; belief[20] = belief[20].slice(0, 412)");
    browser.run("hificamsim.player.field.surface.draw()");
    assertNotEquals(shown, browser.run(PIXELS), "arrows");
    browser.assertQuietConsole();
  }

  @Test
  void showsNoReceiverOfLostMessages() {
    open("--channel", "loss=1");
    String note = browser.text(".agent .note");
    assertTrue(note.contains("sent what it saw in one message"), note);
    assertTrue(note.contains("; nobody received it"), note);
  }

  @Test
  void liveViewShowsReceiversAndOffersBeliefs() {
    try (ViewProcess view = new ViewProcess(Cli.scenario("corridor"), "--policy", "cooperative")) {
      browser.open(view.address());
      browser.until("return hificamsim.runs[0].count > 3");
      browser.until(
          "return document.querySelector('.agent .note').textContent.includes('all others"
              + " received it')");
      assertFalse(
          (boolean)
              browser.run("return document.querySelector('[name=beliefs]').offsetParent === null"));
      browser.leave();
    }
  }
}
