package org.hificamsim.solver.cover;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.file.TextLines;

/**
 * Reads and writes set cover instances as files of whole numbers between blanks, in the two forms
 * of OR-Library. The numbers of points and candidates come first; both are numbered from 1.
 * (Messages call points samples, as the command line does.)
 *
 * <p>The form {@code scp} continues with all prices, and then, for each point, the number of
 * candidates that cover it, and these candidates. The form {@code candidates}, which OR-Library
 * uses for the rail instances, continues with the price of each candidate, the number of points
 * that it covers, and these points.
 */
public final class InstanceFile {
  /** The order of the numbers in a file. */
  public enum Form {
    SCP,
    CANDIDATES
  }

  private static final int MAX_NUMBER = 10_000_000;

  private final TextLines lines;
  private int field;

  private InstanceFile(TextLines lines) {
    this.lines = lines;
  }

  /**
   * Reads an instance in which each point counts once.
   *
   * @throws org.hificamsim.core.InputException if the file is missing or wrong, with line and
   *     column
   */
  public static CoverInstance read(Path file, Form form) throws IOException {
    try (TextLines lines = TextLines.open(file)) {
      return new InstanceFile(lines).instance(form);
    }
  }

  private CoverInstance instance(Form form) {
    int points = nextNumber("the number of samples", 1, MAX_NUMBER);
    int candidates = nextNumber("the number of candidates", 1, MAX_NUMBER);
    double[] prices = new double[candidates];
    List<List<Integer>> covered = new ArrayList<>();
    for (int candidate = 0; candidate < candidates; candidate++) {
      covered.add(new ArrayList<>());
    }
    if (form == Form.SCP) {
      readByPoint(points, prices, covered);
    } else {
      readByCandidate(points, prices, covered);
    }
    return CoverInstance.of(
        points,
        covered.stream()
            .map(list -> list.stream().distinct().sorted().mapToInt(Integer::intValue).toArray())
            .toArray(int[][]::new),
        prices);
  }

  private void readByPoint(int points, double[] prices, List<List<Integer>> covered) {
    for (int candidate = 0; candidate < prices.length; candidate++) {
      prices[candidate] = nextNumber("a price", 1, MAX_NUMBER);
    }
    for (int point = 0; point < points; point++) {
      int count = nextNumber("a count", 0, prices.length);
      for (int i = 0; i < count; i++) {
        covered.get(nextNumber("a candidate", 1, prices.length) - 1).add(point);
      }
    }
  }

  private void readByCandidate(int points, double[] prices, List<List<Integer>> covered) {
    for (int candidate = 0; candidate < prices.length; candidate++) {
      prices[candidate] = nextNumber("a price", 1, MAX_NUMBER);
      int count = nextNumber("a count", 0, points);
      for (int i = 0; i < count; i++) {
        covered.get(candidate).add(nextNumber("a sample", 1, points) - 1);
      }
    }
  }

  private int nextNumber(String name, int least, int greatest) {
    String expected = "%s, a whole number from %s to %s".formatted(name, least, greatest);
    while (field >= lines.count()) {
      if (!lines.nextFields()) {
        throw lines.place(0).error("the file ends, expected " + expected);
      }
      field = 0;
    }
    double value = lines.value(field);
    if (!(value == Math.rint(value) && value >= least && value <= greatest)) {
      throw lines.place(field).error("'%s', expected %s".formatted(lines.text(field), expected));
    }
    field++;
    return (int) value;
  }

  /**
   * Writes an instance, with prices rounded to whole numbers. The form {@code scp} omits points
   * that no candidate covers.
   */
  public static void write(Writer out, CoverInstance instance, Form form) throws IOException {
    int[] numbers = numbers(instance, form);
    int points = Arrays.stream(numbers).max().orElse(0);
    out.write(points + " " + instance.candidates() + "\n");
    if (form == Form.SCP) {
      writeByPoint(out, instance, numbers, points);
    } else {
      writeByCandidate(out, instance, numbers);
    }
  }

  /** Returns by point its number in the file, from 1; 0 if it is omitted. */
  private static int[] numbers(CoverInstance instance, Form form) {
    int[] possibleNeeds = instance.coverable().needs();
    int[] numbers = new int[possibleNeeds.length];
    int count = 0;
    for (int point = 0; point < numbers.length; point++) {
      boolean written = form == Form.CANDIDATES || possibleNeeds[point] > 0;
      count += written ? 1 : 0;
      numbers[point] = written ? count : 0;
    }
    return numbers;
  }

  private static int[] coveredNumbers(CoverInstance instance, int candidate, int[] numbers) {
    return Arrays.stream(instance.covered()[candidate])
        .map(point -> numbers[point])
        .filter(number -> number > 0)
        .toArray();
  }

  private static long price(CoverInstance instance, int candidate) {
    return Math.max(1, Math.round(instance.prices()[candidate]));
  }

  private static void writeByCandidate(Writer out, CoverInstance instance, int[] numbers)
      throws IOException {
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      int[] covered = coveredNumbers(instance, candidate, numbers);
      out.write(price(instance, candidate) + " " + covered.length);
      for (int number : covered) {
        out.write(" " + number);
      }
      out.write("\n");
    }
  }

  private static void writeByPoint(Writer out, CoverInstance instance, int[] numbers, int points)
      throws IOException {
    List<List<Integer>> coveringCandidates = new ArrayList<>();
    for (int point = 0; point < points; point++) {
      coveringCandidates.add(new ArrayList<>());
    }
    for (int candidate = 0; candidate < instance.candidates(); candidate++) {
      out.write((candidate == 0 ? "" : " ") + price(instance, candidate));
      for (int number : coveredNumbers(instance, candidate, numbers)) {
        coveringCandidates.get(number - 1).add(candidate + 1);
      }
    }
    for (List<Integer> candidates : coveringCandidates) {
      out.write("\n" + candidates.size());
      for (int candidate : candidates) {
        out.write(" " + candidate);
      }
    }
    out.write("\n");
  }
}
