package org.hificamsim.core.scenario;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** An attribute that lists numbers between spaces, or counts them up: {@code from:to:step}. */
final class NumberList {
  private static final int MAX_NUMBERS = 1000;

  private final Attributes attributes;
  private final String name;
  private final Range range;

  NumberList(Attributes attributes, String name, Range range) {
    this.attributes = attributes;
    this.name = name;
    this.range = range;
  }

  /** The numbers in rising order, each once; at least one. */
  List<Double> sorted() {
    String text =
        attributes.optionalText(name).orElseThrow(() -> attributes.invalid(name, expected()));
    List<Double> numbers = numbers(text);
    if (numbers.isEmpty() || numbers.stream().distinct().count() < numbers.size()) {
      throw attributes.invalid(name, expected());
    }
    return numbers.stream().sorted().toList();
  }

  /** The same; a list of its own where the attribute is missing. */
  List<Double> rising(List<Double> standard) {
    return attributes.has(name) ? sorted() : standard;
  }

  private List<Double> numbers(String text) {
    List<Double> numbers = new ArrayList<>();
    for (String item : text.strip().split("\\s+")) {
      String[] parts = item.split(":", -1);
      if (parts.length == 3) {
        numbers.addAll(count(number(parts[0]), number(parts[1]), number(parts[2])));
      } else {
        numbers.add(number(item));
      }
    }
    return numbers;
  }

  private List<Double> count(double from, double to, double step) {
    double steps = (to - from) / step;
    if (!(step > 0 && steps >= 0 && steps < MAX_NUMBERS)) {
      throw attributes.invalid(name, expected());
    }
    int last = (int) Math.floor(steps + 1e-9);
    return IntStream.rangeClosed(0, last).mapToObj(i -> from + i * step).toList();
  }

  private double number(String text) {
    try {
      double value = Double.parseDouble(text);
      if (range.contains(value)) {
        return value;
      }
    } catch (NumberFormatException e) {
      // reported below
    }
    throw attributes.invalid(name, expected());
  }

  private String expected() {
    return "numbers between spaces, each once, or from:to:step; each " + range.expected();
  }
}
