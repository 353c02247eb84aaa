package org.hificamsim.tracks.place;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;

/** The rules of style sheets, as in CSS 2.1; unknown rules are skipped, as CSS demands. */
final class CssRules {
  private static final Pattern DRAWN_MEDIA =
      Pattern.compile("@media\\b(?!.*\\bprint\\b)(?!.*\\bnot\\b)(?!.*\\().*", Pattern.DOTALL);
  private static final String IMPORTANT = "!important";

  /**
   * A selector with its declarations.
   *
   * @param order position of the rule in the style sheets
   */
  private record Rule(CssSelector selector, Map<String, String> declarations, int order) {}

  private final Map<String, List<Rule>> byKey = new HashMap<>();
  private int count;

  /** Adds the rules of a style sheet. */
  void add(String css) {
    addRules(withoutComments(css), true);
  }

  private static String withoutComments(String css) {
    StringBuilder rest = new StringBuilder();
    int start = 0;
    for (int begin = css.indexOf("/*"); begin >= 0; begin = css.indexOf("/*", start)) {
      rest.append(css, start, begin).append(' ');
      int end = css.indexOf("*/", begin + 2);
      start = end < 0 ? css.length() : end + 2;
    }
    return rest.append(css, start, css.length()).toString().replace("<!--", "").replace("-->", "");
  }

  private void addRules(String css, boolean isTopLevel) {
    int start = 0;
    while (start < css.length()) {
      int brace = css.indexOf('{', start);
      int semicolon = css.indexOf(';', start);
      boolean isStatement = css.charAt(start) == '@';
      if (Character.isWhitespace(css.charAt(start))) {
        start++;
      } else if (isStatement && semicolon >= 0 && (brace < 0 || semicolon < brace)) {
        start = semicolon + 1; // such as @import, which is not opened
      } else if (brace < 0) {
        return;
      } else {
        int end = closing(css, brace);
        addRule(css.substring(start, brace).strip(), css.substring(brace + 1, end), isTopLevel);
        start = end + 1;
      }
    }
  }

  /**
   * @param isTopLevel whether the rule is not inside another one
   */
  private void addRule(String head, String body, boolean isTopLevel) {
    if (!head.startsWith("@")) {
      addRule(head, declarations(body));
    } else if (isTopLevel && DRAWN_MEDIA.matcher(head).matches()) {
      addRules(body, false);
    }
  }

  /** The index of the brace that closes another one, or the end. */
  private static int closing(String css, int brace) {
    int depth = 0;
    for (int i = brace; i < css.length(); i++) {
      depth += css.charAt(i) == '{' ? 1 : css.charAt(i) == '}' ? -1 : 0;
      if (depth == 0) {
        return i;
      }
    }
    return css.length();
  }

  private void addRule(String head, Map<String, String> declarations) {
    for (String part : head.split(",")) {
      CssSelector.parse(part)
          .ifPresent(
              selector ->
                  byKey
                      .computeIfAbsent(selector.key(), key -> new ArrayList<>())
                      .add(new Rule(selector, declarations, count++)));
    }
  }

  /** Reads declarations such as {@code display: none; fill: #fff !important}. */
  static Map<String, String> declarations(String text) {
    Map<String, String> declarations = new HashMap<>();
    for (String declaration : text.split(";")) {
      int colon = declaration.indexOf(':');
      if (colon > 0) {
        String name = declaration.substring(0, colon).strip().toLowerCase(Locale.ROOT);
        String value = declaration.substring(colon + 1).strip();
        put(declarations, name, value);
      }
    }
    return declarations;
  }

  /** Puts a value, unless a value that is there is important and this one is not. */
  private static void put(Map<String, String> values, String name, String value) {
    String old = values.get(name);
    if (old == null || !isImportant(old) || isImportant(value)) {
      values.put(name, value);
    }
  }

  private static boolean isImportant(String value) {
    return value.toLowerCase(Locale.ROOT).replace(" ", "").endsWith(IMPORTANT);
  }

  /**
   * Returns an element's own values of properties: of its attributes, then of rules, then of its
   * {@code style}.
   *
   * @param properties the properties that may also be attributes
   */
  Map<String, String> values(SvgNode node, List<String> properties) {
    Map<String, String> values = new HashMap<>();
    properties.stream()
        .filter(node::has)
        .forEach(property -> values.put(property, node.text(property)));
    for (Rule rule : matching(node)) {
      rule.declarations().forEach((name, value) -> put(values, name, value));
    }
    declarations(node.text("style")).forEach((name, value) -> put(values, name, value));
    values.replaceAll((name, value) -> plain(value));
    return values;
  }

  private static String plain(String value) {
    int mark = value.lastIndexOf('!');
    return mark < 0 ? value : value.substring(0, mark).strip();
  }

  private List<Rule> matching(SvgNode node) {
    if (byKey.isEmpty()) {
      return List.of();
    }
    List<String> keys = new ArrayList<>(List.of("*", node.name(), "#" + node.text("id")));
    node.classes().stream().distinct().forEach(name -> keys.add("." + name));
    Deque<SvgNode> path = new ArrayDeque<>();
    for (SvgNode above = node; above != null; above = above.parent()) {
      path.addFirst(above);
    }
    List<SvgNode> fromRoot = List.copyOf(path);
    return keys.stream()
        .flatMap(key -> byKey.getOrDefault(key, List.of()).stream())
        .filter(rule -> rule.selector().matches(fromRoot))
        .sorted(
            Comparator.comparingInt((Rule rule) -> rule.selector().specificity())
                .thenComparingInt(Rule::order))
        .toList();
  }
}
