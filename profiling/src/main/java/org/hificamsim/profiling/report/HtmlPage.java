package org.hificamsim.profiling.report;

import java.util.Base64;
import java.util.List;
import org.hificamsim.profiling.dataset.TableLayout;

/** A page of headings, paragraphs, tables and pictures; every text is escaped. */
final class HtmlPage {
  private static final String STYLE =
      """
:root { --ink: #222; --faint: #555; --paper: #fff; --line: #ccd; --head: #f3f4f6; --link: #0067a3; color-scheme: light dark }
@media (prefers-color-scheme: dark) { :root { --ink: #e8edf2; --faint: #a3b0bd; --paper: #10161c; --line: #34404c; --head: #1d2731; --link: #8ab4ff } }
body { font: 16px/1.5 sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: var(--ink); background: var(--paper); overflow-wrap: break-word }
a { color: var(--link) }
.table { overflow-x: auto; margin: 1rem 0 } td { white-space: nowrap } td:last-child { white-space: normal; min-width: 8rem }
table { border-collapse: collapse; font-size: 0.9rem }
th, td { border-bottom: 1px solid var(--line); padding: 0.25rem 0.7rem; text-align: right }
th { border-bottom: 2px solid var(--faint); background: var(--head) }
td:first-child, th:first-child, .text { text-align: left }
@media (max-width: 600px) { body { padding: 0 0.7rem } table { font-size: 0.8rem } th, td { padding: 0.2rem 0.3rem } td.text { white-space: normal; min-width: 5rem } td:last-child { min-width: 0 } }
figure { margin: 1.5rem 0; overflow-x: auto } figcaption { color: var(--faint); font-size: 0.9rem }
img { max-width: 100%; background: #fff }
@media (prefers-color-scheme: dark) { img { filter: invert(0.9) hue-rotate(180deg) } }
""";

  private final StringBuilder contents = new StringBuilder();
  private final StringBuilder body = new StringBuilder();
  private final String title;
  private int headings;

  HtmlPage(String title) {
    this.title = title;
  }

  /** Adds a heading, which the contents at the top of the page link to. */
  void heading(String text) {
    String id = "part-" + ++headings;
    contents
        .append("<li><a href=\"#")
        .append(id)
        .append("\">")
        .append(escaped(text))
        .append("</a></li>\n");
    body.append("<h2 id=\"").append(id).append("\">").append(escaped(text)).append("</h2>\n");
  }

  /** Adds a paragraph of plain text. */
  void paragraph(String text) {
    body.append("<p>").append(escaped(text)).append("</p>\n");
  }

  /** Adds a table with a header. */
  <R> void table(TableLayout<R> layout, List<R> rows) {
    body.append("<div class=\"table\" tabindex=\"0\"><table>\n");
    List<String> names = layout.names();
    List<List<String>> cells = rows.stream().map(layout::cells).toList();
    boolean[] texts = new boolean[names.size()];
    cells.forEach(row -> markTexts(row, texts));
    row("th", names, texts);
    cells.forEach(row -> row("td", row, texts));
    body.append("</table></div>\n");
  }

  /** Adds a picture, embedded so that the page is one file. */
  void figure(byte[] png, String caption) {
    body.append("<figure><img src=\"data:image/png;base64,")
        .append(Base64.getEncoder().encodeToString(png))
        .append("\" alt=\"")
        .append(escaped(caption))
        .append("\"><figcaption>")
        .append(escaped(caption))
        .append("</figcaption></figure>\n");
  }

  /** Returns the page as HTML. */
  String text() {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        + "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>"
        + escaped(title)
        + "</title>\n<style>\n"
        + STYLE
        + "</style></head><body><main>\n<h1>"
        + escaped(title)
        + "</h1>\n<nav aria-label=\"Contents\"><ul>\n"
        + contents
        + "</ul></nav>\n"
        + body
        + "</main></body></html>\n";
  }

  /** Marks the columns in which a row has words, as opposed to numbers. */
  private static void markTexts(List<String> row, boolean[] texts) {
    for (int column = 0; column < texts.length; column++) {
      texts[column] |=
          row.get(column).codePoints().findFirst().stream().anyMatch(Character::isLetter);
    }
  }

  private void row(String tag, List<String> cells, boolean[] texts) {
    body.append("<tr>");
    for (int column = 0; column < texts.length; column++) {
      body.append('<').append(tag).append(texts[column] ? " class=\"text\">" : ">");
      body.append(escaped(cells.get(column))).append("</").append(tag).append('>');
    }
    body.append("</tr>\n");
  }

  private static String escaped(String text) {
    return text.replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
