package org.hificamsim.cli;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;

/**
 * The progress of a run in one line of ASCII: how much is done, how fast, how long it will take at
 * the mean speed so far. On a narrow terminal the time left is the last to go; progressbar's own
 * line would lose it first.
 */
final class ProgressLine {
  private static final int MIN_BAR = 10;

  private final String task;
  private final String unit;
  private final long total;
  private final long already;

  /**
   * @param unit what is counted, as in {@code "steps"}
   * @param total 1 or more
   */
  ProgressLine(String task, String unit, long total) {
    this(task, unit, total, 0);
  }

  private ProgressLine(String task, String unit, long total, long already) {
    this.task = task;
    this.unit = unit;
    this.total = total;
    this.already = already;
  }

  /** The line of a run of which so many units were done before it began. */
  ProgressLine after(long units) {
    return new ProgressLine(task, unit, total, units);
  }

  /**
   * The line for a file or a pipe.
   *
   * @param elapsed nanoseconds, above 0
   */
  String plain(long done, long elapsed) {
    return "%s: %s (%s), %s, %s"
        .formatted(
            task, count(done), percent(done).strip(), speed(done, elapsed), left(done, elapsed));
  }

  /**
   * The line for a terminal, with a bar where there is room.
   *
   * @param elapsed nanoseconds, above 0
   * @param width columns; the line is no longer
   */
  String bar(long done, long elapsed, int width) {
    String head = task + " " + percent(done);
    String tail = speed(done, elapsed) + ", " + left(done, elapsed);
    for (String end : List.of(count(done) + ", " + tail, tail)) {
      int room = width - head.length() - end.length() - " [] ".length();
      if (room >= MIN_BAR) {
        int full = (int) (done * room / total);
        return head + " [" + "=".repeat(full) + " ".repeat(room - full) + "] " + end;
      }
    }
    String shortest = percent(done).strip() + ", " + left(done, elapsed);
    for (String text : List.of(head + " " + tail, percent(done).strip() + ", " + tail, shortest)) {
      if (text.length() <= width) {
        return text;
      }
    }
    return percent(done).strip();
  }

  private String count(long done) {
    return "%s of %s %s".formatted(done, total, unit);
  }

  private String percent(long done) {
    return String.format(Locale.ROOT, "%3d%%", 100 * done / total);
  }

  private String speed(long done, long elapsed) {
    double perSecond = perSecond(done, elapsed);
    return String.format(Locale.ROOT, perSecond < 10 ? "%.1f %s/s" : "%.0f %s/s", perSecond, unit);
  }

  private String left(long done, long elapsed) {
    if (done == already) {
      return "? left";
    }
    long seconds = (long) Math.ceil((total - done) / perSecond(done, elapsed));
    return String.format(
        Locale.ROOT, "%d:%02d:%02d left", seconds / 3600, seconds / 60 % 60, seconds % 60);
  }

  private double perSecond(long done, long elapsed) {
    return (done - already) * (double) TimeUnit.SECONDS.toNanos(1) / elapsed;
  }
}
