package org.hificamsim.data;

import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonMappingException;
import com.fasterxml.jackson.databind.exc.MismatchedInputException;
import com.fasterxml.jackson.databind.exc.UnrecognizedPropertyException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** A fault of a JSON file that is read into objects, in the words of its users. */
public final class JsonFault {
  private JsonFault() {}

  /**
   * Returns the fault with its line and column.
   *
   * @param expected what the whole file should be
   */
  public static InputException of(Path file, JsonProcessingException fault, String expected) {
    JsonLocation location = fault.getLocation();
    Place place =
        location == null
            ? new Place(file.toString(), 1, 1)
            : new Place(file.toString(), location.getLineNr(), location.getColumnNr());
    return new InputException(place.line(problem(fault) + ", expected " + expected), fault);
  }

  private static String problem(JsonProcessingException fault) {
    if (fault.getCause() instanceof InputException input) {
      return input.getMessage();
    }
    if (fault instanceof UnrecognizedPropertyException unknown) {
      return "unknown property " + path(unknown);
    }
    if (fault instanceof MismatchedInputException mismatch) {
      return path(mismatch) + " is not " + kind(mismatch.getTargetType());
    }
    return "no valid JSON (" + fault.getOriginalMessage().split("[:\n]", 2)[0] + ")";
  }

  /** The properties that lead to the value, such as {@code tasks.campus-v1.scores[0]}. */
  private static String path(JsonMappingException fault) {
    String path =
        fault.getPath().stream()
            .map(
                step ->
                    step.getFieldName() == null ? "[" + step.getIndex() + "]" : step.getFieldName())
            .collect(Collectors.joining("."))
            .replace(".[", "[");
    return path.isEmpty() ? "the file" : Place.printable(path);
  }

  private static String kind(Class<?> type) {
    if (type == null || type == boolean.class) {
      return "as it should be";
    }
    if (type.isPrimitive() || Number.class.isAssignableFrom(type)) {
      return "a number";
    }
    if (type.isArray() || Collection.class.isAssignableFrom(type)) {
      return "a list";
    }
    return type == String.class ? "a text" : "an object";
  }
}
