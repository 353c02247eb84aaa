package org.hificamsim.data;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.InputException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests that faults of JSON are described in words that users understand. */
class JsonFaultTest {
  private record Part(String name, List<Double> numbers, Map<String, Part> parts) {
    Part {
      if ("bad".equals(name)) {
        throw new InputException("the name is 'bad'");
      }
    }
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "{\"numbers\": [1, \"x\"]} | 1:17: numbers[1] is not a number",
        "{\"numbers\": 1} | 1:13: numbers is not a list",
        "{\"name\": []} | 1:10: name is not a text",
        "{\"parts\": {\"a\": {\"numbers\": [true]}}} | 1:30: parts.a.numbers[0] is not a number",
        "{\"parts\": [1]} | 1:11: parts is not an object",
        "{\"other\": 1} | 1:13: unknown property other",
        "{\"name\": \"bad\"} | 1:15: the name is 'bad'",
        "{\"numbers\": [NaN]} | 1:17: no valid JSON (Non-standard token 'NaN')",
        "[] | 1:1: the file is not an object",
      })
  void namesPropertyAndPlace(String text, String fault) {
    JsonProcessingException thrown =
        assertThrows(
            JsonProcessingException.class, () -> new ObjectMapper().readValue(text, Part.class));
    assertEquals(
        "part.json:" + fault + ", expected a part",
        JsonFault.of(Path.of("part.json"), thrown, "a part").getMessage());
  }
}
