package org.hificamsim.core.scenario.file;

import java.util.HashMap;
import java.util.Map;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Spec;
import org.hificamsim.core.scenario.declaration.Type;
import org.hificamsim.core.scenario.spec.EventHead;
import org.hificamsim.core.scenario.xml.XmlElement;

/**
 * Reads the attributes of an XML element by their declarations.
 *
 * <p>Every error is an {@link InputException} that names the place, the value and what was
 * expected.
 */
public final class Attributes<S> {
  private static final Predicate<String> XML_OWN =
      Pattern.compile("xmlns(:.*)?|xml:.*|xsi:.*").asMatchPredicate();

  private final XmlElement xml;
  private final Element<S> element;
  private final Map<String, Type<?>> narrowed = new HashMap<>(0);

  /** Prepares to read an element by its declaration. */
  public Attributes(XmlElement xml, Element<S> element) {
    this.xml = xml;
    this.element = element;
  }

  /** Expects a narrower type of an attribute than the declared one. */
  public Attributes<S> narrow(String attribute, Type<?> type) {
    narrowed.put(attribute, type);
    return this;
  }

  @SuppressWarnings("unchecked") // a narrower type has values of T
  private <T> Type<T> type(Property<S, T> attribute) {
    return (Type<T>) narrowed.getOrDefault(attribute.name(), attribute.type());
  }

  /** Reads an element that has only attributes, and warns about unknown ones. */
  public static <S> S read(XmlElement xml, Element<S> element) {
    Attributes<S> attributes = new Attributes<>(xml, element);
    S read = attributes.read();
    attributes.warnOfUnknown();
    return read;
  }

  /** Reads the object of the element. */
  public S read() {
    try {
      return element.make(spec());
    } catch (IllegalArgumentException e) { // the values do not fit together
      throw xml.place().error("<" + xml.name() + "> " + e.getMessage());
    }
  }

  /** Reads the spec of the element. */
  public Spec<S> spec() {
    return spec(Faults.thrown());
  }

  /** Reads the spec of the element; an attribute with a fault takes its default. */
  public Spec<S> spec(Faults faults) {
    Object[] values = element.defaults();
    for (Property<S, ?> attribute : element.attributes()) {
      faults.check(() -> values[attribute.number()] = get(attribute));
    }
    Map<String, String> extras =
        unknown()
            .filter(name -> !name.contains(":")) // a prefix belongs to other programs
            .collect(Collectors.toUnmodifiableMap(name -> name, xml.attributes()::get));
    return new Spec<>(element, values, extras);
  }

  /** The value of an attribute, or its default; null for neither. */
  public <T> T get(Property<S, T> attribute) {
    String text = xml.attributes().get(attribute.name());
    if (text == null) {
      return attribute.isRequired() ? require(attribute) : attribute.defaultValue();
    }
    try {
      return type(attribute).parser().apply(text);
    } catch (InputException e) {
      throw xml.place(attribute.name()).error("<" + xml.name() + "> " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw invalid(attribute, type(attribute).expected());
    }
  }

  /** The value of an attribute that is required here. */
  public <T> T require(Property<S, T> attribute) {
    if (!has(attribute)) {
      throw invalid(attribute, type(attribute).expected());
    }
    return get(attribute);
  }

  /** Refuses an attribute that is not allowed here. */
  public void refuse(Property<S, ?> attribute, String expected) {
    if (has(attribute)) {
      throw invalid(attribute, expected);
    }
  }

  /** Whether the file gives an attribute. */
  public boolean has(Property<S, ?> attribute) {
    return xml.attributes().containsKey(element.own(attribute).name());
  }

  /** The error about an invalid or missing attribute. */
  public InputException invalid(Property<S, ?> attribute, String expected) {
    return xml.invalid(element.own(attribute).name(), expected);
  }

  /** Warns about attributes that are not declared. */
  public void warnOfUnknown() {
    unknown()
        .filter(
            name -> element.ignored().stream().noneMatch(ignored -> ignored.name().equals(name)))
        .forEach(this::warnOfUnknown);
  }

  private void warnOfUnknown(String name) {
    String value = Place.shortened(xml.attributes().get(name));
    xml.warn(
        name, "unknown attribute %s=\"%s\" of <%s>, ignored".formatted(name, value, xml.name()));
  }

  private Stream<String> unknown() {
    return xml.attributes().keySet().stream()
        .filter(name -> !element.has(name) && !XML_OWN.test(name))
        .filter(name -> !isEvent() || !EventHead.ELEMENT.has(name));
  }

  private boolean isEvent() {
    return element.name().equals(EventHead.ELEMENT.name());
  }
}
