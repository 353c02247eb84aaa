package org.hificamsim.core.scenario.declaration;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What an element of a scenario file says, or code in its place: values of the properties that are
 * declared for it. It never changes; {@code with} makes another one.
 *
 * @param <S> what the element is read as
 */
public class Spec<S> {
  private final Element<S> element;
  private final Object[] values; // by the properties' numbers; null for none
  private final Map<String, String> extras;

  public Spec(Element<S> element, Object[] values, Map<String, String> extras) {
    this.element = element;
    this.values = values;
    this.extras = extras;
  }

  /** The same, for a class of its own. */
  public Spec(Spec<S> said) {
    this(said.element, said.values, said.extras);
  }

  /** By the properties' numbers; null for none. */
  public final Object[] values() {
    return values;
  }

  /** The value of a property; null where there is none. */
  @SuppressWarnings("unchecked") // nothing else is put there
  public final <T> T value(Property<S, T> property) {
    return (T) values[property.number()];
  }

  /** The value of a property that has one: what was given, or the default. */
  public final <T> T get(Property<S, T> property) {
    return Objects.requireNonNull(value(property));
  }

  /** The value of a property; empty where there is none. */
  public final <T> Optional<T> find(Property<S, T> property) {
    return Optional.ofNullable(value(property));
  }

  /** A number; empty where there is none. */
  public final OptionalDouble number(Property<S, Double> property) {
    Double value = value(property);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** The same with another value of a property. */
  public final <T> S with(Property<S, T> property, T value) {
    return element.make(put(property, Objects.requireNonNull(value)));
  }

  /** The same with another number. */
  public final S with(Property<S, Double> property, double value) {
    return with(property, (Double) value);
  }

  /** The same with a value of a property where there is one, else without. */
  public final <T> S with(Property<S, T> property, Optional<T> value) {
    return element.make(put(property, value.orElse(null)));
  }

  /** The same without a value of a property. */
  public final S without(Property<S, ?> property) {
    return element.make(put(property, null));
  }

  /** The same with another value of a property, or none: null. */
  public final <T> Spec<S> put(Property<S, T> property, T value) {
    Object[] changed = values.clone();
    changed[property.number()] = value instanceof List<?> list ? List.copyOf(list) : value;
    return new Spec<>(element, changed, extras);
  }

  /** Attributes of the element that nothing here reads, kept for the writer. */
  public final Map<String, String> extras() {
    return extras;
  }

  @Override
  public final boolean equals(Object other) {
    return other instanceof Spec<?> same
        && getClass() == same.getClass()
        && Arrays.equals(values, same.values)
        && extras.equals(same.extras);
  }

  @Override
  public final int hashCode() {
    return Arrays.hashCode(values);
  }

  @Override
  public final String toString() {
    return element.name() + Arrays.toString(values) + extras;
  }
}
