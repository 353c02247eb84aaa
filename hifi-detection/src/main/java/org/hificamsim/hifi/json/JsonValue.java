package org.hificamsim.hifi.json;

import java.util.List;
import org.hificamsim.core.Place;

/** A value in a JSON file and where it stands. */
sealed interface JsonValue
    permits JsonObject, JsonValue.Items, JsonValue.Text, JsonValue.Numeral, JsonValue.Word {
  Place place();

  /** The value as an error line shows it. */
  String shown();

  /** A list. */
  record Items(Place place, List<JsonValue> values) implements JsonValue {
    @Override
    public String shown() {
      return "a list of " + values.size();
    }
  }

  /** A text. */
  record Text(Place place, String text) implements JsonValue {
    @Override
    public String shown() {
      return "'" + shortened(text) + "'";
    }
  }

  /** A number, NaN and the infinities among them. */
  record Numeral(Place place, double value, String text) implements JsonValue {
    @Override
    public String shown() {
      return shortened(text);
    }
  }

  /** True, false or null. */
  record Word(Place place, String shown) implements JsonValue {}

  /** The text, or its start where it is long. */
  static String shortened(String text) {
    return text.length() <= 60 ? text : text.substring(0, 60) + "...";
  }
}
