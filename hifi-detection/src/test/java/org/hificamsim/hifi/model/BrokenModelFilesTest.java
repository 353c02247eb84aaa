package org.hificamsim.hifi.model;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Tests that errors in model files are reported in one line with place, value and expectation. */
class BrokenModelFilesTest {
  private static final String MODEL =
      """
      {
        "schema": "hificamsim-model",
        "version": 1,
        "name": "mine",
        "f": {"type": "linear", "z": -20, "q": -2, "d": 0.25, "intercept": 2.5},
        "g": {"slope": 0.5, "intercept": 0.03},
        "optics": {"sensorWidth": 0.0224, "longestFocalLength": 0.085},
        "threshold": 0.05,
        "units": {"q": "m", "d": "m", "z": "m"},
        "provenance": {"source": "a test"}
      }
      """;

  @TempDir Path folder;

  /** The replaced text, its replacement, and the place and words that the error must contain. */
  static Stream<Arguments> faults() {
    return Stream.of(
        arguments("\"hificamsim-model\"", "\"other\"", "2:13", "schema is 'other'"),
        arguments("  \"schema\": \"hificamsim-model\",\n", "", "1:1", "'schema' is missing"),
        arguments(
            "\"version\": 1", "\"version\": 5", "3:14", "version is 5, expected 1 or 2 or 3 or 4"),
        arguments("\"version\": 1", "\"version\": \"1\"", "3:14", "version is '1'"),
        arguments("\"version\": 1", "\"version\": 1.5", "3:14", "version is 1.5"),
        arguments("\"mine\"", "\"two words\"", "4:11", "name is 'two words'"),
        arguments("\"mine\"", "\"\"", "4:11", "name is ''"),
        arguments("\"mine\"", "\"a\\nb\"", "4:11", "name is 'a b'"),
        arguments("\"mine\"", "\"" + "x".repeat(5000) + "\"", "4:11", "xxx...'"),
        arguments("\"mine\"", "7", "4:11", "name is 7, expected a text"),
        arguments("\"linear\"", "\"cubic\"", "5:17", "expected one of linear, symbolic, power"),
        arguments("\"type\": \"linear\", ", "", "5:8", "'type' is missing"),
        arguments("\"z\": -20", "\"z\": NaN", "5:32", "z is NaN"),
        arguments("\"z\": -20", "\"z\": -Infinity", "5:32", "z is -Infinity"),
        arguments("\"z\": -20", "\"z\": 1e999", "5:32", "z is 1e999"),
        arguments(
            "\"z\": -20", "\"z\": 1e7", "5:32", "z is 1e7, expected a number from -1000000.0"),
        arguments("\"z\": -20", "\"z\": \"-20\"", "5:32", "z is '-20', expected a number"),
        arguments("\"z\": -20", "\"z\": null", "5:32", "z is null"),
        arguments("\"z\": -20", "\"z\": true", "5:32", "z is true"),
        arguments("\"z\": -20", "\"z\": [1, 2]", "5:32", "z is a list of 2"),
        arguments("\"z\": -20", "\"z\": {}", "5:32", "z is an object"),
        arguments("\"z\": -20", "\"z\": 0x14", "5:", "no valid JSON"),
        arguments("\"z\": -20", "\"z\": 020", "5:", "no valid JSON"),
        arguments("\"z\": -20", "\"z\": -20, \"z\": -20", "5:", "Duplicate field 'z'"),
        arguments("\"z\": -20, ", "", "5:8", "'z' is missing"),
        arguments("\"z\": -20", "\"Z\": -20", "5:8", "'z' is missing"),
        arguments("\"z\": -20", "\"z\": -20, \"y\": 1", "5:37", "unknown property 'y'"),
        arguments("\"linear\", ", "\"symbolic\", \"formula\": \"z+\", ", "5:40", "at character 3"),
        arguments("\"linear\"", "\"power\"", "5:8", "'c' is missing"),
        arguments("\"slope\": 0.5, ", "", "6:8", "'slope' is missing"),
        arguments("\"slope\": 0.5", "\"slope\": 1001", "6:18", "slope is 1001"),
        arguments("\"g\": {", "\"g\": {\"r2\": 1, ", "6:9", "unknown property 'r2'"),
        arguments("0.0224", "22.4", "7:29", "sensorWidth is 22.4"),
        arguments("0.085", "85", "7:59", "longestFocalLength is 85"),
        arguments("0.085", "0", "7:59", "longestFocalLength is 0,"),
        arguments("0.085", "-0.085", "7:59", "longestFocalLength is -0.085"),
        arguments("\"threshold\": 0.05", "\"threshold\": \"low\"", "8:16", "threshold is 'low'"),
        arguments(
            "\"threshold\"", "\"fitted\": {}, \"threshold\"", "8:3", "unknown property 'fitted'"),
        arguments("\"q\": \"m\"", "\"q\": \"mm\"", "9:18", "q is 'mm', expected one of m"),
        arguments("\"q\": \"m\", ", "", "9:12", "'q' is missing"),
        arguments("\"source\": \"a test\"", "\"" + "k".repeat(999) + "\": 5", "10:", "kkk... is 5"),
        arguments("\"a test\"", "5", "10:28", "source is 5, expected a text"),
        arguments("{\"source\": \"a test\"}", "[]", "10:17", "provenance is a list of 0"),
        arguments("\"threshold\"", "\"" + "k".repeat(9999) + "\"", "8:3", "unknown property 'kkk"),
        arguments("\"mine\"", "\"a\\u2028\\u001b[2Jb\"", "4:11", "name is 'a \\u001B[2Jb'"),
        arguments("\"z\": -20", "\"z\": " + "9".repeat(5000), "5:", "no valid JSON"),
        arguments("\"threshold\"", "\"treshold\"", "8:3", "unknown property 'treshold'"),
        arguments("\"a test\"}\n}", "\"a test\"}\n", "", "ends too early"),
        arguments("\"a test\"}\n}", "\"a te", "10:", "no valid JSON"),
        arguments("\"a test\"}\n}", "\"a test\"}\n} {}", "11:3", "after the end"),
        arguments("\"a test\"}\n}", "\"a test\"}\n} x", "11:", "no valid JSON"),
        arguments("\"name\": ", "name: ", "4:", "no valid JSON"),
        arguments("\"mine\",", "\"mine\"", "5:", "no valid JSON"),
        arguments("0.05,", "0.05,,", "8:", "no valid JSON"),
        arguments("\"name\"", "// a remark\n\"name\"", "4:", "no valid JSON"),
        arguments("-20", "[".repeat(100) + "]".repeat(100), "5:", "nesting depth"));
  }

  @ParameterizedTest
  @MethodSource("faults")
  void reportsErrorInOneLineWithItsPlace(String right, String wrong, String place, String words)
      throws IOException {
    assertTrue(MODEL.contains(right));
    String message = fault(MODEL.replace(right, wrong).getBytes(StandardCharsets.UTF_8));
    assertTrue(message.startsWith(folder.resolve("m.json") + ":" + place), message);
    assertTrue(message.contains(words), message);
  }

  @Test
  void rejectsFileWithoutAnObject() throws IOException {
    for (String text : new String[] {"", " \n ", "[]", "null", "17", "\"text\"", "{", "}", "nul"}) {
      fault(text.getBytes(StandardCharsets.UTF_8));
    }
  }

  @Test
  void rejectsBytesThatAreNotText() throws IOException {
    fault(new byte[] {0, 1, 2, 3});
    fault(MODEL.replace("a test", "\u00e9").getBytes(StandardCharsets.ISO_8859_1));
    fault(new byte[] {0, 0, (byte) 0xff, (byte) 0xfe, 1, 2, 3, 4});
    fault(new byte[] {0, 0, 0, 'x', 0, 0x77, 0, 0});
    fault(new byte[] {'x', 0, 0, 0, 1, 1, 1});
  }

  @Test
  void rejectsRandomBytes() throws IOException {
    Random random = new Random(1);
    byte[] bytes = new byte[64];
    for (int i = 0; i < 2000; i++) {
      random.nextBytes(bytes);
      Arrays.fill(bytes, 0, i % 4, (byte) 0); // how UTF-16 and UTF-32 start
      fault(bytes);
    }
  }

  /** Replaces each value of the model in turn by values of every other type. */
  @Test
  void rejectsValuesOfWrongType() throws IOException {
    Matcher value = Pattern.compile("(?<=: )(\"[^\"]*\"|-?[0-9.]+)").matcher(MODEL);
    String[] others = {
      "[]", "[[1]]", "{\"x\": {}}", "false", "nul", "NaN", "1e400", "'a'", "\"\\q\""
    };
    int refused = 0;
    while (value.find()) {
      for (String other : others) {
        StringBuilder broken = new StringBuilder(MODEL);
        broken.replace(value.start(), value.end(), other);
        fault(broken.toString().getBytes(StandardCharsets.UTF_8));
        refused++;
      }
    }
    assertEquals(17 * others.length, refused);
  }

  @Test
  void rejectsHugeFileWithoutReadingIt() throws IOException {
    byte[] spaces = " ".repeat(ModelFiles.MAX_BYTES + 1).getBytes(StandardCharsets.UTF_8);
    assertTrue(fault(spaces).contains("too big, expected at most 16777216 bytes"));
  }

  @Test
  void readsFileOfTheLargestSize() throws IOException {
    byte[] text = MODEL.getBytes(StandardCharsets.UTF_8);
    byte[] largest = Arrays.copyOf(text, ModelFiles.MAX_BYTES);
    Arrays.fill(largest, text.length, largest.length, (byte) ' ');
    assertEquals("mine", ModelFiles.read(Files.write(folder.resolve("m.json"), largest)).name());
  }

  @Test
  void rejectsEveryTruncation() throws IOException {
    byte[] whole = MODEL.strip().getBytes(StandardCharsets.UTF_8);
    for (int length = 0; length < whole.length; length++) {
      fault(Arrays.copyOf(whole, length));
    }
  }

  private String fault(byte[] bytes) throws IOException {
    Path file = Files.write(folder.resolve("m.json"), bytes);
    String message = assertThrows(InputException.class, () -> ModelFiles.read(file)).getMessage();
    assertTrue(message.matches("\\Q" + file + "\\E:\\d+:\\d+: .*"), message);
    assertEquals(1, message.lines().count(), message);
    assertTrue(message.length() < 600, message);
    assertTrue(message.contains(", expected "), message);
    return message;
  }
}
