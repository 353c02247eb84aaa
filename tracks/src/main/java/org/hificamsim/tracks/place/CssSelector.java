package org.hificamsim.tracks.place;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A selector of CSS: types, classes, ids and attributes, joined as descendants or children
 * (Selectors Level 3, without siblings and pseudo-classes).
 */
final class CssSelector {
  private static final int MAX_LENGTH = 500;
  private static final String NAME = "[\\w\\-\\P{ASCII}]+";
  private static final Pattern COMPOUND =
      Pattern.compile(
          "\\s*(>?)\\s*(\\*|"
              + NAME
              + ")?((?:[.#]"
              + NAME
              + "|\\[\\s*[\\w:-]+\\s*(?:=\\s*(?:\"[^\"]*\"|'[^']*'|[\\w-]+)\\s*)?\\])*+)");
  private static final Pattern CONDITION =
      Pattern.compile(
          "([.#])("
              + NAME
              + ")|\\[\\s*([\\w:-]+)\\s*(?:=\\s*(?:\"([^\"]*)\"|'([^']*)'|([\\w-]+))\\s*)?\\]");

  /**
   * Conditions for one element.
   *
   * @param isChild whether the element of the compound before has to be its parent
   * @param type the element's name; "*" for any
   */
  private record Compound(boolean isChild, String type, List<Condition> conditions) {
    boolean matches(SvgNode node) {
      return (type.equals("*") || type.equals(node.name()))
          && conditions.stream().allMatch(condition -> condition.matches(node));
    }
  }

  /**
   * A class, an id or an attribute that an element needs.
   *
   * @param kind '.' for a class, '#' for an id, '[' for an attribute
   * @param value value of the attribute; null for any
   */
  private record Condition(char kind, String name, String value) {
    boolean matches(SvgNode node) {
      return switch (kind) {
        case '.' -> node.classes().contains(name);
        case '#' -> node.text("id").equals(name);
        default -> node.has(name) && (value == null || node.text(name).equals(value));
      };
    }
  }

  private final List<Compound> compounds;

  private CssSelector(List<Compound> compounds) {
    this.compounds = compounds;
  }

  /** Reads a selector; empty if it has anything else, so that its rule does not count. */
  static Optional<CssSelector> parse(String text) {
    List<Compound> compounds = new ArrayList<>();
    String stripped = text.strip();
    Matcher matcher = COMPOUND.matcher(stripped);
    int end = stripped.length() > MAX_LENGTH ? Integer.MAX_VALUE : 0;
    while (end < stripped.length()) {
      matcher.region(end, stripped.length());
      if (!matcher.lookingAt() || (matcher.group(2) == null && matcher.group(3).isEmpty())) {
        return Optional.empty();
      }
      compounds.add(
          new Compound(
              matcher.group(1).equals(">"),
              matcher.group(2) == null ? "*" : matcher.group(2),
              conditions(matcher.group(3))));
      end = matcher.end();
    }
    return compounds.isEmpty() ? Optional.empty() : Optional.of(new CssSelector(compounds));
  }

  private static List<Condition> conditions(String text) {
    List<Condition> conditions = new ArrayList<>();
    Matcher matcher = CONDITION.matcher(text);
    while (matcher.find()) {
      if (matcher.group(1) != null) {
        conditions.add(new Condition(matcher.group(1).charAt(0), matcher.group(2), null));
      } else {
        String value = matcher.group(4) != null ? matcher.group(4) : matcher.group(5);
        value = value != null ? value : matcher.group(6);
        conditions.add(new Condition('[', matcher.group(3), value));
      }
    }
    return conditions;
  }

  /** The class, id, type or "*" that an element needs; a class begins with '.', an id with '#'. */
  String key() {
    Compound last = compounds.get(compounds.size() - 1);
    return last.conditions().stream()
        .filter(condition -> condition.kind() != '[')
        .findFirst()
        .map(condition -> condition.kind() + condition.name())
        .orElse(last.type());
  }

  /**
   * Returns the specificity of the selector: it counts ids, then classes and attributes, then
   * types.
   */
  int specificity() {
    int total = 0;
    for (Compound compound : compounds) {
      total += compound.type().equals("*") ? 0 : 1;
      for (Condition condition : compound.conditions()) {
        total += condition.kind() == '#' ? 1_000_000 : 1_000;
      }
    }
    return total;
  }

  /**
   * Whether an element is selected.
   *
   * @param path the elements from the root to this one
   */
  boolean matches(List<SvgNode> path) {
    int count = compounds.size();
    boolean[] above = new boolean[count]; // whether the compounds up to here match at an ancestor
    boolean[] atParent = new boolean[count];
    for (SvgNode node : path) {
      boolean[] here = new boolean[count];
      for (int i = 0; i < count; i++) {
        Compound compound = compounds.get(i);
        boolean begins = i == 0 || (compound.isChild() ? atParent[i - 1] : above[i - 1]);
        here[i] = begins && compound.matches(node);
      }
      for (int i = 0; i < count; i++) {
        above[i] |= here[i];
      }
      atParent = here;
    }
    return atParent[count - 1];
  }
}
