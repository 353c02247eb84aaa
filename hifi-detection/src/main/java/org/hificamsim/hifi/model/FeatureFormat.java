package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/**
 * How one type of feature abstraction is spelt in JSON.
 *
 * @param type the text of its property {@code type}
 * @param of the class
 * @param reader makes one from its other properties
 * @param writer writes its other properties
 */
record FeatureFormat<F extends FeatureAbstraction>(
    String type, Class<F> of, Reader<F> reader, Writer<F> writer) {
  /** Reads the properties of one type; those that it does not ask for are refused. */
  interface Reader<F> {
    F read(JsonObject json);
  }

  /** Writes the properties that the reader of the same type asks for. */
  interface Writer<F> {
    void write(F f, JsonGenerator json) throws IOException;
  }

  void write(FeatureAbstraction f, JsonGenerator json) throws IOException {
    json.writeStringField("type", type);
    writer.write(of.cast(f), json);
  }
}
