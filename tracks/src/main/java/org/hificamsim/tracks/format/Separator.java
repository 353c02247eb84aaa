package org.hificamsim.tracks.format;

import java.util.Locale;
import java.util.regex.Pattern;

/** The separator of the columns of a table. */
enum Separator {
  COMMAS(','),
  SEMICOLONS(';'),
  TABS('\t'),
  BLANKS(' ');

  private final char character;
  private final Pattern field;

  Separator(char character) {
    this.character = character;
    field =
        character == ' '
            ? Pattern.compile("\"([^\"]*)\"|[^\\s\"]\\S*|\"")
            : Pattern.compile(
                "(?<=^|%1$c)(?:\\s*\"([^\"]*)\"\\s*(?=%1$c|$)|[^%1$c]*)".formatted(character));
  }

  /** Returns the separator of a line: the most frequent one, and blanks if it has no other. */
  static Separator of(String line) {
    Separator best = BLANKS;
    long most = 0;
    for (Separator separator : new Separator[] {COMMAS, SEMICOLONS, TABS}) {
      long count = line.chars().filter(letter -> letter == separator.character).count();
      best = count > most ? separator : best;
      most = Math.max(most, count);
    }
    return best;
  }

  /** Matches a field; group 1 is the text within its quotes. */
  Pattern field() {
    return field;
  }

  char character() {
    return character;
  }

  /** Whether formats that separate columns by blanks use this separator. */
  boolean isBlank() {
    return this == BLANKS || this == TABS;
  }

  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
