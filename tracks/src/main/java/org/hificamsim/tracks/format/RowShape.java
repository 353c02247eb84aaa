package org.hificamsim.tracks.format;

import java.util.Set;

/**
 * The form of the rows of a format.
 *
 * @param format the name of the format in messages
 * @param separators possible separators of columns
 * @param least least number of columns
 * @param most greatest number of columns
 */
record RowShape(String format, Set<Separator> separators, int least, int most) {
  /** Returns the shape of rows separated by blanks or tabs. */
  static RowShape blanks(String format, int least, int most) {
    return new RowShape(format, Set.of(Separator.BLANKS, Separator.TABS), least, most);
  }

  /** Compares the first row of a file. */
  FormatFit fit(FileStart start) {
    if (!start.isTable()) {
      return FormatFit.no("the file %s, %s has rows of numbers".formatted(start.look(), format));
    }
    if (!separators.contains(start.separator())) {
      return FormatFit.no(
          "columns are separated by %s, %s has %s"
              .formatted(
                  start.separator(),
                  format,
                  separators.contains(Separator.COMMAS) ? Separator.COMMAS : Separator.BLANKS));
    }
    if (start.columns() < least || start.columns() > most) {
      return FormatFit.no(
          "rows have %s columns, %s has %s"
              .formatted(start.columns(), format, least == most ? least : least + " to " + most));
    }
    return FormatFit.yes(start.look());
  }

  /** Compares the first row of a file, which has to consist of numbers. */
  FormatFit fitNumbers(FileStart start) {
    FormatFit fit = fit(start);
    return !fit.fits() || start.hasNumbers()
        ? fit
        : FormatFit.no(
            "the first row is not of numbers, %s has no names of columns".formatted(format));
  }
}
