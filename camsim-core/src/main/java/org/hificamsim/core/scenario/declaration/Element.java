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
 * Declares an element of scenario files: its attributes, the elements it may contain, and the
 * object that is made of it.
 *
 * @param <S> the object that is made of the element
 */
public final class Element<S> {
  private final String name;
  private final String doc;
  private final Class<S> type;
  private final Function<Spec<S>, S> make;

  /** The defaults of all properties of {@code S}, by number. */
  private final List<Object> defaults;

  private final List<Property<S, ?>> attributes = new ArrayList<>();
  private final List<Property<S, ?>> ignored = new ArrayList<>();
  private String content = "";

  private Element(
      String name, Class<S> type, Function<Spec<S>, S> make, List<Object> defaults, String doc) {
    this.name = name;
    this.doc = doc;
    this.type = type;
    this.make = make;
    this.defaults = defaults;
  }

  /**
   * Declares an element that is read as a spec.
   *
   * @param doc a description of the element, then a line of Markdown for each attribute: {@code
   *     name: meaning | what holds without it}; the latter if the attribute has no default
   */
  public static <S extends Spec<S>> Element<S> of(
      String name, Class<S> type, Function<Spec<S>, S> make, String doc) {
    return new Element<>(name, type, make, new ArrayList<>(), doc);
  }

  /** Declares an element that is read as a record; its properties are the record's components. */
  public static <R extends Record> Element<R> ofRecord(String name, Class<R> type, String doc) {
    return new Element<>(name, type, spec -> newRecord(type, spec), new ArrayList<>(), doc);
  }

  /** Declares an element whose reader makes the object. */
  public static <S> Element<S> of(String name, String doc) {
    return new Element<>(name, null, null, new ArrayList<>(), doc);
  }

  /** Declares another element that is read as the same object, with some attributes of this one. */
  public Element<S> like(String otherName, String otherDoc, List<Property<S, ?>> ownAttributes) {
    String rows = doc.substring(doc.indexOf('\n') + 1);
    Element<S> other = new Element<>(otherName, type, make, defaults, otherDoc + "\n" + rows);
    other.attributes.addAll(ownAttributes);
    other.ignored.addAll(ignored);
    return other;
  }

  /** Sets the elements that it may contain, in the notation of a DTD: {@code optics*, camera+}. */
  public Element<S> holds(String elements) {
    content = elements;
    return this;
  }

  /** Declares a required attribute. */
  public <T> Property<S, T> required(String attribute, Type<T> valueType) {
    return attribute(attribute, valueType, null).required();
  }

  /** Declares required attributes of one type. */
  public Element<S> requires(Type<?> valueType, String... names) {
    Arrays.stream(names).forEach(name -> required(name, valueType));
    return this;
  }

  /** Declares an optional attribute without a default. */
  public <T> Property<S, T> optional(String attribute, Type<T> valueType) {
    return attribute(attribute, valueType, null);
  }

  /**
   * Declares an attribute with a default, at which files omit it. New attributes are declared in
   * this way, so that files and run keys of scenarios without them stay the same.
   */
  public <T> Property<S, T> optional(String attribute, Type<T> valueType, T defaultValue) {
    return attribute(attribute, valueType, defaultValue).omittedAtDefault();
  }

  /** Declares an attribute with a default, which files always have. */
  public <T> Property<S, T> attribute(String attribute, Type<T> valueType, T defaultValue) {
    Property<S, T> property = new Property<>(defaults.size(), attribute, valueType, defaultValue);
    attributes.add(property);
    defaults.add(defaultValue);
    return property;
  }

  /** Declares an attribute that is ignored, but kept for the writer. */
  public Element<S> ignored(String attribute, Type<?> valueType) {
    ignored.add(new Property<>(-1, attribute, valueType, null));
    return this;
  }

  /** Declares a property that is not an attribute. */
  public <T> Property<S, T> property(T defaultValue) {
    defaults.add(defaultValue);
    return new Property<>(defaults.size() - 1, "", null, defaultValue);
  }

  /** The name of the element. */
  public String name() {
    return name;
  }

  /** The description of the element and its attributes. */
  public String doc() {
    return doc;
  }

  /** The elements that it may contain, in the notation of a DTD. */
  public String content() {
    return content;
  }

  /** The attributes, in the order in which they are written. */
  public List<Property<S, ?>> attributes() {
    return attributes;
  }

  /** The attributes that are ignored. */
  public List<Property<S, ?>> ignored() {
    return ignored;
  }

  /** Whether it has an attribute of this name. */
  public boolean has(String attribute) {
    return attributes.stream().anyMatch(property -> property.name().equals(attribute));
  }

  /** The attribute of this element for a property; the property itself if it has none. */
  public Property<S, ?> own(Property<S, ?> property) {
    return attributes.stream()
        .filter(attribute -> attribute.number() == property.number())
        .findFirst()
        .orElse(property);
  }

  /** The default of each property by number; null for none. */
  public Object[] defaults() {
    return defaults.toArray();
  }

  /** The spec of an element without attributes, which has the defaults. */
  public Spec<S> empty() {
    return new Spec<>(this, defaults(), Map.of());
  }

  /** The class of the object; null if the reader makes it. */
  public Class<S> type() {
    return type;
  }

  /** Makes the object of a spec. */
  public S make(Spec<S> spec) {
    return make.apply(spec);
  }

  private static <R extends Record> R newRecord(Class<R> type, Spec<R> spec) {
    try {
      Class<?>[] components =
          Arrays.stream(type.getRecordComponents())
              .map(RecordComponent::getType)
              .toArray(Class<?>[]::new);
      return type.getDeclaredConstructor(components).newInstance(spec.values());
    } catch (InvocationTargetException e) {
      throw e.getCause() instanceof RuntimeException fault ? fault : new IllegalStateException(e);
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
  }

  /** The spec from which an object was made. */
  @SuppressWarnings("unchecked") // a spec of this element
  public Spec<S> specOf(S object) {
    if (object instanceof Spec<?> spec) {
      return (Spec<S>) spec;
    }
    Object[] values = defaults();
    try {
      for (int i = 0; i < values.length; i++) {
        values[i] = type.getRecordComponents()[i].getAccessor().invoke(object);
      }
    } catch (ReflectiveOperationException e) {
      throw new IllegalStateException(e);
    }
    return new Spec<>(this, values, Map.of());
  }

  /** The attributes to write for a spec, in order. */
  public Map<String, String> written(Spec<S> spec) {
    Map<String, String> texts = new LinkedHashMap<>();
    for (Property<S, ?> attribute : attributes) {
      String text = attribute.text(spec);
      if (text != null) {
        texts.put(attribute.name(), text);
      }
    }
    texts.putAll(new TreeMap<>(spec.extras()));
    return texts;
  }
}
