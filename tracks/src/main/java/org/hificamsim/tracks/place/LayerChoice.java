package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.Collection;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Nearest;

/**
 * The parts of a drawing that are walls, chosen by layer, class, id or colour.
 *
 * @param names the chosen names, in any case; {@code *} stands for any characters; empty to choose
 *     everything
 * @param isForList whether shapes beyond the limit are counted, but not kept
 */
public record LayerChoice(List<String> names, boolean isForList) {
  /** The choice of everything. */
  public static final LayerChoice ALL = new LayerChoice(List.of());

  /** The choice of everything in a drawing of any size, to list its names only. */
  public static final LayerChoice FOR_LIST = new LayerChoice(List.of(), true);

  /** Chooses by names. */
  public LayerChoice(List<String> names) {
    this(names, false);
  }

  /** Copies the list. */
  public LayerChoice {
    names = List.copyOf(names);
  }

  /** Returns the names that choose a part with some labels. */
  Set<String> matching(Collection<Label> labels) {
    return names.stream()
        .filter(name -> labels.stream().anyMatch(label -> matches(name, label.name())))
        .collect(Collectors.toSet());
  }

  private static boolean matches(String name, String label) {
    if (!name.contains("*")) {
      return name.equalsIgnoreCase(label);
    }
    String pattern =
        Stream.of(name.split("\\*", -1)).map(Pattern::quote).collect(Collectors.joining(".*"));
    return Pattern.compile(pattern, Pattern.CASE_INSENSITIVE | Pattern.DOTALL)
        .matcher(label)
        .matches();
  }

  /**
   * Refuses names that chose nothing.
   *
   * @param used the names that chose a part
   * @param hidden the names of parts that are not drawn
   * @param known the names that the drawing has
   */
  void requireUsed(String file, Set<String> used, Set<String> hidden, Collection<String> known) {
    for (String name : names) {
      if (!used.contains(name)) {
        if (hidden.stream().anyMatch(label -> matches(name, label))) {
          throw InputException.of(
              "%s: %s is '%s', which is hidden, off or frozen, expected it shown in the drawing",
              file, setting("layers"), name);
        }
        throw known.isEmpty()
            ? InputException.of(
                "%s: %s is '%s', but nothing that is drawn has a layer, class, id or colour,"
                    + " expected none",
                file, setting("layers"), name)
            : InputException.of(
                "%s: %s is '%s', which nothing that is drawn has, expected one of %s (%s)",
                file, setting("layers"), name, Nearest.to(name, known), setting("list_layers"));
      }
    }
  }
}
