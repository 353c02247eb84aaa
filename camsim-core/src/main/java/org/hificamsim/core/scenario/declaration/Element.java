package org.hificamsim.core.scenario.declaration;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;

/**
 * An element of scenario files: its attributes, what may stand in it, and what it is read as.
 *
 * @param <S> what it is read as
 */
public final class Element<S> {
  private final String name;
  private final String doc;
  private final Class<S> type;
  private final Function<Spec<S>, S> make;
  private final List<Object> standards; // of all properties of what it is read as
  private final List<Property<S, ?>> attributes = new ArrayList<>();
  private final List<Property<S, ?>> ignored = new ArrayList<>();
  private String content = "";

  private Element(
      String name, Class<S> type, Function<Spec<S>, S> make, List<Object> standards, String doc) {
    this.name = name;
    this.doc = doc;
    this.type = type;
    this.make = make;
    this.standards = standards;
  }

  /**
   * An element that is read as a spec of its own.
   *
   * @param doc what it is, then a line of Markdown for each attribute: {@code name: what it says |
   *     what holds without it}, the latter where no default of the attribute's says it
   */
  public static <S extends Spec<S>> Element<S> of(
      String name, Class<S> type, Function<Spec<S>, S> make, String doc) {
    return new Element<>(name, type, make, new ArrayList<>(), doc);
  }

  /** An element that is read as a record: its properties are the components, in their order. */
  public static <R extends Record> Element<R> ofRecord(String name, Class<R> type, String doc) {
    return new Element<>(name, type, said -> made(type, said), new ArrayList<>(), doc);
  }

  /** An element whose reader makes something of what it says. */
  public static <S> Element<S> of(String name, String doc) {
    return new Element<>(name, null, null, new ArrayList<>(), doc);
  }

  /** Another element with attributes of this one, read as the same. */
  public Element<S> like(String otherName, String otherDoc, List<Property<S, ?>> its) {
    String rows = doc.substring(doc.indexOf('\n') + 1);
    Element<S> other = new Element<>(otherName, type, make, standards, otherDoc + "\n" + rows);
    other.attributes.addAll(its);
    other.ignored.addAll(ignored);
    return other;
  }

  /** What may stand in it, as a DTD says it: {@code optics*, zoom?, camera+}. */
  public Element<S> holds(String elements) {
    content = elements;
    return this;
  }

  /** An attribute that must be given. */
  public <T> Property<S, T> required(String attribute, Type<T> its) {
    return attribute(attribute, its, null).required();
  }

  /** Attributes of one type that must be given. */
  public Element<S> requires(Type<?> its, String... names) {
    Arrays.stream(names).forEach(one -> required(one, its));
    return this;
  }

  /** An attribute without a default. */
  public <T> Property<S, T> optional(String attribute, Type<T> its) {
    return attribute(attribute, its, null);
  }

  /** An attribute with a default. */
  public <T> Property<S, T> attribute(String attribute, Type<T> its, T standard) {
    Property<S, T> property = new Property<>(standards.size(), attribute, its, standard);
    attributes.add(property);
    standards.add(standard);
    return property;
  }

  /** An attribute that has no effect, and is kept for the writer. */
  public Element<S> ignored(String attribute, Type<?> its) {
    ignored.add(new Property<>(-1, attribute, its, null));
    return this;
  }

  /** Something that no attribute says. */
  public <T> Property<S, T> property(T standard) {
    standards.add(standard);
    return new Property<>(standards.size() - 1, "", null, standard);
  }

  public String name() {
    return name;
  }

  public String doc() {
    return doc;
  }

  public String content() {
    return content;
  }

  /** In the order in which they are written. */
  public List<Property<S, ?>> attributes() {
    return attributes;
  }

  public List<Property<S, ?>> ignored() {
    return ignored;
  }

  /** Whether it has an attribute of this name. */
  public boolean has(String attribute) {
    return attributes.stream().anyMatch(one -> one.name().equals(attribute));
  }

  /** Its attribute for a property; the property itself where it has none. */
  public Property<S, ?> own(Property<S, ?> property) {
    return attributes.stream()
        .filter(one -> one.number() == property.number())
        .findFirst()
        .orElse(property);
  }

  /** The default of each property; null for none. */
  public Object[] standards() {
    return standards.toArray();
  }

  /** The values of an element without any attribute: the defaults. */
  public Spec<S> empty() {
    return new Spec<>(this, standards(), Map.of());
  }

  public Class<S> type() {
    return type;
  }

  /** Makes the object from its values. */
  public S make(Spec<S> said) {
    return make.apply(said);
  }

  private static <R extends Record> R made(Class<R> type, Spec<R> said) {
    try {
      Class<?>[] components =
          Arrays.stream(type.getRecordComponents())
              .map(RecordComponent::getType)
              .toArray(Class<?>[]::new);
      return type.getDeclaredConstructor(components).newInstance(said.values());
    } catch (InvocationTargetException e) {
      throw e.getCause() instanceof RuntimeException fault ? fault : new IllegalStateException(e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  /** The values from which an object was made. */
  @SuppressWarnings("unchecked") // a spec of this element
  public Spec<S> said(S made) {
    if (made instanceof Spec<?> spec) {
      return (Spec<S>) spec;
    }
    Object[] values = standards();
    try {
      for (int i = 0; i < values.length; i++) {
        values[i] = type.getRecordComponents()[i].getAccessor().invoke(made);
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
    return new Spec<>(this, values, Map.of());
  }

  /** The attributes to write, in order. */
  public Map<String, String> written(Spec<S> said) {
    Map<String, String> texts = new LinkedHashMap<>();
    for (Property<S, ?> attribute : attributes) {
      String text = attribute.text(said);
      if (text != null) {
        texts.put(attribute.name(), text);
      }
    }
    texts.putAll(new TreeMap<>(said.extras()));
    return texts;
  }
}
