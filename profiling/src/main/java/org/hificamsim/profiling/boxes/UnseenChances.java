package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.profiling.fit.Reliability;

/**
 * Chances of boxes that the fit has not seen, since parts of the boxes are left out in turn.
 *
 * @param parts the plural noun for the parts that are left out, for readers
 * @param boxes all boxes, in the order of the chances
 * @param chances for each form the chances of all boxes
 */
record UnseenChances(String parts, List<PersonBox> boxes, Map<FoundForm, double[]> chances) {
  private static final int TENTHS = 10;
  private static final List<FoundForm> ALL = List.of(FoundForm.values());

  /** Leaves out whole recordings; there have to be at least two. */
  static UnseenChances withoutRecordings(MeasuredBoxes measured) {
    return of("recordings", ALL, List.copyOf(byRecording(measured).values()));
  }

  /**
   * Leaves out tenths of the people, each from the whole time, to compare forms of the model: what
   * is left is nearly as much as the model is fitted on.
   */
  static UnseenChances withoutTenths(MeasuredBoxes measured) {
    List<List<PersonBox>> people =
        byRecording(measured).values().stream()
            .flatMap(recording -> byPerson(recording).stream())
            .toList();
    List<List<PersonBox>> tenths =
        Stream.<List<PersonBox>>generate(ArrayList::new)
            .limit(Math.min(TENTHS, people.size()))
            .toList();
    for (int i = 0; i < people.size(); i++) {
      tenths.get(i % tenths.size()).addAll(people.get(i));
    }
    return of("people", FoundForm.models(), tenths);
  }

  /**
   * Leaves out the people of the first half of each recording, and those of the second, by the
   * middle of their time.
   */
  static UnseenChances withoutPeople(MeasuredBoxes measured) {
    List<List<PersonBox>> halves = List.of(new ArrayList<>(), new ArrayList<>());
    for (List<PersonBox> recording : byRecording(measured).values()) {
      List<List<PersonBox>> people = byPerson(recording);
      for (int i = 0; i < people.size(); i++) {
        halves.get(2 * i < people.size() ? 0 : 1).addAll(people.get(i));
      }
    }
    if (halves.get(1).isEmpty()) {
      throw InputException.of(
          "%s has one person, expected two, to judge the fit by people that it has not seen",
          measured.boxes().get(0).recording());
    }
    return of("people", ALL, halves);
  }

  private static UnseenChances of(
      String parts, List<FoundForm> forms, List<List<PersonBox>> groups) {
    Map<FoundForm, double[]> chances = new EnumMap<>(FoundForm.class);
    for (FoundForm form : forms) {
      chances.put(form, chances(form, groups));
    }
    return new UnseenChances(parts, groups.stream().flatMap(List::stream).toList(), chances);
  }

  private static Map<String, List<PersonBox>> byRecording(MeasuredBoxes measured) {
    return measured.boxes().stream()
        .collect(
            Collectors.groupingBy(PersonBox::recording, LinkedHashMap::new, Collectors.toList()));
  }

  /** Returns the boxes of each person, by the middle of the person's time. */
  private static List<List<PersonBox>> byPerson(List<PersonBox> boxes) {
    return boxes.stream()
        .collect(Collectors.groupingBy(PersonBox::person, LinkedHashMap::new, Collectors.toList()))
        .values()
        .stream()
        .sorted(Comparator.comparingDouble(UnseenChances::middleFrame))
        .toList();
  }

  private static double[] chances(FoundForm form, List<List<PersonBox>> parts) {
    List<Double> chances = new ArrayList<>();
    for (List<PersonBox> part : parts) {
      List<PersonBox> others =
          parts.stream().filter(other -> other != part).flatMap(List::stream).toList();
      FoundCurve curve = FoundFit.fit(form, others);
      part.forEach(box -> chances.add(box.chance(curve)));
    }
    return chances.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static double middleFrame(List<PersonBox> person) {
    return (person.get(0).frame() + person.get(person.size() - 1).frame()) / 2.0;
  }

  /** Returns how well the chances of each form match what was found. */
  Map<FoundForm, Reliability> reliabilities() {
    double[] found = boxes.stream().mapToDouble(PersonBox::found).toArray();
    Map<FoundForm, Reliability> reliabilities = new EnumMap<>(FoundForm.class);
    chances.forEach((form, values) -> reliabilities.put(form, new Reliability(values, found)));
    return reliabilities;
  }

  /** Returns the mean log loss of each person. */
  double[] lossesByPerson(FoundForm form) {
    Map<String, List<Integer>> rows =
        IntStream.range(0, boxes.size())
            .boxed()
            .collect(
                Collectors.groupingBy(
                    row -> boxes.get(row).person(), LinkedHashMap::new, Collectors.toList()));
    return rows.values().stream().mapToDouble(own -> loss(form, own)).toArray();
  }

  private double loss(FoundForm form, List<Integer> rows) {
    return new Reliability(
            rows.stream().mapToDouble(row -> chances.get(form)[row]).toArray(),
            rows.stream().mapToDouble(row -> boxes.get(row).found()).toArray())
        .logLoss();
  }
}
