package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/** What WCAG 2.2 asks of a page, as far as a script can tell. */
final class Accessibility {
  /** Texts with less contrast than 4.5, or 3 where they are large: success criterion 1.4.3. */
  private static final String PALE =
      """
const numbers = colour => (colour.match(/[\\d.]+/g) ?? []).map(Number);
const over = ([r, g, b, a = 1], below) => [r, g, b].map((c, i) => a * c + (1 - a) * below[i]);
const ground = element => element ? over(numbers(getComputedStyle(element).backgroundColor),
    (numbers(getComputedStyle(element).backgroundColor)[3] ?? 1) < 1 ? ground(element.parentElement) : [0, 0, 0])
    : [255, 255, 255];
const linear = c => c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4;
const light = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
const ratio = (a, b) => (Math.max(light(a), light(b)) + 0.05) / (Math.min(light(a), light(b)) + 0.05);
const found = [];
for (const element of document.querySelectorAll('body *')) {
  const text = [...element.childNodes].filter(node => node.nodeType === 3).map(node => node.data.trim()).join('');
  const {color, fontSize, fontWeight} = getComputedStyle(element);
  if (!text || !element.checkVisibility()) continue;
  const size = parseFloat(fontSize);
  const least = size >= 24 || (size >= 18.66 && Number(fontWeight) >= 700) ? 3 : 4.5;
  const contrast = ratio(over(numbers(color), ground(element)), ground(element));
  if (contrast < least) found.push(`${contrast.toFixed(2)}: ${text.slice(0, 40)}`);
}
return found;
""";

  private static final String EMPTY_HEADS =
      """
return [...document.querySelectorAll('th')].filter(head => !head.textContent.trim())
    .map(head => head.closest('table').textContent.slice(0, 60));
""";

  private static final String NAMELESS =
      """
return [...document.querySelectorAll('button, select, input, a, canvas[role], [role=img], [role=group]')]
    .filter(one => one.checkVisibility() && !(one.ariaLabel || one.title || one.textContent.trim() || one.labels?.length))
    .map(one => one.outerHTML.slice(0, 100));
""";

  private Accessibility() {}

  /**
   * Fails if the page in the browser has pale texts, heads of tables without text, or nameless
   * controls.
   */
  static void check(Browser browser) {
    assertEquals(List.of(), browser.run(PALE), "contrast");
    assertEquals(List.of(), browser.run(EMPTY_HEADS), "tables with an empty head");
    assertEquals(List.of(), browser.run(NAMELESS), "controls without a name");
  }

  /** Takes pictures at three widths, to be looked at, and checks what a script can. */
  static void lookAt(Browser browser, String name) throws IOException {
    Path pictures = Files.createDirectories(Cli.ROOT.resolve("build/screenshots"));
    for (Map.Entry<Integer, Integer> size : Map.of(400, 2400, 1280, 1000, 3840, 2000).entrySet()) {
      browser.size(size.getKey(), size.getValue());
      browser.run("return new Promise(done => setTimeout(done, 300))");
      browser.screenshot(pictures.resolve(name + "-" + size.getKey() + ".png"));
    }
    browser.size(1280, 1000);
    check(browser);
    assertNothingSticksOut(browser, 400);
    assertNothingSticksOut(browser, 3840);
  }

  /**
   * Fails if a page of this width scrolls sideways, or a part of its controls leaves their card.
   */
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
