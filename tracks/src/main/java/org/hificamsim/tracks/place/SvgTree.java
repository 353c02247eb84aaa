package org.hificamsim.tracks.place;

import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/**
 * Reads the elements and style sheets of an SVG. Nothing that the file names is opened: no entity,
 * style sheet, picture, font or script.
 */
final class SvgTree extends PlainXml {
  private static final int MAX_DEPTH = 200;
  private static final int MAX_ELEMENTS = 2_000_000;

  private final Map<String, SvgNode> byId = new HashMap<>();
  private final CssRules rules = new CssRules();
  private final Deque<SvgNode> open = new ArrayDeque<>();
  private final StringBuilder css = new StringBuilder();
  private SvgNode root;
  private String prefix = "";
  private int elements;
  private int foreignDepth;

  static SvgTree read(Path file) {
    DocumentType.requireEnd(file);
    SvgTree tree = new SvgTree();
    tree.readFile(file);
    return tree;
  }

  SvgNode root() {
    return root;
  }

  /** The element with an id; null if there is none. */
  SvgNode find(String id) {
    return byId.get(id);
  }

  /** The rules of all style sheets. */
  CssRules rules() {
    return rules;
  }

  @Override
  protected boolean allowsDocumentType() {
    return true;
  }

  @Override
  public void startElement(String uri, String local, String qualified, Attributes attributes) {
    int colon = qualified.indexOf(':');
    String name = qualified.substring(colon + 1);
    if (root == null) {
      prefix = qualified.substring(0, colon + 1);
      if (!name.equals("svg")) {
        throw place().error("the drawing is a <" + Place.shortened(name) + ">, expected an <svg>");
      }
    }
    if (foreignDepth > 0 || !qualified.equals(prefix + name)) {
      foreignDepth++; // an element of another language, such as an editor's settings
      return;
    }
    if (++elements > MAX_ELEMENTS || open.size() >= MAX_DEPTH) {
      throw place()
          .error(
              "the drawing is too large, expected at most %s elements, %s in each other",
              MAX_ELEMENTS, MAX_DEPTH);
    }
    SvgNode node = new SvgNode(name, texts(attributes), open.peek(), place());
    root = root == null ? node : root;
    open.push(node);
    if (node.has("id")) {
      byId.putIfAbsent(node.text("id"), node);
    }
  }

  /** Returns attributes by name; those of other languages keep their prefix, except a link's. */
  private static Map<String, String> texts(Attributes attributes) {
    Map<String, String> texts = new HashMap<>();
    for (int i = 0; i < attributes.getLength(); i++) {
      String name = attributes.getQName(i);
      boolean isLink = name.endsWith(":href");
      if (isLink) {
        texts.putIfAbsent("href", attributes.getValue(i));
      } else {
        texts.put(name, attributes.getValue(i));
      }
    }
    return texts;
  }

  @Override
  public void characters(char[] text, int start, int length) {
    if (foreignDepth == 0 && !open.isEmpty() && open.peek().name().equals("style")) {
      css.append(text, start, length);
    }
  }

  @Override
  public void endElement(String uri, String local, String qualified) {
    if (foreignDepth > 0) {
      foreignDepth--;
      return;
    }
    if (open.pop().name().equals("style")) {
      rules.add(css.toString());
      css.setLength(0);
    }
  }
}
