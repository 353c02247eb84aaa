package org.hificamsim.core.scenario.declaration;

/**
 * Something that a spec may have a value of. Most are attributes of its element in scenario files:
 * what is declared of them is all there is, and reading, writing, the schema {@code
 * scenarios/camsim.xsd} and the tables of {@code docs/scenario-format.md} follow.
 *
 * @param <S> the spec
 * @param <T> the value
 */
public final class Property<S, T> {
  private final int number;
  private final String name;
  private final Type<T> type;
  private final T standard;
  private boolean required;
  private boolean quiet;

  /**
   * @param number among the properties of the spec, from 0
   * @param name of the attribute; empty for what is none
   * @param standard the value where nobody gives one; null for none
   */
  Property(int number, String name, Type<T> type, T standard) {
    this.number = number;
    this.name = name;
    this.type = type;
    this.standard = standard;
  }

  /** It must be given. */
  public Property<S, T> required() {
    required = true;
    return this;
  }

  /**
   * It is not written where it has its default: for a new attribute, so that files and run keys of
   * scenarios without it stay the same.
   */
  public Property<S, T> quiet() {
    quiet = true;
    return this;
  }

  /** The attribute of another element that says the same. */
  public Property<S, T> as(String otherName, T otherStandard) {
    return new Property<>(number, otherName, type, otherStandard);
  }

  public int number() {
    return number;
  }

  public String name() {
    return name;
  }

  public Type<T> type() {
    return type;
  }

  public T standard() {
    return standard;
  }

  public boolean isRequired() {
    return required;
  }

  @Override
  public String toString() {
    return name;
  }

  /** What is written for a spec; null for nothing. */
  public String text(Spec<S> spec) {
    T value = spec.value(this);
    return value == null || (quiet && value.equals(standard)) ? null : type.writer().apply(value);
  }
}
