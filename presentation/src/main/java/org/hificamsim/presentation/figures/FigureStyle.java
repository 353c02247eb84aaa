package org.hificamsim.presentation.figures;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Color;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.data.JsonStream;
import org.hificamsim.presentation.plot.Palette;

/**
 * The words and colours that a user chose for policies and detections, in all pictures and the page
 * of a folder.
 *
 * @param labels for each name in files, the words that are shown; for other names, there are usual
 *     words
 * @param colors for each policy, its colour
 * @param palette the colours of all other policies, in their order
 */
public record FigureStyle(
    Map<String, String> labels, Map<String, Color> colors, List<Color> palette) {
  /** The name of the file with the style, in the folder of a comparison. */
  public static final String FILE = "style.json";

  /** The style of a user who chose nothing. */
  public static final FigureStyle DEFAULT = new FigureStyle(Map.of(), Map.of(), Palette.LINES);

  private static final Map<String, List<Color>> PALETTES =
      Map.of(
          "bright",
          Palette.LINES,
          "grey",
          List.of(new Color(0x111111), new Color(0x6B6B6B), new Color(0x9C9C9C)));

  private static final Pattern COLOR = Pattern.compile("#[0-9a-fA-F]{6}");

  /**
   * Returns a style in which the words and colours that a user asks for replace those of this
   * style.
   *
   * @param newPalette the name of a palette, or colours such as {@code #0072b2} with commas
   *     between; null for the colours of this style
   * @param newLabels texts in the form {@code name=Text}
   * @param names the names of policies and detections that may have a new label
   * @throws InputException if a palette, colour or name does not exist
   */
  public FigureStyle with(String newPalette, List<String> newLabels, Set<String> names) {
    Map<String, String> texts = new LinkedHashMap<>(labels);
    for (String label : newLabels) {
      String name =
          names.stream()
              .filter(known -> label.startsWith(known + "=") && label.length() > known.length() + 1)
              .findFirst()
              .orElseThrow(
                  () ->
                      InputException.of(
                          "%s is '%s', expected NAME=TEXT for one of %s",
                          setting("label"), label, String.join(", ", names)));
      texts.put(name, label.substring(name.length() + 1));
    }
    return newPalette == null
        ? new FigureStyle(texts, colors, palette)
        : new FigureStyle(texts, Map.of(), colors(newPalette));
  }

  private static List<Color> colors(String palette) {
    if (PALETTES.containsKey(palette)) {
      return PALETTES.get(palette);
    }
    List<String> parts = Arrays.asList(palette.split(",", -1));
    if (!parts.stream().allMatch(part -> COLOR.matcher(part).matches())) {
      throw InputException.of(
          "%s is '%s', expected bright, grey or colours such as #0072b2,#d55e00",
          setting("palette"), palette);
    }
    return parts.stream().map(Color::decode).toList();
  }

  /** Returns the words that people read for a policy or detection. */
  public String name(String spec) {
    return labels.getOrDefault(spec, SpokenNames.of(spec));
  }

  /**
   * Adds {@code style.json} to a folder's files, if the user chose anything.
   *
   * @param policies the policies whose colours are written
   */
  public void write(OutputFolder folder, List<String> policies) throws IOException {
    if (equals(DEFAULT)) {
      return;
    }
    ObjectNode json = new ObjectMapper().createObjectNode();
    json.putPOJO("labels", labels);
    PolicyColors assigned = new PolicyColors(policies, this);
    ObjectNode hex = json.putObject("colours");
    policies.forEach(policy -> hex.put(policy, Palette.hex(assigned.of(policy))));
    try (OutputStream out = folder.stream(FILE)) {
      out.write(new ObjectMapper().writerWithDefaultPrettyPrinter().writeValueAsBytes(json));
    }
  }

  /** Reads the style of a folder; returns the default if the folder has none. */
  public static FigureStyle ofFolder(Path folder) {
    Path file = folder.resolve(FILE);
    return Files.exists(file) ? read(file) : DEFAULT;
  }

  /**
   * Reads a file in the form that {@link #write} makes. Words and colours that it lacks are those
   * of the default style.
   *
   * @throws InputException with line and column, if it is not such a file
   */
  public static FigureStyle read(Path file) {
    Map<String, String> labels = new LinkedHashMap<>();
    Map<String, Color> colors = new LinkedHashMap<>();
    try (JsonStream json = JsonStream.open(file)) {
      json.next();
      json.object(
          "an object with labels and colours",
          property -> {
            switch (property) {
              case "labels" ->
                  json.object("texts by name", name -> labels.put(name, text(json, name)));
              case "colours" ->
                  json.object("colours by policy", name -> colors.put(name, color(json, name)));
              default -> throw json.error(property + " is unknown, expected labels or colours");
            }
          });
    }
    return new FigureStyle(labels, colors, Palette.LINES);
  }

  private static String text(JsonStream json, String name) {
    if (json.token() != JsonToken.VALUE_STRING || json.text().isBlank()) {
      throw json.invalid(name, "a text");
    }
    return json.text();
  }

  private static Color color(JsonStream json, String name) {
    if (json.token() != JsonToken.VALUE_STRING || !COLOR.matcher(json.text()).matches()) {
      throw json.invalid(name, "a colour such as #0072b2");
    }
    return Color.decode(json.text());
  }
}
