package org.hificamsim.profiling.report;

import java.util.Base64;
import java.util.List;
import org.hificamsim.profiling.dataset.TableLayout;

/** A page of headings, paragraphs, tables and pictures; every text is escaped. */
final class HtmlPage {
  private static final String STYLE =
      """
body { font: 16px/1.5 sans-serif; max-width: 70rem; margin: 2rem auto; padding: 0 1rem; color: #222 }
table { border-collapse: collapse; margin: 1rem 0; font-size: 0.9rem }
th, td { border-bottom: 1px solid #ddd; padding: 0.25rem 0.7rem; text-align: right }
th { border-bottom: 2px solid #888; background: #f6f6f6 }
td:first-child, th:first-child { text-align: left }
figure { margin: 1.5rem 0 } figcaption { color: #555; font-size: 0.9rem }
img { max-width: 100%; border: 1px solid #eee }
""";

  private final StringBuilder body = new StringBuilder();
  private final String title;

  HtmlPage(String title) {
    this.title = title;
    body.append("<h1>").append(escaped(title)).append("</h1>\n");
  }

  void heading(String text) {
    body.append("<h2>").append(escaped(text)).append("</h2>\n");
  }

  void paragraph(String text) {
    body.append("<p>").append(escaped(text)).append("</p>\n");
  }

  <R> void table(TableLayout<R> layout, List<R> rows) {
    body.append("<table>\n");
    row("th", layout.names());
    rows.forEach(row -> row("td", layout.cells(row)));
    body.append("</table>\n");
  }

  /** Adds a picture that is embedded, so that the page is one file. */
  void figure(byte[] png, String caption) {
    body.append("<figure><img src=\"data:image/png;base64,")
        .append(Base64.getEncoder().encodeToString(png))
        .append("\" alt=\"")
        .append(escaped(caption))
        .append("\"><figcaption>")
        .append(escaped(caption))
        .append("</figcaption></figure>\n");
  }

  String text() {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>"
        + escaped(title)
        + "</title>\n<style>\n"
        + STYLE
        + "</style></head><body>\n"
        + body
        + "</body></html>\n";
  }

  private void row(String tag, List<String> cells) {
    body.append("<tr>");
    for (String cell : cells) {
      body.append('<').append(tag).append('>');
      body.append(escaped(cell)).append("</").append(tag).append('>');
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
