package org.hificamsim.core.scenario.declaration;

/**
 * A property of a spec. Most properties are attributes of an element in scenario files; reading,
 * writing, the schema {@code scenarios/camsim.xsd} and the tables of {@code
 * docs/scenario-format.md} follow from their declarations.
 *
 * @param <S> the spec
 * @param <T> the value
 */
public final class Property<S, T> {
  private final int number;
  private final String name;
  private final Type<T> type;
  private final T defaultValue;
  private boolean required;
  private boolean omittedAtDefault;

  /**
   * @param number the number among the properties of the spec, from 0
   * @param name the name of the attribute; empty for a property that is not an attribute
   * @param defaultValue the default; null for none
   */
  Property(int number, String name, Type<T> type, T defaultValue) {
    this.number = number;
    this.name = name;
    this.type = type;
    this.defaultValue = defaultValue;
  }

  /** Makes the attribute required. */
  public Property<S, T> required() {
    required = true;
    return this;
  }

  /** Omits the attribute from files while it has its default. */
  public Property<S, T> omittedAtDefault() {
    omittedAtDefault = true;
    return this;
  }

  /** The attribute of another element for the same property. */
  public Property<S, T> as(String otherName, T otherDefault) {
    return new Property<>(number, otherName, type, otherDefault);
  }

  /** The number among the properties of the spec, from 0. */
  public int number() {
    return number;
  }

  /** The name of the attribute; empty for a property that is not an attribute. */
  public String name() {
    return name;
  }

  /** The type of the values. */
  public Type<T> type() {
    return type;
  }

  /** The default; null for none. */
  public T defaultValue() {
    return defaultValue;
  }

  /** Whether the attribute is required. */
  public boolean isRequired() {
    return required;
  }

  @Override
  public String toString() {
    return name;
  }

  /** The text to write for a spec; null to omit the attribute. */
  public String text(Spec<S> spec) {
    T value = spec.value(this);
    return value == null || (omittedAtDefault && value.equals(defaultValue))
        ? null
        : type.writer().apply(value);
  }
}
