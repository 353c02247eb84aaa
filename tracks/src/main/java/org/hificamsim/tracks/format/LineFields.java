package org.hificamsim.tracks.format;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.stream.IntStream;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Fields;

/** The fields of a line between separators. A field in double quotes may contain separators. */
final class LineFields implements Fields {
  private final Place line;
  private final int length;
  private final boolean hasDecimalCommas;
  private final List<String> texts = new ArrayList<>();
  private final List<Integer> starts = new ArrayList<>();

  /**
   * @param line the place where the line begins
   */
  LineFields(Place line, String text, Separator separator) {
    this.line = line;
    length = text.length();
    hasDecimalCommas = separator == Separator.SEMICOLONS;
    Matcher field = separator.field().matcher(text);
    while (field.find()) {
      texts.add(field.group(1) == null ? field.group().strip() : field.group(1));
      starts.add(field.start());
    }
  }

  @Override
  public int count() {
    return texts.size();
  }

  @Override
  public String text(int field) {
    return texts.get(field);
  }

  @Override
  public double value(int field) {
    String text = text(field);
    return Fields.value(hasDecimalCommas ? text.replace(',', '.') : text);
  }

  /** All texts. */
  List<String> texts() {
    return texts;
  }

  /** Whether all fields are numbers. */
  boolean areNumbers() {
    return IntStream.range(0, count()).noneMatch(i -> Double.isNaN(value(i)));
  }

  @Override
  public Place place(int field) {
    int start = field < count() ? starts.get(field) : length;
    return new Place(line.file(), line.line(), 1 + start);
  }
}
