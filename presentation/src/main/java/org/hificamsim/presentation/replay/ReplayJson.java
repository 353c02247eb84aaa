package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.JsonSerializer;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.SerializerProvider;
import com.fasterxml.jackson.databind.module.SimpleModule;
import java.io.IOException;
import java.io.UncheckedIOException;
import org.hificamsim.core.obstacle.Obstacle;

/**
 * The JSON form of everything here: an object per record, its fields named as its components. NaN
 * is null.
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

  /** A setup, a frame or a move as JSON. */
  public static String of(Object value) {
    try {
      return MAPPER.writeValueAsString(value);
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  static ObjectMapper mapper() {
    return MAPPER;
  }

  /** How an obstacle is told from others: by the name of its element in scenarios. */
  @JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "kind")
  @JsonSubTypes({
    @JsonSubTypes.Type(value = Obstacle.Wall.class, name = "wall"),
    @JsonSubTypes.Type(value = Obstacle.Polygon.class, name = "polygon"),
    @JsonSubTypes.Type(value = Obstacle.Pillar.class, name = "pillar")
  })
  private interface ByKind {}

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
