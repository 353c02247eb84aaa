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
 * The attributes of one element of a file, read as they are declared.
 *
 * <p>What is wrong is an {@link InputException} that names the place, the value and what was
 * expected.
 */
public final class Attributes<S> {
  private static final Predicate<String> XML_OWN =
      Pattern.compile("xmlns(:.*)?|xml:.*|xsi:.*").asMatchPredicate();

  private final XmlElement xml;
  private final Element<S> element;
  private final Map<String, Type<?>> narrowed = new HashMap<>(0);

  public Attributes(XmlElement xml, Element<S> element) {
    this.xml = xml;
    this.element = element;
  }

  /** Expects a narrower type of an attribute than what is declared. */
  public Attributes<S> narrow(String attribute, Type<?> type) {
    narrowed.put(attribute, type);
    return this;
  }

  @SuppressWarnings("unchecked") // a narrower one of the same values
  private <T> Type<T> type(Property<S, T> attribute) {
    return (Type<T>) narrowed.getOrDefault(attribute.name(), attribute.type());
  }

  /** What an element is read as that has nothing but its attributes; warns of unknown ones. */
  public static <S> S read(XmlElement xml, Element<S> element) {
    Attributes<S> attributes = new Attributes<>(xml, element);
    S read = attributes.read();
    attributes.warnOfUnknown();
    return read;
  }

  /** What the element is read as. */
  public S read() {
    try {
      return element.make(said());
    } catch (IllegalArgumentException e) { // of the whole, not of one attribute
      throw xml.place().error("<" + xml.name() + "> " + e.getMessage());
    }
  }

  /** What the element says. */
  public Spec<S> said() {
    return said(Faults.thrown());
  }

  /** What the element says; an attribute that has a fault takes its default. */
  public Spec<S> said(Faults faults) {
    Object[] values = element.standards();
    for (Property<S, ?> attribute : element.attributes()) {
      faults.check(() -> values[attribute.number()] = get(attribute));
    }
    Map<String, String> extras =
        unknown()
            .filter(name -> !name.contains(":")) // a prefix belongs to others
            .collect(Collectors.toUnmodifiableMap(name -> name, xml.attributes()::get));
    return new Spec<>(element, values, extras);
  }

  /** The value of an attribute, or its default; null where it has neither. */
  public <T> T get(Property<S, T> attribute) {
    String text = xml.attributes().get(attribute.name());
    if (text == null) {
      return attribute.isRequired() ? require(attribute) : attribute.standard();
    }
    try {
      return type(attribute).parser().apply(text);
    } catch (InputException e) {
      throw xml.place(attribute.name()).error("<" + xml.name() + "> " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw invalid(attribute, type(attribute).expected());
    }
  }

  /** The value of an attribute that must be given here. */
  public <T> T require(Property<S, T> attribute) {
    if (!has(attribute)) {
      throw invalid(attribute, type(attribute).expected());
    }
    return get(attribute);
  }

  /** An error where the file gives an attribute that has no place here. */
  public void refuse(Property<S, ?> attribute, String expected) {
    if (has(attribute)) {
      throw invalid(attribute, expected);
    }
  }

  /** Whether the file gives an attribute. */
  public boolean has(Property<S, ?> attribute) {
    return xml.attributes().containsKey(element.own(attribute).name());
  }

  /** An error about one attribute's value, or that it has none. */
  public InputException invalid(Property<S, ?> attribute, String expected) {
    return xml.invalid(element.own(attribute).name(), expected);
  }

  /** Warns of attributes that are not declared, with their places. */
  public void warnOfUnknown() {
    unknown()
        .filter(name -> element.ignored().stream().noneMatch(one -> one.name().equals(name)))
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
