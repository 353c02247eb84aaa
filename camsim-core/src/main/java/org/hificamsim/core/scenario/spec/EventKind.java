package org.hificamsim.core.scenario.spec;

import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import org.hificamsim.core.scenario.declaration.Element;
import org.hificamsim.core.scenario.declaration.Property;
import org.hificamsim.core.scenario.declaration.Spec;

/**
 * One kind of event, as scenario files have it.
 *
 * @param participant the participant to whom it happens, in the file's word
 * @param happening the kind of event, in the file's word
 * @param type the class of the event
 * @param body the further attributes of the event, with a description of what happens
 * @param make creates the event of a step and a body
 * @param of returns the body of an event
 */
public record EventKind<E extends ScenarioEvent, B>(
    String participant,
    String happening,
    Class<E> type,
    Element<B> body,
    BiFunction<Integer, Spec<B>, E> make,
    Function<E, Spec<B>> of) {
  /** A kind whose record has the step, and then the attributes of its body in their order. */
  static <E extends Record & ScenarioEvent> EventKind<E, E> of(
      String participant,
      String happening,
      Class<E> type,
      String doc,
      Consumer<Element<E>> attributes) {
    Element<E> body = Element.ofRecord("event", type, doc);
    Property<E, Integer> step = body.property(0);
    attributes.accept(body);
    return new EventKind<>(
        participant,
        happening,
        type,
        body,
        (number, spec) -> body.make(spec.put(step, number)),
        body::specOf);
  }

  /** The attributes to write of an event of this kind, in order. */
  public Map<String, String> written(ScenarioEvent event) {
    Map<String, String> all =
        EventHead.ELEMENT.written(
            EventHead.ELEMENT
                .empty()
                .put(EventHead.STEP, event.step())
                .put(EventHead.PARTICIPANT, participant)
                .put(EventHead.HAPPENING, happening));
    all.putAll(body.written(of.apply(type.cast(event))));
    return all;
  }
}
