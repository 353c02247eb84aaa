package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Checks pages against WCAG 2.2, as far as a script can. */
final class Accessibility {
  private static final String AXE = text("/axe.min.js");

  /**
   * The script that returns the serious and critical findings of axe-core: the rule and its first
   * place.
   */
  private static final String SERIOUS =
      """
const done = arguments[0];
axe.run(document, {resultTypes: ['violations']}).then(({violations}) => done(violations
    .filter(({impact, id}) => impact === 'serious' || impact === 'critical' || id === 'empty-table-header')
    .map(({id, nodes}) => `${id}: ${nodes[0].html.slice(0, 120)}: ${nodes[0].failureSummary}`)));
""";

  private Accessibility() {}

  private static String text(String resource) {
    try (InputStream in = Accessibility.class.getResourceAsStream(resource)) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Fails if axe-core finds anything serious on the page in the browser. */
  static void check(Browser browser) {
    browser.run(AXE);
    assertEquals(List.of(), browser.runAsync(SERIOUS));
  }

  /** Checks a page on a dark phone and a light screen; nothing may stick out. */
  static void checkEverywhere(Browser browser) {
    for (int width : new int[] {400, 1400}) {
      browser.dark(width == 400);
      browser.size(width, 1000);
      check(browser);
      assertNothingSticksOut(browser, width);
    }
    browser.dark(false);
  }

  /** Checks a page on a usual screen; nothing may stick out on a phone or a very wide screen. */
  static void checkWidths(Browser browser) {
    check(browser);
    assertNothingSticksOut(browser, 400);
    assertNothingSticksOut(browser, 3840);
  }

  /** Fails if a page of this width scrolls sideways, or some controls are outside their card. */
  static void assertNothingSticksOut(Browser browser, int width) {
    browser.size(width, 800);
    assertEquals(true, browser.run("return document.documentElement.scrollWidth <= innerWidth"));
    assertEquals(
        List.of(),
        browser.run(
            """
return [...document.querySelectorAll('.controls, .choice, .pose')].flatMap(card => {
  const {right} = card.getBoundingClientRect();
  return [...card.querySelectorAll('*')].filter(part => part.getBoundingClientRect().right > right + 0.5)
      .map(part => part.outerHTML.slice(0, 80));
});
"""));
    browser.size(1280, 1000);
  }
}
