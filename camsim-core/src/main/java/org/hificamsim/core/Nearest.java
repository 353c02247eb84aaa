package org.hificamsim.core;

import java.util.Collection;
import java.util.Comparator;
import java.util.stream.Collectors;

/** Suggests names for a misspelled one in messages. */
public final class Nearest {
  private static final int MAX_NAMES = 5;
  private static final int MAX_LENGTH = 100;

  private Nearest() {}

  /** Lists all names if they are few, else those most similar to the text. */
  public static String to(String text, Collection<String> names) {
    if (names.size() <= MAX_NAMES) {
      return String.join(", ", names);
    }
    String start = text.substring(0, Math.min(text.length(), MAX_LENGTH));
    return names.stream()
        .sorted(Comparator.comparingInt(name -> distance(start, name)))
        .limit(MAX_NAMES)
        .collect(Collectors.joining(", ", "", ", ... (%s in all)".formatted(names.size())));
  }

  private static int distance(String text, String name) {
    return !text.isEmpty() && name.contains(text) ? 0 : edits(text, name);
  }

  /** The number of insertions, deletions, replacements and swaps (optimal string alignment). */
  private static int edits(String a, String b) {
    int[][] edits = new int[a.length() + 1][b.length() + 1];
    for (int i = 0; i <= a.length(); i++) {
      for (int j = 0; j <= b.length(); j++) {
        edits[i][j] = i == 0 || j == 0 ? i + j : edits(a, i, b, j, edits);
      }
    }
    return edits[a.length()][b.length()];
  }

  private static int edits(String a, int i, String b, int j, int[][] edits) {
    int replaced = edits[i - 1][j - 1] + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
    int least = Math.min(replaced, 1 + Math.min(edits[i - 1][j], edits[i][j - 1]));
    boolean swapped =
        i > 1 && j > 1 && a.charAt(i - 1) == b.charAt(j - 2) && a.charAt(i - 2) == b.charAt(j - 1);
    return swapped ? Math.min(least, 1 + edits[i - 2][j - 2]) : least;
  }
}
