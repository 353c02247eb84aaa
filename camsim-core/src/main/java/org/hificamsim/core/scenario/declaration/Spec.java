package org.hificamsim.core.scenario.declaration;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * The values of the properties that are declared for an element of scenario files, given by a file
 * or by code. A spec is immutable; {@code with} makes another one.
 *
 * @param <S> the object that is made of the element
 */
public class Spec<S> {
  private final Element<S> element;

  /** The values by the number of their property; null for a property without a value. */
  private final Object[] values;

  private final Map<String, String> extras;

  public Spec(Element<S> element, Object[] values, Map<String, String> extras) {
    this.element = element;
    this.values = values;
    this.extras = extras;
  }

  /** Creates the spec as an object of a subclass. */
  public Spec(Spec<S> spec) {
    this(spec.element, spec.values, spec.extras);
  }

  /** The values by the numbers of the properties; null for none. */
  public final Object[] values() {
    return values;
  }

  /** The value of a property; null for none. */
  @SuppressWarnings("unchecked") // only values of T are put there
  public final <T> T value(Property<S, T> property) {
    return (T) values[property.number()];
  }

  /** The value of a property, given or default; the property must have one. */
  public final <T> T get(Property<S, T> property) {
    return Objects.requireNonNull(value(property));
  }

  /** The value of a property; empty for none. */
  public final <T> Optional<T> find(Property<S, T> property) {
    return Optional.ofNullable(value(property));
  }

  /** The number of a property; empty for none. */
  public final OptionalDouble number(Property<S, Double> property) {
    Double value = value(property);
    return value == null ? OptionalDouble.empty() : OptionalDouble.of(value);
  }

  /** Returns the spec with another value of a property. */
  public final <T> S with(Property<S, T> property, T value) {
    return element.make(put(property, Objects.requireNonNull(value)));
  }

  /** Returns the spec with another number. */
  public final S with(Property<S, Double> property, double value) {
    return with(property, (Double) value);
  }

  /** Returns the spec with a value of a property, or without one if it is empty. */
  public final <T> S with(Property<S, T> property, Optional<T> value) {
    return element.make(put(property, value.orElse(null)));
  }

  /** Returns the spec without a value of a property. */
  public final S without(Property<S, ?> property) {
    return element.make(put(property, null));
  }

  /** Returns the values with another value of a property; null for none. */
  public final <T> Spec<S> put(Property<S, T> property, T value) {
    Object[] changed = values.clone();
    changed[property.number()] = value instanceof List<?> list ? List.copyOf(list) : value;
    return new Spec<>(element, changed, extras);
  }

  /** The unknown attributes of the element, kept for the writer. */
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
