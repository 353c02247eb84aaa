package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonInclude;
import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.databind.DeserializationContext;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.annotation.JsonDeserialize;
import com.fasterxml.jackson.databind.deser.std.StdDeserializer;
import com.fasterxml.jackson.databind.module.SimpleModule;
import java.io.IOException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * Converts the records of this package to JSON. A record becomes an object with its components as
 * fields; NaN becomes null.
 */
public final class ReplayJson {
  private static final ObjectMapper MAPPER =
      new ObjectMapper()
          .addMixIn(Obstacle.class, ByKind.class)
          .registerModule(new SimpleModule().addSerializer(double[].class, new NaNAsNull()))
          .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES)
          .enable(DeserializationFeature.FAIL_ON_TRAILING_TOKENS);

  private ReplayJson() {}

  /** Writes a setup, a frame, a move or another record. */
  public static String of(Object value) {
    return Io.get(() -> MAPPER.writeValueAsString(value));
  }

  static ObjectMapper mapper() {
    return MAPPER;
  }

  /** Adds the kind of an obstacle, which is the name of its element in scenarios. */
  @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "kind")
  @JsonSubTypes({
    @JsonSubTypes.Type(value = Obstacle.Wall.class, name = "wall"),
    @JsonSubTypes.Type(value = Obstacle.Polygon.class, name = "polygon"),
    @JsonSubTypes.Type(value = Obstacle.Pillar.class, name = "pillar")
  })
  @SuppressWarnings("UnusedMethod") // Jackson reads the annotations of a mix-in
  private interface ByKind {
    @JsonInclude(value = JsonInclude.Include.CUSTOM, valueFilter = Ground.class)
    @JsonDeserialize(using = Ground.class)
    double base();

    @JsonInclude(value = JsonInclude.Include.CUSTOM, valueFilter = Endless.class)
    @JsonDeserialize(using = Endless.class)
    double height();
  }

  /** Omits a number that has its default value, and reads an omitted number as this value. */
  private abstract static class OmittedDefault extends StdDeserializer<Double> {
    private final double defaultValue;

    OmittedDefault(double defaultValue) {
      super(Double.class);
      this.defaultValue = defaultValue;
    }

    @Override
    public Double deserialize(JsonParser json, DeserializationContext context) throws IOException {
      return json.getDoubleValue();
    }

    @Override
    public Object getAbsentValue(DeserializationContext context) {
      return defaultValue;
    }

    @Override
    public boolean equals(Object value) {
      return value instanceof Double number && number == defaultValue;
    }

    @Override
    public int hashCode() {
      return Double.hashCode(defaultValue);
    }
  }

  private static final class Ground extends OmittedDefault {
    Ground() {
      super(0);
    }
  }

  private static final class Endless extends OmittedDefault {
    Endless() {
      super(Double.POSITIVE_INFINITY);
    }
  }

  private static final class NaNAsNull extends JsonSerializer<double[]> {
    @Override
    public void serialize(double[] values, JsonGenerator json, SerializerProvider provider)
        throws IOException {
      json.writeStartArray();
      for (double value : values) {
        if (Double.isNaN(value)) {
          json.writeNull();
        } else {
          json.writeNumber(value);
        }
      }
      json.writeEndArray();
    }
  }
}
