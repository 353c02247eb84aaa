package org.hificamsim.core.scenario.xml;

import java.util.Map;
import java.util.function.Consumer;

/** Writes an XML document with one element on each line. */
public final class XmlWriter {
  private final StringBuilder out = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>");
  private int depth;

  /** Writes an element that contains others. */
  public void element(String name, Map<String, String> attributes, Runnable content) {
    tag(name, attributes, ">");
    depth++;
    content.run();
    depth--;
    indent();
    end(name);
  }

  /** Writes an element without content. */
  public void element(String name, Map<String, String> attributes) {
    tag(name, attributes, "/>");
  }

  /** Writes an element with a text that needs no escapes. */
  public void text(String name, String text) {
    tag(name, Map.of(), ">");
    out.append(text);
    end(name);
  }

  /** Writes an element with lines that need no escapes. */
  public void lines(String name, Consumer<Appendable> lines) {
    tag(name, Map.of(), ">");
    out.append('\n');
    lines.accept(out);
    out.append("  ".repeat(depth));
    end(name);
  }

  /** The finished document. */
  public String document() {
    return out + "\n";
  }

  private void tag(String name, Map<String, String> attributes, String end) {
    indent();
    out.append('<').append(name);
    attributes.forEach(
        (key, value) ->
            out.append(' ').append(key).append("=\"").append(escaped(value)).append('"'));
    out.append(end);
  }

  private void indent() {
    out.append('\n').append("  ".repeat(depth));
  }

  private void end(String name) {
    out.append("</").append(name).append('>');
  }

  /** Escapes a value between double quotes; unescaped tabs and line ends would become spaces. */
  private static String escaped(String value) {
    return value
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;")
        .replace("\t", "&#9;")
        .replace("\n", "&#10;")
        .replace("\r", "&#13;");
  }
}
