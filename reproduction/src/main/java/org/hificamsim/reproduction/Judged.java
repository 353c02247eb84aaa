package org.hificamsim.reproduction;

import java.util.Locale;
import org.hificamsim.runs.Estimate;

/** A cell of Table 8.1 or a statement of the text, compared with what we find. */
public sealed interface Judged permits Table81.Cell, Statement {
  /** A short name. */
  String id();

  /** Section, table or figure of the thesis. */
  String source();

  /** What it says. */
  String text();

  /** A cell's proportion; a statement's weakest margin. */
  Estimate value();

  /** How many comparisons decide it. */
  int checks();

  /** How many of them hold. */
  int held();

  /** Whether it is found again. */
  Verdict verdict();

  /** The reason for the verdict, in one line. */
  String reason();

  /** Whether the defaults were chosen for it. */
  FitRole role();

  /** A text with numbers, the same everywhere. */
  static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
