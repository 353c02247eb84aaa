package org.hificamsim.placement.cover;

import java.io.IOException;
import java.io.Writer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.file.TextLines;

/**
 * Set cover instances as files of whole numbers between blanks, of the two forms that OR-Library
 * has, numbered from 1. {@code scp}: the numbers of samples and candidates, all prices, then for
 * each sample how many candidates see it, and which. {@code candidates}, OR-Library's form of the
 * rail instances and that of camera placement by candidates: the two numbers, then for each
 * candidate its price, how many samples it sees, and which.
 */
public final class InstanceFile {
  /** How the numbers are ordered. */
  public enum Form {
    SCP,
    CANDIDATES
  }

  private static final int MOST = 10_000_000;

  private final TextLines lines;
  private int field;

  private InstanceFile(TextLines lines) {
    this.lines = lines;
  }

  /**
   * Reads an instance; each sample counts once.
   *
   * @throws org.hificamsim.core.InputException when it is missing or wrong, with its place
   */
  public static CoverInstance read(Path file, Form form) throws IOException {
    try (TextLines lines = TextLines.open(file)) {
      return new InstanceFile(lines).instance(form);
    }
  }

  private CoverInstance instance(Form form) {
    int samples = next("the number of samples", 1, MOST);
    int candidates = next("the number of candidates", 1, MOST);
    double[] prices = new double[candidates];
    List<List<Integer>> columns = new ArrayList<>();
    for (int j = 0; j < candidates; j++) {
      prices[j] = form == Form.SCP ? next("a price", 1, MOST) : 0;
      columns.add(new ArrayList<>());
    }
    for (int i = 0; i < (form == Form.SCP ? samples : candidates); i++) {
      if (form == Form.CANDIDATES) {
        prices[i] = next("a price", 1, MOST);
      }
      int count = next("a count", 0, form == Form.SCP ? candidates : samples);
      for (int n = 0; n < count; n++) {
        if (form == Form.SCP) {
          columns.get(next("a candidate", 1, candidates) - 1).add(i);
        } else {
          columns.get(i).add(next("a sample", 1, samples) - 1);
        }
      }
    }
    return CoverInstance.of(
        samples,
        columns.stream()
            .map(one -> one.stream().distinct().sorted().mapToInt(Integer::intValue).toArray())
            .toArray(int[][]::new),
        prices);
  }

  private int next(String what, int least, int most) {
    String expected = "%s, a whole number from %s to %s".formatted(what, least, most);
    while (field >= lines.count()) {
      if (!lines.nextFields()) {
        throw lines.place(0).error("the file ends, expected " + expected);
      }
      field = 0;
    }
    double value = lines.value(field);
    if (!(value == Math.rint(value) && value >= least && value <= most)) {
      throw lines.place(field).error("'%s', expected %s".formatted(lines.text(field), expected));
    }
    field++;
    return (int) value;
  }

  /** Writes an instance; prices are rounded. In {@code scp} what cannot be seen is left out. */
  public static void write(Writer out, CoverInstance instance, Form form) throws IOException {
    int[] needs = instance.coverable().needs();
    int[] samples =
        IntStream.range(0, needs.length)
            .filter(s -> form == Form.CANDIDATES || needs[s] > 0)
            .toArray();
    int[] numbers = new int[needs.length];
    IntStream.range(0, samples.length).forEach(i -> numbers[samples[i]] = i + 1);
    out.write(samples.length + " " + instance.candidates() + "\n");
    List<List<Integer>> seen = new ArrayList<>();
    IntStream.range(0, samples.length).forEach(any -> seen.add(new ArrayList<>()));
    for (int j = 0; j < instance.candidates(); j++) {
      int[] column =
          IntStream.of(instance.columns()[j]).map(s -> numbers[s]).filter(n -> n > 0).toArray();
      long price = Math.max(1, Math.round(instance.prices()[j]));
      if (form == Form.SCP) {
        out.write((j == 0 ? "" : " ") + price);
        for (int sample : column) {
          seen.get(sample - 1).add(j + 1);
        }
      } else {
        out.write(price + " " + column.length);
        for (int sample : column) {
          out.write(" " + sample);
        }
        out.write("\n");
      }
    }
    for (int i = 0; form == Form.SCP && i < samples.length; i++) {
      out.write("\n" + seen.get(i).size());
      for (int candidate : seen.get(i)) {
        out.write(" " + candidate);
      }
    }
    out.write(form == Form.SCP ? "\n" : "");
  }
}
