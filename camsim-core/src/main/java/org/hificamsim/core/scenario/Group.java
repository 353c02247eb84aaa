package org.hificamsim.core.scenario;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * Elements that a scenario has any number of, in an element that only holds them.
 *
 * @param <C> what each is read as
 * @param property where a scenario has them
 * @param holder the element that holds them
 * @param members the elements
 */
record Group<C>(
    Property<Scenario, List<C>> property,
    Element<Scenario> holder,
    List<Element<? extends C>> members) {
  /**
   * Declares them.
   *
   * @param doc what they are: one line of Markdown
   */
  static <C> Group<C> of(String holder, String doc, List<Element<? extends C>> members) {
    String any = members.stream().map(Element::name).collect(Collectors.joining(" | ", "(", ")*"));
    return new Group<>(
        Scenario.ELEMENT.property(List.of()),
        Element.<Scenario>of(holder, doc).holds(any),
        members);
  }

  /** The element of this name. */
  Optional<Element<? extends C>> named(String name) {
    return members.stream().filter(one -> one.name().equals(name)).findFirst();
  }
}
